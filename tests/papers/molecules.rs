//! Greenspan §6, three molecules, by the code of `examples/three_molecules.rs`, against the same computation made
//! independently.

#[path = "../../examples/shared/section_6.rs"]
mod section_6;

use approx::{assert_abs_diff_eq, relative_eq};
use dmech::prelude::*;
use section_6::{DT, implicit, kinetic_energy};

/// Step, and the three positions: an independent reproduction in binary64, 80-bit and 72-digit arithmetic. A perturbation
/// of the start has grown 49-fold at step 1700; with increments as unknowns 1e-9 is meaningful.
#[rustfmt::skip]
const REPRODUCTION: [(usize, [[f64; 2]; 3]); 5] = [
    (0, [[0.0, 100.0], [100.0, 0.0], [-100.0, 0.0]]),
    (50, [[-0.008024468771461249, 93.28667303070982], [92.8137324463308, 0.9040405852942165], [-99.28028226645577, 0.08982270079004626]]),
    (500, [[-233.94037383897643, -10.12986559513408], [-130.06143224366187, -78.68433792779089], [-37.23642527661967, 17.32741468997106]]),
    (1000, [[33.39788640843857, -66.50750797641118], [-73.92006109052656, -33.034515374293335], [-66.8063999518216, -144.47244113158618]]),
    (1700, [[112.0052261228786, -90.5452235250227], [75.34434190497254, -160.4505230103767], [24.255422921664767, -93.41157279948155]]),
];

fn largest_difference(run: &Run<SceneState<2>>) -> f64 {
    let mut largest = 0.0_f64;
    for (step, positions) in REPRODUCTION {
        let state = &run.states()[step];
        assert_eq!(state.t, step as f64 * DT);
        let pairs = state.q.as_flattened().iter().zip(positions.as_flattened());
        let difference = pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        println!("step {step:>4} {difference:.1e}");
        largest = largest.max(difference);
    }
    largest
}

#[test]
fn molecules_are_where_the_reproduction_has_them() {
    let run = implicit(Newton::predicted(), 1700).unwrap();
    assert!(largest_difference(&run) < 1e-9);
}

/// "Newton's method with initial guess (x̄, ȳ)ₖ = (x, y)ₖ₋₁" (§6). The root is the same, found with more corrections.
#[test]
fn newton_may_start_from_the_position_before_as_in_the_paper() {
    let predicted = implicit(Newton::predicted(), 1700).unwrap();
    let run = implicit(Newton::from_previous(), 1700).unwrap();
    assert!(largest_difference(&run) < 1e-9);
    assert!(run.report().iterations() > predicted.report().iterations());
}

/// The velocities are the recursion v′ = 2Δx/Δt − v of (6.6), which the sums of (6.7) equal.
#[test]
fn velocities_obey_the_recursion() {
    let run = implicit(Newton::predicted(), 1700).unwrap();
    let mut fastest = 0.0_f64;
    for pair in run.states().windows(2) {
        for body in 0..3 {
            for k in 0..2 {
                let mean = 0.5 * (pair[0].v[body][k] + pair[1].v[body][k]);
                let moved = (pair[1].q[body][k] - pair[0].q[body][k]) / DT;
                // The quotient magnifies the rounding of positions up to 512 by 1/Δt.
                assert!((mean - moved).abs() < 2.0 * 256.0 * f64::EPSILON / DT, "{mean} {moved}");
                fastest = fastest.max(mean.abs());
            }
        }
    }
    assert!(fastest > 10.0, "the molecules move");
}

/// What the paper calls viscous damping acts along the separation with the speed of the particle itself: it attracts, and
/// the molecules gain energy.
#[test]
fn the_term_called_damping_drives_the_molecules() {
    let run = implicit(Newton::predicted(), 200).unwrap();
    assert_abs_diff_eq!(kinetic_energy(&run.states()[0]), 1005.0, epsilon = 1e-9);
    assert!(relative_eq!(kinetic_energy(run.last()), 165_045.0, max_relative = 1e-5), "{}", kinetic_energy(run.last()));
    let work = run.drift(Invariant::WorkEnergy).unwrap();
    assert!(work.max_abs() < 1e-12 * kinetic_energy(run.last()), "{}", work.max_abs());
    for lost in [Invariant::Energy, Invariant::LinearMomentum, Invariant::AngularMomentum] {
        assert!(run.drift(lost).is_none(), "no {lost} is claimed");
    }
}
