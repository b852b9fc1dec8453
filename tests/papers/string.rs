//! Greenspan §7, the vibrating string, by the code of `examples/string.rs`, against the same computation made
//! independently.

#[path = "../../examples/shared/section_7.rs"]
mod section_7;

use approx::{abs_diff_eq, assert_abs_diff_eq};
use dmech::extend::PairLaw;
use dmech::prelude::*;
use section_7::{
    DT, Energies, PARTICLES, SPACING, SPRING, TENSION, WEIGHT, asymmetry, difference, force_form, potential_form, tent,
};

/// Step, and y of particles 25, 50, 75, 100: an independent reproduction in binary64, 80-bit and 72-digit arithmetic, in
/// which 1e-11 is meaningful.
#[rustfmt::skip]
const REPRODUCTION: [(usize, [f64; 4]); 6] = [
    (40, [0.2250373295043407, 0.47424000000000005, 0.6738894640473825, 0.6730676547069858]),
    (120, [-0.008751950376685573, -0.08930743831286428, -0.13185725907286858, -0.13569955836867784]),
    (200, [-0.452710545541212, -0.8403127102702852, -0.9810828712974148, -1.0265887801932783]),
    (280, [-0.5233110282957071, -0.9581613671930815, -1.3124758286506235, -1.4943408195571846]),
    (400, [-0.1304496636206466, -0.23922823629326406, -0.31722831480888436, -0.35649092838559404]),
    (520, [0.23228866162902706, 0.4882496812803555, 0.7424973437342136, 0.8964665802733099]),
];

/// Of the same reproduction: the energy of the tent, and the largest loss to step 520; it is never above the start.
const ENERGY: f64 = 43.403446860345106;
const ENERGY_DEVIATION: [f64; 2] = [-0.054353669554870976, 0.0];

const STEPS: u64 = 520;

fn run_both() -> [Run<SceneState<1>>; 2] {
    [force_form(STEPS).unwrap(), potential_form(STEPS).unwrap()]
}

#[test]
fn the_string_is_where_the_reproduction_has_it() {
    for run in run_both() {
        for (step, heights) in REPRODUCTION {
            let state = &run.states()[step];
            let found = [25, 50, 75, 100].map(|j: usize| state.q[j][0]);
            let difference = found.iter().zip(heights).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            println!("step {step:>3} {difference:.1e}");
            assert!(difference < 1e-11, "step {step}: {found:?}");
        }
    }
}

/// Δx is not a power of two, so the two forms round differently; what rounding moves, the string does not magnify much.
#[test]
fn both_forms_of_the_tension_are_one_law() {
    for slope in [0.0, 1e-9, 0.03, 1.0, 40.0] {
        for d in [slope * SPACING, -slope * SPACING] {
            let [force] = TENSION.force([d]);
            let [gradient] = PairLaw::<1, ()>::between(&SPRING, [], [], 0.0).gradient([d]);
            let scale = TENSION.t0 * (1.0 + slope * slope);
            assert!((force + gradient).abs() <= 4.0 * f64::EPSILON * scale, "slope {slope}: {force} {gradient}");
        }
    }
    let [force, potential] = run_both();
    let differences = force.states().iter().zip(potential.states()).map(|(a, b)| difference(a, b));
    let largest = differences.fold(0.0, f64::max);
    println!("force and potential differ by {largest:.1e}");
    assert!(largest < 1e-12);
}

#[test]
fn the_halves_mirror_each_other() {
    for run in run_both() {
        let largest = run.states().iter().map(asymmetry).fold(0.0, f64::max);
        println!("{largest:.1e}");
        assert!(largest < 1e-13);
        let moved = difference(&run.states()[0], run.last());
        assert!(moved > 0.1, "the string moves");
    }
}

#[test]
fn the_energy_deviates_as_in_the_reproduction() {
    let [force, potential] = run_both();
    let watched = potential.drift(Invariant::Energy).unwrap();
    assert!(abs_diff_eq!(watched.start(), ENERGY, epsilon = 1e-12), "{}", watched.start());
    assert!((watched.max_abs() + ENERGY_DEVIATION[0]).abs() < 1e-10, "{}", watched.max_abs());
    assert!(force.drift(Invariant::Energy).is_none(), "a force that declares no potential claims no energy");
    for run in [&force, &potential] {
        let deviations = run.states().iter().map(|state| Energies::of(state).total() - ENERGY);
        let (low, high) = deviations.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
        println!("{low} {high:.1e}");
        assert!((low - ENERGY_DEVIATION[0]).abs() < 1e-10 && high.abs() < 1e-12, "{low} {high}");
    }
}

#[test]
fn the_pinned_ends_stay() {
    for run in run_both() {
        for state in run.states() {
            assert_eq!([state.q[0], state.q[PARTICLES - 1], state.v[0], state.v[PARTICLES - 1]], [[0.0]; 4]);
        }
        assert_abs_diff_eq!(run.last().t, STEPS as f64 * DT, epsilon = 1e-15);
    }
}

/// The energy-exact scheme on the potential form keeps what leap-frog moves by one part in 800, through the corner at s = 0.
#[test]
fn the_discrete_gradient_keeps_the_energy_of_the_string() {
    let scene = tent().chain(SPRING).field(WEIGHT);
    let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(DT).run(STEPS).unwrap();
    let drift = run.drift(Invariant::Energy).unwrap();
    println!("{run}");
    assert!(drift.max_relative() < 1e-12);
    // At rest there is no kinetic energy that its error could be relative to.
    assert!(!run.to_string().contains("inf"), "{run}");
}
