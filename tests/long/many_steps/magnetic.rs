//! A force v × B does no work, and the energy is an invariant again: the laws and figures of `examples/magnetic.rs`.

use super::gyration::{self, CROSSED, Circle, GRADED, IN_SPACE, IN_THE_PLANE, MASS, SPEED, UNIFORM};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use dmech::extend::MassIndependent;
use dmech::prelude::*;
use dmech::scheme::Scheme;

/// 78 steps to a turn in the uniform field.
const H: f64 = 0.05;

fn simulate<L: Law<D> + Copy, S: Scheme<Particle<L, D>>, const D: usize>(
    law: L,
    start: State<D>,
    scheme: S,
    (h, steps): (f64, u64),
) -> Run<State<D>> {
    let run = Simulation::new(law, start).mass(MASS).scheme(scheme).dt(h).run(steps);
    run.unwrap_or_else(|interrupted| panic!("{interrupted}"))
}

/// The energy error over 10⁶ steps, every one of which counts.
fn keeps_its_energy<L: Law<D> + Copy, const D: usize>(law: L, start: State<D>, h: f64, what: &str) {
    let run = simulate(law, start, DiscreteGradient, (h, 1_000_000));
    let drift = run.drift(Invariant::Energy).expect("a force that does no work leaves the energy an invariant");
    println!("h = {h:<5} {what:<15} {:.1e}", drift.max_relative());
    assert_eq!(drift.samples(), 1_000_001);
    assert!(drift.max_relative() < 1e-13, "{what}: {:e}", drift.max_relative());
    assert!(drift.max_abs() > 0.0 && run.last().q != start.q, "{what}: nothing moved");
}

/// A field that varies beside an anharmonic well: Newton in both coordinates.
#[derive(Clone, Copy, Debug)]
struct Bowl {
    b: f64,
    length: f64,
    k: f64,
    c: f64,
}

#[dmech::law]
impl Bowl {
    #[potential]
    fn well(&self, q: [f64; 2]) -> f64 {
        let s = q[0] * q[0] + 1.4 * q[1] * q[1];
        0.5 * self.k * s + self.c * s * s
    }
    #[force]
    fn lorentz(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        let b = self.b * (1.0 + q[0] / self.length);
        [b * v[1], -b * v[0]]
    }
}

#[test]
fn energy_is_exact_over_a_million_steps() {
    keeps_its_energy(UNIFORM, IN_SPACE, 0.01, "uniform field");
    keeps_its_energy(GRADED, IN_THE_PLANE, 0.01, "graded field");
    keeps_its_energy(CROSSED, IN_THE_PLANE, 0.01, "crossed fields");
}

#[test]
fn energy_is_exact_at_every_order() {
    fn keeps<L: Law<D> + Copy, S: Scheme<Particle<L, D>>, const D: usize>(law: L, start: State<D>, scheme: S, h: f64) {
        let run = simulate(law, start, scheme, (h, 100_000));
        let drift = run.drift(Invariant::Energy).expect("an invariant");
        println!("h = {h:<5} {:<50} {:.1e}", S::NAME, drift.max_relative());
        assert!(drift.max_relative() < 1e-13 && drift.max_abs() > 0.0, "{}: {:e}", S::NAME, drift.max_relative());
    }
    let bowl = Bowl { b: 2.1, length: 4.0, k: 0.7, c: 0.3 };
    keeps(UNIFORM, IN_SPACE, Composed::order4(DiscreteGradient), 0.1);
    keeps(UNIFORM, IN_SPACE, Composed::order8(DiscreteGradient), 0.3);
    keeps(CROSSED, IN_THE_PLANE, Composed::order6(DiscreteGradient), 0.3);
    keeps(bowl, IN_THE_PLANE, Composed::order4(DiscreteGradient), 0.1);
    keeps(bowl, IN_THE_PLANE, Composed::order6(DiscreteGradient), 0.1);
    keeps(bowl, IN_THE_PLANE, Composed::order8(DiscreteGradient), 0.3);
}

/// Up to half a radian of gyration in a step: a rounding that has a mean would show as h² times the number of steps.
#[test]
fn energy_is_exact_with_large_steps() {
    let bowl = Bowl { b: 2.1, length: 4.0, k: 0.7, c: 0.3 };
    for h in [0.05, 0.1, 0.3] {
        keeps_its_energy(UNIFORM, IN_SPACE, h, "uniform field");
        keeps_its_energy(CROSSED, IN_THE_PLANE, h, "crossed fields");
        keeps_its_energy(bowl, IN_THE_PLANE, h, "field and well");
    }
}

/// A mass per coordinate: the force stays at right angles to Δq, its rows are divided by different masses.
#[test]
fn energy_is_exact_with_a_mass_per_coordinate() {
    fn keeps<L: Law<D> + MassIndependent + Copy, const D: usize>(law: L, masses: [f64; D], start: State<D>, h: f64) {
        let run = Simulation::new(law, start).masses(masses).scheme(DiscreteGradient).dt(h).run(1_000_000).unwrap();
        let drift = run.drift(Invariant::Energy).expect("masses leave the energy an invariant");
        println!("h = {h:<5} {masses:?} {:.1e}", drift.max_relative());
        assert_eq!(drift.samples(), 1_000_001);
        assert!(drift.max_relative() < 1e-13, "h = {h}, {masses:?}: {:e}", drift.max_relative());
        assert!(drift.max_abs() > 0.0 && run.last().q != start.q, "nothing moved");
    }
    let bowl = Bowl { b: 2.1, length: 4.0, k: 0.7, c: 0.3 };
    for h in [0.02, 0.1, 0.3] {
        keeps(UNIFORM, [1.3, 0.7, 2.9], IN_SPACE, h);
        keeps(CROSSED, [1.3, 0.7], IN_THE_PLANE, h);
        keeps(bowl, [1.3, 0.7], IN_THE_PLANE, h);
    }
}

#[test]
fn only_the_energy_exact_step_does_it() {
    let error = |run: Run<State<2>>| run.drift(Invariant::Energy).unwrap().max_relative();
    let implicit = error(simulate(GRADED, IN_THE_PLANE, Implicit, (H, 20_000)));
    let explicit = error(simulate(GRADED, IN_THE_PLANE, Explicit, (H, 200)));
    println!("implicit {implicit:.1e}, explicit {explicit:.1e}");
    assert!(implicit > 1e-6, "in a field that varies the mean force does work: {implicit:e}");
    assert!(explicit > 1e-1, "{explicit:e}");
}

#[test]
fn the_circle_has_the_exact_radius_and_the_period_of_the_step() {
    let run = simulate(UNIFORM, IN_SPACE, DiscreteGradient, (H, 1_000_000));
    let (measured, exact, step) = (Circle::measured(run.states()), Circle::exact(), Circle::of_the_step(H));
    println!("{measured:?}\n{step:?}\n{exact:?}");
    // Half the width of the sampled circle: the samples of 2·10⁴ turns miss the sides by a small part of it.
    assert_relative_eq!(measured.radius, exact.radius, max_relative = 1e-8);
    assert_relative_eq!(measured.period, step.period, max_relative = 1e-12);
    // (ωh)²/12: the period of the step is not the exact one.
    let late = (UNIFORM.b / MASS * H).powi(2) / 12.0;
    assert_abs_diff_eq!((step.period / exact.period - 1.0) / late, 1.0, epsilon = 1e-2);
    // Nothing acts along the field.
    let along = run.last().q[2] / (0.25 * run.last().t);
    assert_abs_diff_eq!(along, 1.0, epsilon = 1e-13);
}

#[test]
fn crossed_fields_drift_with_the_exact_velocity() {
    let run = simulate(CROSSED, IN_THE_PLANE, DiscreteGradient, (H, 100_000));
    let drift = gyration::drift(&run.states()[0], run.last(), |_| CROSSED.b);
    let exact = -CROSSED.e / CROSSED.b;
    println!("{drift:?}, exact [0, {exact}]");
    assert!((drift[1] / exact - 1.0).abs() < 1e-12 && drift[0].abs() < 1e-13);
}

#[test]
fn a_graded_field_drifts_across_its_gradient() {
    let run = simulate(GRADED, IN_THE_PLANE, DiscreteGradient, (H, 100_000));
    let b = |q: [f64; 2]| GRADED.b * (1.0 + q[0] / GRADED.length);
    let drift = gyration::drift(&run.states()[0], run.last(), b);
    let first_order = gyration::graded_drift(&run.states()[0]);
    println!("{drift:?}, to first order {first_order}, speed {SPEED}");
    // First order in radius/length, here about 0.2: the next terms are its square.
    assert!((drift[1] / first_order - 1.0).abs() < 0.1 && drift[0].abs() < 1e-4);
}
