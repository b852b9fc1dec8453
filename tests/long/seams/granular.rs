//! A chain of beads that touch and do not stick: Hertzian contacts, open wherever the wave is not.
//!
//! q_j is how far bead j has moved from where it just touches its neighbours, so that d = q_a − q_b is the overlap of a bead
//! with the next. A strike at one end runs through the chain as a solitary wave some five beads long, whose speed grows
//! as the sixth root of its largest force (V. F. Nesterenko, J. Appl. Mech. Tech. Phys. 24 (1983) 733).

use approx::abs_diff_eq;
use dmech::models::pairs::Hertz;
use dmech::prelude::*;

const CONTACT: Hertz = Hertz { k: 0.4 };
const BEADS: usize = 100;

/// All at rest but the first.
fn struck(speed: f64) -> Scene<1> {
    (0..BEADS).fold(Scene::new(), |scene, j| scene.body(1.0, [0.0], [if j == 0 { speed } else { 0.0 }]))
}

#[test]
fn a_struck_chain_keeps_energy_and_momentum() {
    let simulation = |dt: f64| Simulation::scene(struck(1.3).chain(CONTACT)).dt(dt).record_every(100);
    let exact = |run: Result<Run<SceneState<1>>, Interrupted<SceneState<1>>>, invariant| {
        let run = run.expect("every step has a root");
        let drifts = [invariant, Invariant::LinearMomentum].map(|i| run.drift(i).expect("it is kept").max_relative());
        // The wave is through: what moves moves apart.
        let state = run.last();
        assert!((1..BEADS).all(|j| state.q[j - 1][0] - state.q[j][0] <= 1e-6), "contacts are open");
        drifts
    };
    let [energy, momentum] = exact(simulation(0.02).scheme(DiscreteGradient).run(100_000), Invariant::Energy);
    assert!(energy < 1e-13 && momentum < 1e-13, "{energy:e} {momentum:e}");
    let [energy, momentum] = exact(simulation(0.02).scheme(Kanatani).run(20_000), Invariant::DiscreteEnergy);
    assert!(energy < 1e-13 && momentum < 1e-13, "Kanatani: {energy:e} {momentum:e}");
    let composed = Composed::order4(DiscreteGradient);
    let [energy, momentum] = exact(simulation(0.05).scheme(composed).run(8_000), Invariant::Energy);
    assert!(energy < 1e-13 && momentum < 1e-13, "composed: {energy:e} {momentum:e}");
}

/// When a contact is pressed hardest, and by which force.
fn hardest(run: &Run<SceneState<1>>, contact: usize) -> (f64, f64) {
    let force = |state: &SceneState<1>| CONTACT.force(state.q[contact][0] - state.q[contact + 1][0]);
    let forces: Vec<f64> = run.states().iter().map(force).collect();
    let most = (1..forces.len() - 1).max_by(|&i, &j| forces[i].total_cmp(&forces[j])).expect("states");
    // The top of the parabola through three records.
    let [before, at, after] = [forces[most - 1], forces[most], forces[most + 1]];
    let shift = 0.5 * (before - after) / (before - 2.0 * at + after);
    let dt = run.states()[1].t - run.states()[0].t;
    (run.states()[most].t + shift * dt, at - 0.25 * (before - after) * shift)
}

#[test]
fn the_wave_is_faster_by_the_sixth_root_of_its_force() {
    let wave = |speed: f64, exact: bool| {
        // The time that a contact lasts.
        let unit = speed.powf(-0.2);
        let simulation = Simulation::scene(struck(speed).chain(CONTACT)).dt(0.01 * unit).record_every(5);
        let run = if exact {
            simulation.scheme(DiscreteGradient).run_until(120.0 * unit)
        } else {
            simulation.scheme(Leapfrog).run_until(120.0 * unit)
        };
        let run = run.expect("every step has a root");
        let [(early, _), (late, force)] = [40, 80].map(|contact| hardest(&run, contact));
        (40.0 / (late - early), force)
    };
    for exact in [true, false] {
        let waves: Vec<(f64, f64)> = [0.003, 0.1, 1.0, 17.0].map(|speed| wave(speed, exact)).into();
        for pair in waves.windows(2) {
            let [(slow, weak), (fast, strong)] = [pair[0], pair[1]];
            let exponent = (fast / slow).ln() / (strong / weak).ln();
            assert!(abs_diff_eq!(exponent, 1.0 / 6.0, epsilon = 1e-4), "v ∝ F^{exponent}");
        }
    }
}

/// Every scheme that a scene has goes through the contacts and keeps the momentum.
#[test]
fn all_schemes_pass_through_contacts() {
    macro_rules! passes {
        ($($scheme:expr, $drift:expr;)*) => {$({
            let simulation = Simulation::scene(struck(1.3).chain(CONTACT)).scheme($scheme).dt(0.02);
            let run = simulation.record_every(50).run(5_000).expect("it reaches its end");
            let momentum = run.drift(Invariant::LinearMomentum).expect("it is kept").max_relative();
            assert!(momentum < 1e-13, "{}: {momentum:e}", stringify!($scheme));
            let energy = run.drift(Invariant::Energy).map_or(0.0, |drift| drift.max_relative());
            assert!(energy < $drift, "{}: {energy:e}", stringify!($scheme));
        })*};
    }
    passes! {
        // It gains energy in every contact.
        Explicit, f64::INFINITY;
        Leapfrog, 2e-3;
        Implicit, 2e-3;
        DiscreteGradient, 1e-13;
        Kanatani, 2e-3;
        Composed::order4(Leapfrog), 2e-3;
        Composed::order6(DiscreteGradient), 1e-13;
        Nystrom::order4(), 2e-3;
        Nystrom::order6(), 2e-3;
    }
}
