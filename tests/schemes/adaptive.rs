//! Steps that follow the motion: what is kept, what a tolerance means, what it saves.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::hint::black_box;

use dmech::Drift;
use dmech::extend::Adaptable;
use dmech::models::{DampedPendulum, DrivenPendulum, HenonHeiles, Kepler, Morse, Pendulum, Quartic, Wall, pairs};
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};

use dmech_tests::memory::allocations;
use dmech_tests::motion::{distance, does_not_drift};

const SUN: Kepler = Kepler { gm: 1.0 };

/// An orbit of half-axis 1 from its apocentre.
fn from_apocentre(e: f64) -> State<2> {
    State::new([-1.0 - e, 0.0], [0.0, -((1.0 - e) / (1.0 + e)).sqrt()])
}

/// Where that orbit is after a time.
fn exact(e: f64, t: f64) -> [f64; 2] {
    SUN.exact(1.0, e, t + 0.5 * TAU)
}

/// An adaptive run on that orbit that records every n-th step.
fn orbit<S>(scheme: S, e: f64, tolerance: f64, end: f64, every: u64) -> Run<State<2>>
where
    S: Adaptable + Scheme<Particle<Kepler, 2>>,
{
    let simulation = Simulation::new(SUN, from_apocentre(e)).scheme(scheme).adaptive(tolerance);
    simulation.record_every(every).run_until(end).unwrap_or_else(|interrupted| panic!("{interrupted}"))
}

/// The distance from the exact position at the end.
fn error(run: &Run<State<2>>, e: f64) -> f64 {
    distance(run.last().q, exact(e, run.last().t))
}

#[test]
fn energy_and_angular_momentum_are_exact_over_many_steps() {
    fn check<S: Adaptable + Scheme<Particle<Kepler, 2>>>(
        scheme: S,
        e: f64,
        tolerance: f64,
        revolutions: f64,
        stages: u64,
    ) {
        let run = orbit(scheme, e, tolerance, TAU * revolutions, 7);
        let solutions = stages * run.steps();
        assert!(solutions > 100_000, "{solutions} equations solved");
        let drift = |invariant| -> Drift { run.drift(invariant).unwrap() };
        let (energy, turning) = (drift(Invariant::Energy), drift(Invariant::AngularMomentum));
        println!("{} e = {e}: {:e} {:e}, {solutions}", S::NAME, energy.max_relative(), turning.max_relative());
        // At the pericentre K and Φ are (1 + e)/(1 − e) times as large as the energy, and so is the rounding of their sum.
        assert!(energy.max_relative() < 1e-13 * (0.1 / (1.0 - e)).max(1.0), "{:e}", energy.max_relative());
        assert!(turning.max_relative() < 1e-13, "{:e}", turning.max_relative());
        // Not more than roundings there that go to and fro: an error with a sign would be √solutions as large.
        let rounding = f64::EPSILON * (1.0 + e) / (1.0 - e) * (solutions as f64).sqrt();
        assert!(energy.max_relative() < 0.1 * rounding, "{:e} for {rounding:e}", energy.max_relative());
    }
    check(DiscreteGradient, 0.9, 1e-3, 250.0, 1);
    check(DiscreteGradient, 0.99, 1e-3, 180.0, 1);
    check(Composed::order4(DiscreteGradient), 0.9, 1e-5, 300.0, 5);
    check(Composed::order6(DiscreteGradient), 0.9, 1e-7, 200.0, 13);
    check(Composed::order6(DiscreteGradient), 0.99, 1e-7, 150.0, 13);
    check(Composed::order8(DiscreteGradient), 0.99, 1e-7, 150.0, 21);
}

#[test]
fn the_error_is_in_proportion_to_the_tolerance_at_every_order() {
    fn check<S: Adaptable + Scheme<Particle<Kepler, 2>>>(scheme: S, tolerances: [f64; 2]) {
        let revolutions = 10.3;
        for e in [0.7, 0.9, 0.97] {
            let runs = tolerances.map(|tolerance| orbit(scheme, e, tolerance, TAU * revolutions, 1000));
            let errors = [error(&runs[0], e), error(&runs[1], e)];
            let share = errors[1] / revolutions / tolerances[1];
            // The order, by mean steps: they are as many as it takes to turn ω by ε each time.
            let order = (errors[0] / errors[1]).ln() / (runs[1].steps() as f64 / runs[0].steps() as f64).ln();
            println!("{:<40} e = {e}: order {order:.3}, {share:.3} of the tolerance per revolution", S::NAME);
            // Of Smooth8S14 the next term of the error shows, as the first is small.
            let above = if S::NAME.contains("Smooth8S14") { 0.35 } else { 0.15 };
            let order_is_held = (-0.15..above).contains(&(order - f64::from(S::ORDER)));
            assert!(order_is_held, "{} at e = {e}: order {order}", S::NAME);
            assert!((0.01..4.0).contains(&share), "{} at e = {e}: {share} of the tolerance", S::NAME);
            // Compositions of other schemes go by the stages that were fitted to the energy-exact step.
            let others = S::NAME.starts_with("Composed(") && !S::NAME.starts_with("Composed(DiscreteGradient");
            let least = if others { 0.1 } else { 0.2 };
            if e == 0.9 {
                assert!((least..1.5).contains(&share), "{}: {share} of the tolerance", S::NAME);
            }
        }
    }
    check(DiscreteGradient, [1e-4, 1e-6]);
    check(Implicit, [1e-4, 1e-6]);
    check(Composed::order4(DiscreteGradient), [1e-5, 1e-8]);
    check(Composed::order4(Implicit), [1e-5, 1e-8]);
    check(Composed::order6(DiscreteGradient), [1e-6, 1e-9]);
    check(Composed::order8(DiscreteGradient), [1e-6, 1e-9]);
    check(Composed::order4(Leapfrog), [1e-6, 1e-8]);
    check(Composed::order6(Leapfrog), [1e-7, 1e-10]);
    check(Composed::order8(Leapfrog), [1e-8, 1e-10]);
    check(Nystrom::order4(), [1e-7, 1e-9]);
    check(Nystrom::new(coefficients::BlanesMoan6S11), [1e-9, 1e-11]);
    check(Nystrom::order6(), [1e-9, 1e-11]);
    check(Nystrom::order8(), [1e-9, 1e-11]);
    check(ForceGradient::new(coefficients::Omelyan4S4), [1e-7, 1e-9]);
    check(ForceGradient::order4(), [1e-7, 1e-9]);
    check(ForceGradient::order6(), [1e-8, 1e-10]);
    check(ForceGradient::new(coefficients::Omelyan8S11), [1e-7, 1e-9]);
    check(ForceGradient::order8(), [1e-9, 1e-11]);
}

/// Unequal steps are not symplectic, but reversible: the energy error of a splitting is the same in each revolution.
#[test]
fn the_energy_of_splittings_does_not_drift() {
    fn check<S: Adaptable + Scheme<Particle<Kepler, 2>>>(scheme: S, e: f64, tolerance: f64) {
        let largest = |revolutions| {
            let run = orbit(scheme, e, tolerance, TAU * revolutions, 1);
            let turning = run.drift(Invariant::AngularMomentum).unwrap().max_relative();
            assert!(turning < 1e-13, "{turning:e}");
            if revolutions > 100.0 {
                does_not_drift(&run, Invariant::Energy, S::NAME);
            }
            run.drift(Invariant::Energy).unwrap().max_relative()
        };
        let [few, many] = [3.0, 300.0].map(largest);
        println!("{:<40} e = {e}: {few:.2e} in 3 revolutions, {many:.2e} in 300", S::NAME);
        assert!(few > 1e-11, "{few:e} is rounding");
        assert!(many < 1.5 * few, "{}: {few:e} becomes {many:e}", S::NAME);
    }
    check(Composed::order4(Leapfrog), 0.9, 1e-5);
    check(Nystrom::order4(), 0.9, 1e-6);
    check(Nystrom::order6(), 0.9, 1e-7);
    check(Nystrom::order6(), 0.99, 1e-8);
    check(Nystrom::order8(), 0.99, 1e-8);
    check(ForceGradient::order6(), 0.9, 1e-7);
    check(ForceGradient::order8(), 0.99, 1e-9);
}

/// −4ε(q⁻⁶ − q⁻¹²): beyond its bend the frequency passes through zero, at the wall it grows a hundredfold.
#[derive(Clone, Copy, Debug)]
struct Well {
    epsilon: f64,
}

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        4.0 * self.epsilon * (q.powi(-12) - q.powi(-6))
    }
}

/// The largest relative error of the energy of two runs, one twenty times as long as the other: it goes to and fro, and does not grow
/// beyond what ρ, a third less than ω at most, makes of the order.
fn goes_to_and_fro(scheme: &str, order: u32, (tolerance, most): (f64, f64), [few, many]: [Option<Drift>; 2]) {
    let [few, many] = [few, many].map(|energy| energy.unwrap().max_relative());
    println!("{scheme:<42} {tolerance:.0e}: {few:.1e} to t = 100, {many:.1e} to 2000");
    assert!(many < 1.5_f64.powi(order as i32) * few + tolerance.min(1e-10), "{scheme}: {few:e}, {many:e}");
    assert!(many < most, "{scheme} at {tolerance:e}: {many:e}");
}

/// Steps that are too long to see how ω changes come away from it, and where that is put right the rule does not run backward. They are
/// made again, half as long, down to 0.3 radians: of the energy no more is lost than is said here, at tolerances that would have it
/// lost altogether in the first steps.
#[test]
fn the_energy_does_not_drift_where_the_frequency_passes_through_zero() {
    fn check<L, S, const D: usize>((law, start): (L, State<D>), scheme: S, bounds: &[(f64, f64)])
    where
        L: Law<D> + Copy,
        S: Adaptable + Scheme<Particle<L, D>>,
    {
        for &bound in bounds {
            let energies = [100.0, 2000.0].map(|end| {
                let motion = Simulation::new(law, start).scheme(scheme).adaptive(bound.0).record_every(5);
                motion.run_until(end).unwrap().drift(Invariant::Energy)
            });
            goes_to_and_fro(S::NAME, S::ORDER, bound, energies);
        }
    }
    let swing = (Pendulum { k: 1.0 }, State::new([2.0], [0.0]));
    let bond = (Morse { depth: 1.0, width: 1.1, length: 1.3 }, State::new([1.3], [1.0]));
    let quartic = (Quartic { beta: 0.27 }, State::new([1.0], [0.3]));
    let well = (Well { epsilon: 1.0 }, State::new([1.12], [1.0]));
    check(swing, Gauss::order16(), &[(1e-8, 1e-7), (1e-10, 1e-8), (1e-12, 3e-12)]);
    check(bond, Gauss::order16(), &[(1e-8, 1e-7), (1e-10, 2e-8), (1e-12, 3e-12)]);
    check(quartic, Gauss::order16(), &[(1e-8, 1e-7), (1e-10, 1e-10), (1e-12, 3e-12)]);
    check(well, Gauss::order16(), &[(1e-8, 1e-7), (1e-13, 5e-11)]);
    check(swing, Nystrom::order6(), &[(1e-2, 1e-4), (1e-7, 1e-6)]);
    check(bond, ForceGradient::order8(), &[(1e-2, 2e-5), (1e-7, 4e-6)]);
    check(quartic, ForceGradient::order8(), &[(1e-2, 2e-5), (1e-7, 3e-7)]);
    check(quartic, Composed::order4(Leapfrog), &[(1e-4, 1e-4)]);
    // One that a step across the whole bond threw out of it.
    let thrown = (Morse { depth: 1.0, width: 1.0, length: 1.0 }, State::new([1.0], [0.7219]));
    check(thrown, Nystrom::order6(), &[(1e-3, 2e-4)]);
}

/// So do two atoms that swing and turn, as a scene.
#[test]
fn the_energy_of_two_atoms_does_not_drift() {
    fn check<L, S>(scene: Scene<2, (), L>, scheme: S, bounds: &[(f64, f64)])
    where
        L: Term<2, ()> + Clone,
        S: Adaptable + Scheme<SceneSystem<2, L::Ready>>,
    {
        for &bound in bounds {
            let energies = [100.0, 2000.0].map(|end| {
                let motion = Simulation::scene(scene.clone()).scheme(scheme).adaptive(bound.0).record_every(5);
                motion.run_until(end).unwrap().drift(Invariant::Energy)
            });
            goes_to_and_fro(S::NAME, S::ORDER, bound, energies);
        }
    }
    let two = || Scene::new().body(1.0, [0.0, 0.0], [-0.5, -0.2]).body(1.7, [1.12, 0.0], [0.5 / 1.7, 0.2 / 1.7]);
    let (argon, bond) =
        (pairs::LennardJones { epsilon: 1.0, sigma: 1.0 }, pairs::Morse { depth: 1.0, width: 2.0, length: 1.0 });
    check(two().pairs(argon), Gauss::order16(), &[(1e-6, 1e-9), (1e-12, 1e-11)]);
    check(two().pairs(bond), Gauss::order16(), &[(1e-6, 1e-8)]);
    check(two().pairs(argon), Nystrom::order6(), &[(1e-4, 3e-5)]);
}

/// A kick that two steps of different length share is half the one's and half the other's: also its work.
#[test]
fn kicks_are_shared_by_unequal_steps() {
    fn check<S: Adaptable + Scheme<Particle<HenonHeiles, 2>>>(scheme: S) {
        let run = Simulation::new(HenonHeiles { lambda: 1.0 }, State::new([0.0, 0.1], [0.42, 0.1])).mass(1.3);
        let run = run.scheme(scheme).adaptive(1e-6).run_until(500.0).unwrap();
        let [shortest, longest] = run.report().dt_range().unwrap();
        assert!(longest > 1.2 * shortest, "{shortest} to {longest}");
        let balance = run.drift(Invariant::WorkEnergy).unwrap();
        assert!(balance.max_abs() < 1e-14, "{}: {:e}", S::NAME, balance.max_abs());
    }
    check(Composed::order4(Leapfrog));
    check(Nystrom::order4());
    check(Nystrom::order6());
    check(ForceGradient::new(coefficients::Omelyan4S4));
}

/// h ∝ r^(3/2), up to what the direction of the fall and a finite ε make of it.
#[test]
fn steps_follow_the_distance_from_the_centre() {
    for e in [0.9, 0.99] {
        let run = orbit(DiscreteGradient, e, 1e-3, 3.0 * TAU, 1);
        let ratios: Vec<f64> = run
            .states()
            .windows(2)
            .map(|pair| {
                let [before, after] = [0, 1].map(|i| pair[i].q[0].hypot(pair[i].q[1]));
                (pair[1].t - pair[0].t) / (before * after).powf(0.75)
            })
            .collect();
        // The last step is shortened to land.
        let inner = &ratios[..ratios.len() - 1];
        let (least, most) = inner.iter().fold((f64::MAX, 0.0_f64), |(a, b), x| (a.min(*x), b.max(*x)));
        let [shortest, longest] = run.report().dt_range().unwrap();
        println!("e = {e}: h/r^1.5 from {least:.4} to {most:.4}, h from {shortest:.2e} to {longest:.2e}");
        assert!(most / least < 1.5, "e = {e}: {least} to {most}");
        assert!(longest / shortest > 0.6 * ((1.0 + e) / (1.0 - e)).powf(1.5));
    }
}

/// What is kept leaves only the phase to be wrong, and that grows in proportion to the time.
#[test]
fn the_error_grows_in_proportion_to_the_time() {
    let e = 0.8;
    let errors = [30.3, 300.3].map(|n| error(&orbit(DiscreteGradient, e, 1e-5, TAU * n, 1000), e));
    let growth = errors[1] / errors[0];
    assert!((8.0..12.0).contains(&growth), "{errors:?}");
}

/// Forces that it takes to reach an error, adaptive and with equal steps, by halving.
fn forces(e: f64, target: f64) -> [u64; 2] {
    let end = 10.3 * TAU;
    let scheme = Composed::order6(DiscreteGradient);
    let reached = |run: Result<Run<State<2>>, _>| {
        let run: Option<Run<State<2>>> = run.map_err(|_: Interrupted<State<2>>| ()).ok();
        run.filter(|run| error(run, e) < target).map(|run| run.report().evaluations())
    };
    let simulation = || Simulation::new(SUN, from_apocentre(e)).scheme(scheme).record_every(1000);
    let adaptive = (0..40).find_map(|k| reached(simulation().adaptive(0.1 * (-f64::from(k)).exp2()).run_until(end)));
    let equal =
        (0..20).find_map(|k| reached(simulation().dt(end / (1000.0 * (0.5 * f64::from(k)).exp2())).run_until(end)));
    [adaptive.unwrap(), equal.unwrap()]
}

#[test]
fn following_the_motion_saves_work() {
    for (e, least) in [(0.9, 3.0), (0.99, 30.0)] {
        let [adaptive, equal] = forces(e, 1e-6);
        println!("e = {e}: {adaptive} forces for 1e-6 of the half-axis, {equal} with equal steps");
        assert!(equal as f64 > least * adaptive as f64, "e = {e}: {adaptive} and {equal}");
    }
}

/// Where ∂a/∂q passes through 0, at a right angle and in the middle of a quartic well, the steps stay within a factor of 3.
#[test]
fn steps_do_not_run_away_where_the_stiffness_is_zero() {
    fn check<L: Law<1> + Copy, S: Adaptable + Scheme<Particle<L, 1>>>(
        law: L,
        scheme: S,
        start: State<1>,
        tolerance: f64,
    ) -> Run<State<1>> {
        let run = Simulation::new(law, start).scheme(scheme).adaptive(tolerance).run_until(300.0).unwrap();
        let [shortest, longest] = run.report().dt_range().unwrap();
        println!("{} from {:?}: {} steps from {shortest:.3} to {longest:.3}", S::NAME, start.q, run.steps());
        assert!(longest < 3.0 * shortest, "{shortest} to {longest}");
        let energy = run.drift(Invariant::Energy).unwrap();
        assert!(energy.max_abs() < 1e-13 * energy.start().abs().max(0.1), "{energy:?}");
        run
    }
    let pendulum = Pendulum { k: 1.7 };
    for angle in [0.4, FRAC_PI_2, 2.5] {
        check(pendulum, DiscreteGradient, State::new([angle], [0.0]), 1e-3);
        let run = check(pendulum, Composed::order6(DiscreteGradient), State::new([angle], [0.0]), 1e-8);
        let truth = pendulum.exact(angle, 300.0);
        assert!(abs_diff_eq!(run.last().q[0], truth, epsilon = 1e-6), "{} for {truth}", run.last().q[0]);
    }
    check(Quartic { beta: 1.3 }, Composed::order6(DiscreteGradient), State::new([0.0], [0.8]), 1e-8);
    check(Quartic { beta: 1.3 }, DiscreteGradient, State::new([1.1], [0.0]), 1e-3);
}

#[test]
fn released_near_the_top() {
    let top = std::f64::consts::PI - 1e-9;
    let law = Pendulum { k: 1.7 };
    let run = Simulation::new(law, State::new([top], [0.0])).scheme(Composed::order6(DiscreteGradient));
    let run = run.adaptive(1e-9).run_until(60.0).unwrap();
    assert!(run.states().iter().any(|state| state.q[0] < -3.0), "it swings to the other side");
    let energy = run.drift(Invariant::Energy).unwrap();
    assert!(energy.max_relative() < 1e-13, "{:e}", energy.max_relative());
}

#[test]
fn chaos_keeps_its_energy_and_its_steps() {
    let law = HenonHeiles { lambda: 1.0 };
    // Energy 1/8.
    let run = Simulation::new(law, State::new([0.0, 0.1], [0.49058, 0.0])).scheme(Composed::order4(DiscreteGradient));
    let run = run.adaptive(1e-6).record_every(10).run_until(5000.0).unwrap();
    let energy = run.drift(Invariant::Energy).unwrap();
    assert!(energy.max_relative() < 1e-13, "{:e}", energy.max_relative());
    // ω stays between those of |q| = 0 and 1; a density that walked off would take the steps along.
    let [shortest, longest] = run.report().dt_range().unwrap();
    assert!(longest < 3.0 * shortest, "{shortest} to {longest}");
}

#[test]
fn drag_and_time_are_accounted_for() {
    let damped = DampedPendulum { k: 1.7, alpha: 0.08 };
    let run = Simulation::new(damped, State::new([2.8], [0.4])).mass(1.3).scheme(DiscreteGradient);
    let run = run.adaptive(1e-4).run_until(60.0).unwrap();
    assert!(run.drift(Invariant::Energy).is_none());
    let balance = run.drift(Invariant::WorkEnergy).unwrap();
    assert!(balance.max_abs() < 1e-13, "{:e}", balance.max_abs());

    let driven = DrivenPendulum { k: 1.7, alpha: 0.08, amplitude: 0.9, omega: 0.7 };
    let start = State::new([0.8], [0.4]).at_time(0.3);
    let simulation = || Simulation::new(driven, start).scheme(Composed::order6(DiscreteGradient));
    let refused = simulation().adaptive(1e-6).run_until(30.0).unwrap_err();
    assert_eq!(refused.cause(), Error::NoTimeScale { step: 1, time: 0.3 });
    let run = simulation().dt(0.4).adaptive(1e-8).run_until(30.0).unwrap();
    let balance = run.drift(Invariant::WorkEnergy).unwrap();
    assert!(balance.max_abs() < 1e-12, "{:e}", balance.max_abs());
    let truth = simulation().dt(0.005).run_until(30.0).unwrap();
    assert_abs_diff_eq!(run.last().q[0], truth.last().q[0], epsilon = 1e-6);
    assert!(run.report().dt_range().unwrap()[1] <= 0.4);
}

/// A ball on a floor: free flight has no time scale, the contact has.
#[test]
fn free_flight_needs_a_longest_step() {
    let law = Wall { k: 900.0, pull: 1.3 };
    let simulation = || Simulation::new(law, State::new([1.0], [0.0])).scheme(DiscreteGradient);
    let refused = simulation().adaptive(1e-4).run_until(30.0).unwrap_err();
    assert_eq!(refused.cause(), Error::NoTimeScale { step: 1, time: 0.0 });
    assert!(refused.run().states().is_empty());
    let run = simulation().adaptive(1e-3).dt(0.05).run_until(30.0).unwrap();
    let energy = run.drift(Invariant::Energy).unwrap();
    assert!(energy.max_relative() < 1e-13, "{:e}", energy.max_relative());
    assert!(run.states().iter().filter(|state| state.q[0] < 0.0).count() > 100, "the contact is resolved");
}

#[test]
fn the_last_step_lands() {
    for end in [0.1, 1.0 / 3.0, 20.7, 1e3] {
        let run = orbit(Composed::order4(DiscreteGradient), 0.5, 1e-4, end, 1);
        assert_eq!(run.last().t, end);
        assert!(run.states().windows(2).all(|pair| pair[0].t < pair[1].t));
        assert!(distance(run.last().q, exact(0.5, end)) < 1e-4 * (1.0 + end / TAU));
    }
    let simulation = Simulation::new(SUN, from_apocentre(0.5)).scheme(DiscreteGradient).adaptive(1e-4);
    let refused = simulation.run_until(-1.0).expect_err("the end comes before the start");
    assert!(matches!(refused.cause(), Error::Span { .. }), "{refused}");
}

/// Where the time has few digits, what comes to within the rounding of the end is not there yet.
#[test]
fn far_from_zero_the_last_step_lands_as_near() {
    let from = |t: f64, ahead: f64| {
        let start = State::new([0.5], [0.0]).at_time(t);
        let pendulum = Simulation::new(Pendulum { k: 1.0 }, start).scheme(Gauss::order16()).adaptive(1e-10);
        *pendulum.run_until(t + ahead).unwrap().last()
    };
    for ahead in [0.875, 1.0, 1.125, 1.5, 2.0, 7.0, 30.0] {
        let (near, far) = (from(0.0, ahead), from(1e15, ahead));
        assert_eq!(far.t, 1e15 + ahead);
        assert_abs_diff_eq!(near.q[0], far.q[0], epsilon = 1e-9);
        assert_abs_diff_eq!(near.v[0], far.v[0], epsilon = 1e-9);
    }
}

/// Time is a sum of many different numbers, and correct to its last digit.
#[test]
fn time_is_not_lost_in_many_steps() {
    let mut stepper =
        Simulation::new(SUN, from_apocentre(0.9)).scheme(DiscreteGradient).adaptive(1e-6).stepper().unwrap();
    let (mut sum, mut rest) = (0.0_f64, 0.0_f64);
    for _ in 0..300_000 {
        let before = stepper.t();
        stepper.step().unwrap();
        // Differences of times are exact but for the last digit of the times themselves.
        let change = stepper.t() - before;
        let next = sum + (change + rest);
        rest += change - (next - sum);
        sum = next;
    }
    assert_eq!(sum, stepper.t());
    let mut at_once =
        Simulation::new(SUN, from_apocentre(0.9)).scheme(DiscreteGradient).adaptive(1e-6).stepper().unwrap();
    at_once.advance(300_000).unwrap();
    assert_eq!((at_once.state(), at_once.evaluations()), (stepper.state(), stepper.evaluations()));
}

#[test]
fn what_cannot_be_done_is_told() {
    let simulation = || Simulation::new(SUN, from_apocentre(0.5)).scheme(DiscreteGradient);
    for tolerance in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        let refused = simulation().adaptive(tolerance).stepper().err();
        assert!(matches!(refused, Some(Error::Tolerance { .. })), "{tolerance}: {refused:?}");
    }
    // So small that a step turns nothing: laws and scenes, with an end and without, at once and not after 10¹⁵ steps.
    for tolerance in [1e-300, 1e-40, f64::from_bits(1)] {
        let vanished = |cause: Error| match cause {
            Error::TurnVanished { tolerance: told, angle } => told == tolerance && (0.0..f64::EPSILON).contains(&angle),
            _ => false,
        };
        assert!(vanished(simulation().adaptive(tolerance).run_until(1.0).unwrap_err().cause()), "{tolerance}");
        assert!(vanished(simulation().adaptive(tolerance).dt(0.1).stepper().unwrap_err()), "{tolerance}");
        let scene = Scene::<2>::new().body(1.0, [0.0; 2], [0.0; 2]).body(1.0, [1.0, 0.0], [0.0, 1.0]);
        let scene = scene.pairs(dmech::models::pairs::Gravity { g: 1.0 });
        let scene = Simulation::scene(scene).scheme(DiscreteGradient).adaptive(tolerance);
        assert!(vanished(scene.run(1 << 60).unwrap_err().cause()), "{tolerance}");
    }
    let shortest = simulation().scheme(Gauss::order16()).adaptive(1e-300).stepper().unwrap_err();
    assert!(matches!(shortest, Error::TurnVanished { .. }), "{shortest}");
    println!("{shortest}");
    // A longest step that is too short for the end, as one of equal steps is.
    let short = simulation().adaptive(1e-3).dt(1e-300).run_until(1.0).unwrap_err().cause();
    assert_eq!(short, Error::EndTime { end: 1.0, dt: 1e-300 });
    assert!(simulation().adaptive(1e-3).dt(1e-300).run(10).is_ok());
    assert!(matches!(simulation().adaptive(1e-3).dt(-1.0).stepper().err(), Some(Error::TimeStep { .. })));
    assert!(matches!(simulation().adaptive(1e-3).run_until(f64::NAN).unwrap_err().cause(), Error::EndTime { .. }));

    // Straight into the centre: steps shrink as r^(3/2), and the fall ends in an error and not in endless steps.
    let fall = Simulation::new(SUN, State::new([1.0, 0.0], [0.0, 0.0])).scheme(DiscreteGradient).adaptive(1e-3);
    let ended = fall.run_until(10.0).unwrap_err();
    println!("{ended}");
    assert!(ended.run().steps() > 100 && ended.run().steps() < 100_000, "{ended}");
    assert_abs_diff_eq!(ended.run().last().t, 0.25 * TAU / 2.0_f64.sqrt(), epsilon = 1e-3);

    // Newton may hardly do anything: the error has the step that was tried.
    let stuck = Simulation::new(Pendulum { k: 1.7 }, State::new([2.5], [0.3]));
    let stuck = stuck.scheme(DiscreteGradient.with(Newton::from_previous().max_iterations(1))).adaptive(1e-1);
    let Error::NotConverged { dt, step, .. } = stuck.run_until(10.0).unwrap_err().cause() else {
        panic!("one iteration is not enough");
    };
    assert!(step == 1 && dt.is_finite() && dt > 0.01, "{step} {dt}");
}

#[test]
fn the_report_tells_the_steps() {
    let run = orbit(DiscreteGradient, 0.9, 1e-3, 10.0, 10);
    let report = run.report();
    assert_eq!((report.tolerance(), report.scheme()), (Some(1e-3), "Adaptive(DiscreteGradient)"));
    let [shortest, longest] = report.dt_range().unwrap();
    assert!(shortest < 0.1 * longest);
    let text = report.to_string();
    let line = format!("tolerance 1e-3, dt from {shortest:.3e} to {longest:.3e}, {} steps", run.steps());
    assert!(text.contains(&line), "{text}");
}

#[test]
fn no_step_allocates() {
    let mut stepper = Simulation::new(SUN, from_apocentre(0.9))
        .scheme(Composed::order6(DiscreteGradient))
        .adaptive(1e-4)
        .stepper()
        .unwrap();
    let counted = allocations(|| {
        for _ in 0..500 {
            stepper.step().unwrap();
            black_box(stepper.state());
        }
        stepper.advance(500).unwrap();
    });
    assert_eq!((counted, stepper.steps()), (0, 1000));
}

/// e^{k(q − 1)} beside a spring: a wall that one step runs into.
#[derive(Clone, Copy, Debug)]
struct SteepWall {
    k: f64,
}

#[dmech::law]
impl SteepWall {
    #[potential]
    fn energy(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0] + (self.k * (q[0] - 1.0)).exp()
    }
}

/// A step that fails, however often it is made again, leaves the stepper where it was, its next step and its counts; a step that is made
/// again is paid for as often as it is made.
#[test]
fn a_step_that_fails_changes_nothing() {
    let start = State::new([0.0], [2.0]);
    let motion = Simulation::new(SteepWall { k: 200.0 }, start).scheme(RungeKuttaNystrom::order12()).adaptive(1e-12);
    let mut stepper = motion.stepper().unwrap();
    let failed = (0..40).any(|_| {
        let before = (stepper.next_dt(), stepper.evaluations(), stepper.iterations(), stepper.checkpoint());
        let failed = stepper.step().is_err();
        if failed {
            let after = (stepper.next_dt(), stepper.evaluations(), stepper.iterations(), stepper.checkpoint());
            assert_eq!(before, after);
        }
        failed
    });
    assert!(failed);

    let motion = Simulation::new(SteepWall { k: 20.0 }, start).scheme(DiscreteGradient).adaptive(10.0);
    let mut stepper = motion.clone().stepper().unwrap();
    let wanted = stepper.next_dt();
    stepper.step().unwrap();
    assert!(stepper.t() < 0.6 * wanted, "{} of {wanted}", stepper.t());
    // Both tries have corrections, and each has an evaluation for each beside the looks.
    let made = motion.dt(1.001 * stepper.t()).stepper().and_then(|mut alone| alone.step().map(|()| alone)).unwrap();
    assert!(stepper.iterations() > made.iterations(), "{} and {}", stepper.iterations(), made.iterations());
    assert_eq!(stepper.evaluations() - stepper.iterations(), 2 * (made.evaluations() - made.iterations()));
}

/// A contact that is as long as the longest step is not passed by steps that are equal in rows: a smaller tolerance never
/// gives more than the error of a larger one.
#[test]
fn a_contact_is_not_passed_in_a_row_of_longest_steps() {
    #[derive(Clone, Copy, Debug, dmech::Law)]
    #[potential(|q: [f64; 1]| self.g * q[0] + 0.5 * self.k * (-q[0]).max(0.0).powi(2))]
    struct Floor {
        g: f64,
        k: f64,
    }

    fn check<S: Adaptable + Scheme<Particle<Floor, 1>>>(scheme: S, tolerances: [f64; 4], least: f64) {
        let floor = Floor { g: 1.1, k: 1e4 };
        let motion = Simulation::new(floor, State::new([0.9], [0.0])).scheme(scheme).record_every(u64::MAX);
        // Free fall, half a revolution about the rest in the spring, and up.
        let (touch, speed, rate) = ((1.8_f64 / 1.1).sqrt(), (1.98_f64).sqrt(), 100.0);
        let contact = 2.0 * (0.5 * TAU - (rate * speed / 1.1).atan()) / rate;
        let rise = 2.0 - touch - contact;
        let exact = speed * rise - 0.55 * rise * rise;
        let mut last = f64::INFINITY;
        for tolerance in tolerances {
            // Half the contact.
            let run = motion.clone().adaptive(tolerance).dt(0.5 * contact).run_until(2.0).unwrap();
            let error = (run.last().q[0] - exact).abs();
            let [shortest, longest] = run.report().dt_range().unwrap();
            assert!(error < 0.7 * last, "{}, {tolerance:e}: {error:e} after {last:e}", S::NAME);
            assert!(longest > 1.2 * shortest, "{}, {tolerance:e}: {shortest} to {longest}", S::NAME);
            last = error;
        }
        assert!(last < least, "{}: {last:e}", S::NAME);
    }
    check(DiscreteGradient, [1e-2, 1e-4, 1e-6, 1e-8], 1e-10);
    // With larger tolerances the contact shortens the steps to 0.3 radians.
    check(Composed::order6(DiscreteGradient), [1e-7, 1e-8, 1e-10, 1e-12], 1e-10);
    check(Nystrom::order6(), [1e-8, 1e-9, 1e-11, 1e-12], 1e-5);
}
