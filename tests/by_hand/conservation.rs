//! What the schemes promise to keep.

use crate::common::{
    Coupled, DrivenSpring, Kepler, Pendulum, Quartic, SUN, SUN_BY_COMPONENTS, Spring, from_apocentre, greenspan_orbit,
};
use approx::{abs_diff_eq, assert_abs_diff_eq};
use dmech_core::prelude::*;

const PERIOD: f64 = core::f64::consts::TAU;

/// Largest relative change over 1e5 steps of a 200th of a period, from the apocentre.
fn keeps<L: Law<2> + VelocityIndependent + Copy, S: Scheme<Particle<L, 2>>>(
    law: L,
    scheme: S,
    energy: Invariant,
    eccentricity: f64,
    bound: f64,
) {
    let run =
        Simulation::new(law, from_apocentre(eccentricity)).scheme(scheme).dt(PERIOD / 200.0).run(100_000).unwrap();
    for invariant in [energy, Invariant::AngularMomentum] {
        let drift = run.drift(invariant).unwrap();
        println!("{} e = {eccentricity}: {invariant} {:.1e}", S::NAME, drift.max_relative());
        assert!(drift.max_relative() < bound, "{} {invariant}: {:e}", S::NAME, drift.max_relative());
        // No drift: the fitted line would reach no further than the fluctuation.
        assert!(drift.slope().abs() * run.last().t < bound * drift.start().abs());
    }
    let span = run.states().iter().map(|s| s.q[0]).fold(0.0, f64::min);
    assert!(span < -0.99 * (1.0 - eccentricity), "the orbit was not traversed: {span}");
}

#[test]
fn energy_and_angular_momentum_are_kept_to_round_off() {
    for (e, bound) in [(0.3, 1e-13), (0.9, 5e-13)] {
        keeps(SUN, DiscreteGradient, Invariant::Energy, e, bound);
        keeps(SUN, Kanatani, Invariant::DiscreteEnergy, e, bound);
        keeps(SUN_BY_COMPONENTS, DiscreteGradient, Invariant::Energy, e, bound);
        keeps(SUN_BY_COMPONENTS, Kanatani, Invariant::DiscreteEnergy, e, bound);
    }
}

/// A million steps past an unresolved pericentre. The velocity's coefficient h/m and the position's h²/2m must agree to
/// more than double precision here: where they agree only to rounding, the error is over 10⁻¹² and proportional to the time.
#[test]
fn a_million_steps_do_not_feed_energy_in() {
    let h = 0.0317;
    let start = from_apocentre(0.9);
    let run = Simulation::new(SUN, start).scheme(DiscreteGradient).dt(h).record_every(1000).run(1_000_000).unwrap();
    let two_step = Simulation::new(SUN, start).scheme(Kanatani).dt(h).record_every(1000).run(1_000_000).unwrap();
    let energy = run.drift(Invariant::Energy).unwrap().max_relative();
    let two_step = two_step.drift(Invariant::DiscreteEnergy).unwrap().max_relative();
    println!("{energy:.1e} {two_step:.1e}");
    assert!(energy < 8e-13 && two_step < 8e-13, "{energy:e} {two_step:e}");
}

/// The energy of an oscillator over 1e6 steps; the same recursion with plain sums drifts by more than a thousand times the bound.
#[test]
fn compensated_sums_take_the_drift_out_of_the_oscillator() {
    let (h, n) = (0.01, 1_000_000);
    let start = State::new([1.0], [0.0]);
    let run =
        Simulation::new(Spring { k: 1.0 }, start).scheme(DiscreteGradient).dt(h).record_every(100).run(n).unwrap();
    let two_step = Simulation::new(Spring { k: 1.0 }, start).scheme(Kanatani).dt(h).record_every(100).run(n).unwrap();
    let drift = run.drift(Invariant::Energy).unwrap().max_relative();
    let two_step = two_step.drift(Invariant::DiscreteEnergy).unwrap().max_relative();

    let (mut q, mut v, mut plain) = (1.0_f64, 0.0_f64, 0.0_f64);
    for _ in 0..n {
        let gradient = (q + 0.5 * h * v) / (1.0 + 0.25 * h * h);
        q += h * v - 0.5 * h * h * gradient;
        v -= h * gradient;
        plain = plain.max((q * q + v * v - 1.0).abs());
    }
    println!("compensated {drift:.1e} and {two_step:.1e}, plain {plain:.1e}");
    assert!(drift < 1e-13 && two_step < 1e-13, "{drift:e} {two_step:e}");
    assert!(plain > 10.0 * drift.max(two_step), "plain sums did as well: {plain:e}");
}

/// Laws that are not central, in one and three coordinates, with masses other than one.
#[test]
fn the_energy_is_exact_for_any_law() {
    let pendulum = Simulation::new(Pendulum { k: 1.7 }, State::new([2.9], [0.1])).mass(0.6);
    let coupled =
        Simulation::new(Coupled { k: [1.1, 2.3, 0.7], lambda: 0.4 }, State::new([0.5, -0.3, 0.2], [0.1, 0.4, -0.2]));
    let coupled = coupled.mass(1.9);
    let runs = [
        pendulum.clone().scheme(DiscreteGradient).dt(0.1).run(20_000).unwrap().report().drift(Invariant::Energy),
        pendulum.scheme(Kanatani).dt(0.1).run(20_000).unwrap().report().drift(Invariant::DiscreteEnergy),
        coupled.clone().scheme(DiscreteGradient).dt(0.1).run(20_000).unwrap().report().drift(Invariant::Energy),
        coupled.scheme(Kanatani).dt(0.1).run(20_000).unwrap().report().drift(Invariant::DiscreteEnergy),
    ];
    for drift in runs {
        let drift = drift.unwrap();
        println!("{:.1e}", drift.max_relative());
        assert!(drift.max_relative() < 1e-13, "{drift:?}");
    }
}

/// One unknown |q|² also where it passes through zero: straight through the centre, beside it, and in three coordinates.
#[test]
fn a_central_law_may_be_followed_through_its_centre() {
    fn check<const D: usize>(start: State<D>) {
        let motion = Simulation::new(Quartic { k: 1.3, lambda: 2.1 }, start).mass(0.8).dt(0.02);
        let one = motion.clone().scheme(DiscreteGradient).run(20_000).unwrap();
        let two = motion.clone().scheme(Kanatani).run(20_000).unwrap();
        let energies = [one.drift(Invariant::Energy), two.drift(Invariant::DiscreteEnergy)];
        for drift in energies.into_iter().chain([one.drift(Invariant::AngularMomentum)]).flatten() {
            assert!(drift.max_abs() < 1e-14, "{D} coordinates: {drift:?}");
        }
        let implicit = motion.scheme(Implicit).run(20_000).unwrap();
        assert!(implicit.drift(Invariant::WorkEnergy).unwrap().max_abs() < 1e-13);
        // Every start swings through the centre or close by.
        let nearest = one.states().iter().map(|s| s.q.iter().map(|x| x * x).sum::<f64>()).fold(1.0, f64::min);
        assert!(nearest < 1e-3, "{nearest}");
        println!("{D}: {:.2} evaluations", one.report().evaluations() as f64 / 20_000.0);
    }
    check(State::new([0.9], [0.0]));
    check(State::new([0.7, 0.0], [0.3, 0.0]));
    check(State::new([0.7, 0.1], [0.3, 0.06]));
    check(State::new([0.7, 0.1, -0.3], [0.3, 0.05, -0.11]));
}

/// Symmetric schemes of bounded energy: it fluctuates by O(h²) and has no trend; the explicit one gains.
#[test]
fn bounded_is_bounded_and_explicit_gains() {
    fn energy<S: Scheme<Particle<Kepler<true>, 2>>>(scheme: S, dt: f64) -> (f64, f64) {
        assert_eq!(S::keeps(Invariant::Energy), if S::ORDER == 1 { Kept::No } else { Kept::Bounded });
        let run = Simulation::new(SUN, greenspan_orbit()).scheme(scheme).dt(dt).run_until(350.0).unwrap();
        let drift = run.drift(Invariant::Energy).unwrap();
        (drift.max_abs(), drift.slope() * 350.0)
    }
    fn check<S: Scheme<Particle<Kepler<true>, 2>>>(scheme: S) {
        let ((coarse, _), (fine, trend)) = (energy(scheme, 0.02), energy(scheme, 0.01));
        let order = (coarse / fine).log2();
        assert!(abs_diff_eq!(order, 2.0, epsilon = 0.1), "{}: {order}", S::NAME);
        assert!(trend.abs() < 0.02 * fine, "{}: {trend:e} of {fine:e}", S::NAME);
    }
    check(Leapfrog);
    check(Implicit);
    check(Kanatani);
    let (gain, trend) = energy(Explicit, 0.01);
    assert!(gain > 0.1 && trend > 0.1, "{gain} {trend}");
}

/// Kₙ − K₀ = W, each by the scheme's own definition of work, for every scheme and also where the law names the time.
#[test]
fn work_is_the_change_of_kinetic_energy() {
    fn check<const D: usize, L: Law<D> + VelocityIndependent + Copy>(law: L, start: State<D>, dt: f64) {
        fn one<const D: usize, L: Law<D>, S: Scheme<Particle<L, D>>>(law: L, start: State<D>, dt: f64, scheme: S) {
            let run = Simulation::new(law, start).mass(1.7).scheme(scheme).dt(dt).run(20_000).unwrap();
            let drift = run.drift(Invariant::WorkEnergy).unwrap();
            assert_eq!(S::keeps(Invariant::WorkEnergy), Kept::Exact);
            let moved = run.states().iter().map(|s| s.v[0] * s.v[0]).fold(0.0, f64::max);
            println!("{:>16} {:.1e} of {moved:.1}", S::NAME, drift.max_abs());
            assert!(moved > 0.1, "nothing moved");
            assert!(drift.max_abs() < 1e-12 * moved, "{}: {drift:?}", S::NAME);
        }
        one(law, start, dt, Explicit);
        one(law, start, dt, Leapfrog);
        one(law, start, dt, Implicit);
        one(law, start, dt, DiscreteGradient);
        one(law, start, dt, Kanatani);
    }
    check(Kepler::<true> { k: 1.7 }, greenspan_orbit(), 0.01);
    check(Pendulum { k: 1.2 }, State::new([2.0], [0.3]), 0.01);
    check(DrivenSpring { k: 2.0, epsilon: 0.2, omega: 0.7 }, State::new([0.8], [0.3]).at_time(3.0), 0.01);
}

/// An invariant that the law does not have is not reported.
#[test]
fn only_what_the_law_has_is_watched() {
    let has = |run: &Run<State<1>>| Invariant::ALL.map(|i| run.drift(i).is_some());
    let driven = Simulation::new(DrivenSpring { k: 2.0, epsilon: 0.2, omega: 0.7 }, State::new([0.8], [0.3]));
    assert_eq!(has(&driven.scheme(Kanatani).dt(0.1).run(3).unwrap()), [false, false, true, false, false]);
    let pendulum = Simulation::new(Pendulum { k: 1.0 }, State::new([0.8], [0.3]));
    assert_eq!(has(&pendulum.clone().scheme(Kanatani).dt(0.1).run(3).unwrap()), [true, true, true, false, false]);
    assert_eq!(has(&pendulum.scheme(Leapfrog).dt(0.1).run(3).unwrap()), [true, false, true, false, false]);
    // A central force in one coordinate has no angular momentum; in three it has a tensor.
    let line = Simulation::new(Spring { k: 1.0 }, State::new([0.8], [0.3])).scheme(Leapfrog).dt(0.1).run(3).unwrap();
    assert!(line.drift(Invariant::AngularMomentum).is_none());
    let start = State::new([0.8, -0.2, 0.5], [0.3, 1.1, 0.9]);
    let space = Simulation::new(Spring { k: 1.3 }, start).mass(2.0).scheme(Leapfrog).dt(0.1).run(1000).unwrap();
    let drift = space.drift(Invariant::AngularMomentum).unwrap();
    let l = [-0.2 * 0.9 - 0.5 * 1.1, 0.5 * 0.3 - 0.8 * 0.9, 0.8 * 1.1 + 0.2 * 0.3_f64].map(|x| 2.0 * x);
    assert_abs_diff_eq!(drift.start(), l.iter().map(|x| x * x).sum::<f64>().sqrt(), epsilon = 1e-15);
    assert!(drift.max_relative() < 1e-13);
    let explicit = Simulation::new(Spring { k: 1.3 }, start).scheme(Explicit).dt(0.1).run(1000).unwrap();
    assert!(explicit.drift(Invariant::AngularMomentum).unwrap().max_relative() > 0.1);
}

/// A law that names the time is followed to second order: the parametric oscillator against a thousandfold finer run.
#[test]
fn a_law_that_names_the_time_is_followed_to_second_order() {
    fn order<S: Scheme<Particle<DrivenSpring, 1>>>(scheme: S, reference: f64) -> f64 {
        let law = DrivenSpring { k: 2.0, epsilon: 0.3, omega: 0.9 };
        let end = |n: f64| {
            let run = Simulation::new(law, State::new([0.8], [0.3]).at_time(1.0)).scheme(scheme).dt(2.0 / n);
            (run.run_until(3.0).unwrap().last().q[0] - reference).abs()
        };
        (end(200.0) / end(400.0)).log2()
    }
    let law = DrivenSpring { k: 2.0, epsilon: 0.3, omega: 0.9 };
    let fine = Simulation::new(law, State::new([0.8], [0.3]).at_time(1.0)).scheme(Leapfrog).dt(1e-5).record_every(1000);
    let reference = fine.run_until(3.0).unwrap().last().q[0];
    for (name, order) in [
        ("Leapfrog", order(Leapfrog, reference)),
        ("Implicit", order(Implicit, reference)),
        ("DiscreteGradient", order(DiscreteGradient, reference)),
        ("Kanatani", order(Kanatani, reference)),
    ] {
        assert!(abs_diff_eq!(order, 2.0, epsilon = 0.05), "{name}: {order}");
    }
}
