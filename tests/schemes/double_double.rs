//! Laws, schemes and studies with numbers of 31 digits.

use approx::relative_eq;
use dmech::extend::Real;
use dmech::models::{Anharmonic, DampedPendulum, DrivenPendulum, HenonHeiles, Kepler, Morse, Pendulum, Wall};
use dmech::prelude::*;
use dmech::{StudyError, StudyReport};

type Wide = DoubleDouble;

fn wide<const D: usize>(state: State<D>) -> State<D, Wide> {
    State::of(state.q.map(Wide::from), state.v.map(Wide::from)).at_time(state.t)
}

/// m v²/2 + Φ.
fn energy<L: Potential<D, Wide>, const D: usize>(law: &L, state: &State<D, Wide>) -> Wide {
    state.v.iter().fold(law.potential(state.q), |sum, &v| sum + Wide::from(0.5) * v * v)
}

/// The energy of `DiscreteGradient` moves by rounding alone, and Newton needs no path to its root.
#[test]
fn the_energy_is_kept_to_30_digits() {
    fn check<L, const D: usize>(law: L, start: State<D>, dt: f64)
    where
        L: Law<D, Wide> + Potential<D, Wide> + Copy,
    {
        let start = wide(start);
        let run = Simulation::new(law, start).scheme(DiscreteGradient).dt(dt).run(3000).unwrap();
        let first = energy(&law, &start);
        let drift = run.states().iter().map(|state| ((energy(&law, state) - first) / first).to_f64().abs());
        let worst = drift.fold(0.0, f64::max);
        assert!(worst < 1e-30 && worst > 0.0, "{worst:e}");
        // The report tells it too.
        let told = run.drift(Invariant::Energy).unwrap().max_relative();
        assert!(relative_eq!(told, worst, max_relative = 0.2), "{told:e} {worst:e}");
        let steps = run.report().steps();
        assert!(run.report().evaluations() <= 3 * steps, "{} in {steps}", run.report().evaluations());
        // It is a scheme of order two: what is kept is not kept by accuracy.
        let half = Simulation::new(law, start).scheme(DiscreteGradient).dt(0.5 * dt).run(6000).unwrap();
        assert!((run.last().q[0] - half.last().q[0]).to_f64().abs() > 1e-6);
    }
    check(Kepler { gm: 1.3 }, State::new([0.5, 0.1], [0.2, 1.63]), 0.02);
    check(HenonHeiles { lambda: 0.9 }, State::new([0.05, 0.1], [0.39, 0.08]), 0.05);
    check(Anharmonic::default(), State::new([0.8, -0.5, 0.3], [0.2, 0.4, -0.6]), 0.03);
    check(Morse::default(), State::new([1.2], [0.4]), 0.02);
    check(Pendulum { k: 1.3 }, State::new([2.1], [0.4]), 0.05);
}

/// Composed schemes of the default coefficients converge at their order far below what `f64` can tell.
#[test]
fn the_orders_show_down_to_25_digits() {
    fn check<S: Scheme<Particle<Kepler, 2, Wide>> + Copy>(scheme: S, powers: core::ops::Range<u32>, reached: f64) {
        let start = wide(State::new([0.5, 0.1], [0.2, 1.63]));
        let end = |k: u32| {
            let n = 1_u32 << k;
            let run = Simulation::new(Kepler { gm: 1.3 }, start).scheme(scheme).dt(1.0 / f64::from(n)).run(n.into());
            run.unwrap().last().q
        };
        let ends: Vec<_> = powers.map(end).collect();
        let apart = |pair: &[[Wide; 2]]| (pair[0][0] - pair[1][0]).abs().max((pair[0][1] - pair[1][1]).abs()).to_f64();
        let changes: Vec<_> = ends.windows(2).map(apart).collect();
        let orders: Vec<_> = changes.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect();
        let declared = f64::from(S::ORDER);
        assert!(orders.iter().all(|order| (order - declared).abs() < 0.1), "{}: {orders:?} {changes:?}", S::NAME);
        assert!(changes[changes.len() - 1] < reached, "{}: {changes:?}", S::NAME);
    }
    check(Composed::order8(Leapfrog), 6..11, 1e-22);
    check(Composed::order8(DiscreteGradient), 7..12, 1e-25);
    check(Composed::order6(Implicit), 6..11, 1e-17);
    check(Composed::order4(Leapfrog), 9..13, 1e-13);
}

/// An ellipse closes after 2π √(a³/gm). The time of whole steps misses that by the rounding of the step, which the velocity
/// makes good.
#[test]
fn an_ellipse_closes_to_24_digits() {
    let (law, start) = (Kepler { gm: 1.3 }, wide(State::new([0.5, 0.1], [0.2, 1.63])));
    let two = Wide::from(2.0);
    let half_axis = -Wide::from(law.gm) / (two * energy(&law, &start));
    let pi = Wide::ZERO.atan2(-Wide::ONE);
    let period = two * pi * (half_axis.powi(3) / Wide::from(law.gm)).sqrt();
    let n = 6000_u32;
    let dt = period.to_f64() / f64::from(n);
    let late = Wide::from(f64::from(n)) * Wide::from(dt) - period;
    let run = Simulation::new(law, start).scheme(Composed::order8(DiscreteGradient)).dt(dt).run(n.into()).unwrap();
    let last = run.last();
    for i in 0..2 {
        let error = (last.q[i] - late * last.v[i] - start.q[i]).to_f64().abs();
        assert!(error < 1e-24, "{error:e}");
    }
    assert!(late.to_f64() != 0.0);
}

fn errors(report: &StudyReport) -> Vec<f64> {
    report.rows().iter().map(|row| row.result().unwrap().error()).collect()
}

/// The two references of a study agree to the accuracy of the worse of them, whatever kind of law it is.
#[test]
fn both_references_are_of_the_same_motion() {
    fn check<L, const D: usize>(law: L, start: State<D>, end: f64, mass: f64, scheme: &str)
    where
        L: Law<D> + Law<D, Wide> + Copy,
    {
        let study = || Study::new(law, start, end).mass(mass).scheme(Implicit).ladder([0.05, 0.01]).repetitions(1);
        let (computed, precise) = (study().run().unwrap(), study().precise().run().unwrap());
        let reference = precise.reference().unwrap();
        assert!(reference.is_precise() && reference.error() < 1e-17 && reference.scheme().contains(scheme));
        assert!(precise.resolution() < 2e-15 && precise.resolution() > reference.error());
        for (a, b) in errors(&computed).iter().zip(errors(&precise)) {
            assert!(*a > 1e-9 && (a - b).abs() <= computed.resolution() + 1e-14, "{a:e} {b:e} {computed}");
        }
        let table = precise.to_string();
        assert!(
            table.contains("a tolerance 1000 times smaller") && table.lines().all(|line| line.chars().count() <= 100)
        );
    }
    check(HenonHeiles { lambda: 0.9 }, State::new([0.05, 0.1], [0.39, 0.08]), 13.0, 1.0, "leap-frog");
    check(Kepler { gm: 1.3 }, State::new([0.5, 0.1], [0.2, 1.63]), 3.1, 1.0, "leap-frog");
    check(DampedPendulum::default(), State::new([0.8], [0.3]).at_time(0.7), 9.0, 1.9, "midpoint");
    check(DrivenPendulum::default(), State::new([0.8], [0.3]).at_time(0.7), 9.0, 1.2, "midpoint");
}

/// The time has fewer digits there than the smallest tolerances ask for.
#[test]
fn a_law_that_names_the_time_is_followed_far_from_0() {
    for t in [3e3, -1e6] {
        let start = State::new([0.8], [0.3]).at_time(t);
        let study = Study::new(DrivenPendulum::default(), start, t + 9.0).mass(1.2).repetitions(1);
        let report = study.scheme(Gauss::order16()).ladder([0.3]).precise().run().unwrap();
        let reference = report.reference().unwrap();
        assert!(reference.is_precise() && reference.error() < 1e-17, "from {t}: {}", reference.error());
        let [error] = errors(&report)[..] else { panic!("one row") };
        assert!(error < 1e-15 * t.abs(), "from {t}: {error:e}");
    }
}

/// What a step is too long or too short by to end at the end is not an error of the scheme: against an exact solution at the
/// end it would be the larger part.
#[test]
fn errors_near_the_last_digit_are_told() {
    let (law, start) = (HenonHeiles { lambda: 0.9 }, State::new([0.05, 0.1], [0.39, 0.08]));
    let study = Study::new(law, start, 100.0).scheme(Composed::order8(DiscreteGradient)).repetitions(1);
    let report = study.ladder([0.32, 0.16, 0.08, 0.04]).precise().run().unwrap();
    let errors = errors(&report);
    // Order 8 to 10⁻¹³, where the reference in `f64` ends, and beyond.
    assert!((errors[0] / errors[1]).log2() > 7.8, "{errors:?}");
    assert!(errors[1] < 1e-12 && errors[2] < 1e-14 && errors[3] < 1e-14, "{errors:?}");
    assert!(report.resolution() < 1e-16);
}

/// Where the motion ends in a collision there is no reference, and the study says so.
#[test]
fn a_motion_that_cannot_be_followed_is_an_error() {
    let study = Study::new(Kepler { gm: 1.0 }, State::new([1.0, 0.0], [0.0, 0.0]), 5.0).scheme(Leapfrog);
    let error = study.precise().run().unwrap_err();
    assert!(matches!(error, StudyError::Motion(Error::StepVanished { .. } | Error::EndTime { .. })), "{error}");
}

/// Where steps of one length are far too long or too short for most of the motion, at walls, and in chaos.
#[test]
fn hard_motions_have_a_reference_too() {
    fn resolution<L, const D: usize>(law: L, start: State<D>, end: f64) -> f64
    where
        L: Law<D> + Law<D, Wide> + Copy,
    {
        let study = Study::new(law, start, end).scheme(Explicit).ladder([end / 1e4]).repetitions(1).precise();
        study.run().unwrap().resolution()
    }
    let kepler = Kepler { gm: 1.0 };
    assert!(resolution(kepler, kepler.pericentre(1.0, 0.9999), 3.0 * kepler.period(1.0)) < 1e-15);
    assert!(resolution(Wall::default(), State::new([1.0], [-0.7]), 20.0) < 1e-14);
    // What a step is wrong by has grown a billionfold at the end.
    assert!(resolution(HenonHeiles { lambda: 1.0 }, State::new([0.0, 0.1], [0.5, 0.1]), 1000.0) < 1e-14);
}
