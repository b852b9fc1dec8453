//! What closed scenes keep, over 10⁵ steps.

use dmech::models::pairs::{
    Charge, Coulomb, FermiPastaUlamTsingou, Gravity, Hertz, HertzSpheres, LennardJones, Morse, Sphere, Spring, Toda,
};
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};
use dmech_tests::few::planets;
use rayon::prelude::*;

fn ions() -> Scene<3, Charge> {
    Scene::new()
        .body_with(1.0, [1.2, 0.0, 0.2], [0.0, 1.05, 0.0], Charge { q: 1.0 })
        .body_with(6.0, [0.0, 0.1, 0.0], [0.0, -0.15, 0.02], Charge { q: -1.5 })
        .body_with(1.5, [0.0, 4.0, -0.5], [-0.42, 0.0, 0.1], Charge { q: 0.7 })
}

/// Seven atoms near a hexagon with one in the middle.
fn atoms() -> Scene<2> {
    (0..6).fold(Scene::new().body(1.3, [0.05, -0.02], [0.0, 0.0]), |scene, i| {
        let angle = f64::from(i) * std::f64::consts::FRAC_PI_3;
        let r = 1.15 + 0.02 * f64::from(i % 3);
        scene.body(1.0 + 0.1 * f64::from(i), [r * angle.cos(), r * angle.sin()], [0.05 * angle.sin(), -0.03])
    })
}

/// Five balls of different sizes, apart.
fn balls() -> Scene<2, Sphere> {
    (0..5).fold(Scene::new(), |scene, i| {
        let (x, radius) = (f64::from(i), 0.5 + 0.1 * f64::from(i));
        let (sin, cos) = (1.3 * x).sin_cos();
        scene.body_with(radius.powi(3), [2.5 * cos, 2.1 * sin], [0.3 * sin, 0.2 * cos], Sphere { radius })
    })
}

/// Masses 1, 1.25, 1.5, … on a line, bent.
fn chain<const N: usize>() -> Scene<1> {
    (0..N).fold(Scene::new(), |scene, i| {
        let x = i as f64;
        scene.body(1.0 + 0.25 * (i % 5) as f64, [0.4 * (1.7 * x).sin()], [0.3 * (0.9 * x).cos()])
    })
}

const STEPS: u64 = 100_000;

/// Energy of `DiscreteGradient` and discrete energy of `Kanatani`, and both momenta, over 10⁵ steps.
///
/// The scale of an angular momentum that may be small is Σ m |q| |v| of the start.
fn keeps_everything<const D: usize, P: Clone, L: Term<D, P> + Clone>(name: &str, scene: Scene<D, P, L>, dt: f64)
where
    DiscreteGradient: Scheme<SceneSystem<D, L::Ready>>,
    Kanatani: Scheme<SceneSystem<D, L::Ready>>,
{
    let check = |run: &Run<SceneState<D>>, energy: Invariant| {
        let energy = run.drift(energy).expect("a closed system has an energy");
        let momentum = run.drift(Invariant::LinearMomentum).expect("a closed system has a linear momentum");
        let start = &run.states()[0];
        let norm = |x: &[f64; D]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let speed: f64 = start.v.iter().map(norm).sum();
        let lever: f64 = start.q.iter().zip(&start.v).map(|(q, v)| norm(q) * norm(v)).sum();
        let angular = run.drift(Invariant::AngularMomentum);
        assert_eq!(angular.is_some(), D > 1, "{name}");
        let angular = angular.map_or(0.0, |drift| drift.max_abs() / lever);
        let (energy, linear) = (energy.max_relative(), momentum.max_abs() / speed);
        println!("{name:<12} {:<16} {energy:8.1e} {linear:8.1e} {angular:8.1e}", run.report().scheme());
        assert!(energy < 1e-12 && linear < 1e-12 && angular < 1e-12, "{name}\n{run}");
    };
    let simulation = || Simulation::scene(scene.clone()).dt(dt).record_every(100);
    check(&simulation().scheme(DiscreteGradient).run(STEPS).unwrap(), Invariant::Energy);
    // As many stages, and more.
    check(&simulation().scheme(Composed::order4(DiscreteGradient)).run(STEPS / 4).unwrap(), Invariant::Energy);
    check(&simulation().scheme(Kanatani).run(STEPS).unwrap(), Invariant::DiscreteEnergy);
}

#[test]
fn closed_systems_keep_energy_and_momenta() {
    println!("largest deviation over {STEPS} steps: energy, linear and angular momentum");
    // A ring, or the beads would soon be apart for good.
    const RING: [(usize, usize); 9] = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 6), (6, 7), (7, 8), (8, 0)];
    let systems: [fn(); 9] = [
        // To t = 200: their motion is chaotic, and beyond 320 some start among ten neighbours leads to an encounter too close for a step.
        || keeps_everything("gravity", planets().pairs(Gravity { g: 0.9 }), 0.002),
        || keeps_everything("Coulomb", ions().pairs(Coulomb { k: 1.1 }), 0.01),
        || keeps_everything("Lennard-Jones", atoms().pairs(LennardJones { epsilon: 1.2, sigma: 1.02 }), 0.004),
        || {
            keeps_everything(
                "FPUT",
                chain::<17>().chain(FermiPastaUlamTsingou { k: 1.3, alpha: 0.25, beta: 0.4 }),
                0.05,
            )
        },
        || keeps_everything("Toda", chain::<17>().chain(Toda { a: 0.8, b: 1.4 }), 0.05),
        || keeps_everything("Morse", atoms().pairs(Morse { depth: 1.1, width: 2.3, length: 1.05 }), 0.01),
        || keeps_everything("springs", atoms().pairs(Spring { k: 1.7, length: 1.1 }), 0.01),
        || keeps_everything("Hertz", chain::<9>().bonds(Hertz { k: 2.0 }, RING), 0.02),
        || {
            let drawn_together = balls().pairs(Spring { k: 0.3, length: 0.0 });
            keeps_everything("spheres", drawn_together.pairs(HertzSpheres { modulus: 60.0 }), 0.01);
        },
    ];
    systems.into_par_iter().for_each(|keeps| keeps());
}
