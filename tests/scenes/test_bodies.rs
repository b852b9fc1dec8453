//! Bodies that feel the others and do not act on them.

use dmech::models::pairs::{Gravity, LennardJones, Spring};
use dmech::prelude::*;

const G: Gravity = Gravity { g: 1.0 };

fn sun_and_planet() -> Scene<2> {
    Scene::new().body(1.0, [0.0, 0.0], [0.0, -0.02]).body(0.02, [1.0, 0.0], [0.0, 1.0])
}

fn apart(x: &[[f64; 2]], y: &[[f64; 2]]) -> f64 {
    x.iter().flatten().zip(y.iter().flatten()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// A mass that is almost nothing moves as a test body of any mass does, and the others as if it were not there.
#[test]
fn the_limit_of_a_vanishing_mass() {
    let (q, v) = ([0.4, 0.9], [-0.8, 0.5]);
    fn end<L: dmech::scene::Term<2, ()>, S: Scheme<dmech::scene::SceneSystem<2, L::Ready>>>(
        scene: Scene<2, (), L>,
        scheme: S,
    ) -> Vec<[f64; 2]> {
        Simulation::scene(scene).scheme(scheme).dt(0.002).run(2000).unwrap().last().q.clone()
    }
    macro_rules! every {
        ($($scheme:expr),*) => {$({
            let alone = end(sun_and_planet().pairs(G), $scheme);
            let light = end(sun_and_planet().body(1e-15, q, v).pairs(G), $scheme);
            let test = end(sun_and_planet().test_body(3.0, q, v).test_body(1.0, [2.0, 0.1], [0.0, 0.7]).pairs(G), $scheme);
            assert!(apart(&test[..2], &alone) < 1e-12, "{}: {:e}", stringify!($scheme), apart(&test[..2], &alone));
            assert!(apart(&test[..3], &light) < 1e-11, "{}: {:e}", stringify!($scheme), apart(&test[..3], &light));
        })*};
    }
    every!(Explicit, Leapfrog, ForceGradient::order4(), Implicit, DiscreteGradient, Composed::order4(DiscreteGradient));
}

/// Many of them, before, between and after bodies that act, eight at a time and singly: the sums by hand.
#[test]
fn forces_are_those_of_the_bodies_that_act() {
    let law = Gravity { g: 0.7 };
    for (first, period) in [(0, 3), (1, 2), (9, 4), (3, 11), (0, 30), (29, 30), (8, 9)] {
        let acts = |i: usize| (i + first).is_multiple_of(period) || i == 13;
        let place = |i: usize| {
            [(1.3 * i as f64).sin() * (2.0 + 0.1 * i as f64), (0.9 * i as f64).cos() * (3.0 - 0.05 * i as f64)]
        };
        let mass = |i: usize| 0.5 + 0.03 * i as f64;
        let scene = (0..30).fold(Scene::new(), |scene, i| {
            if acts(i) { scene.body(mass(i), place(i), [0.0; 2]) } else { scene.test_body(mass(i), place(i), [0.0; 2]) }
        });
        // From rest a kick of leap-frog is h a.
        let h = 1e-9;
        let run = Simulation::scene(scene.pairs(law)).scheme(Explicit).dt(h).run(1).unwrap();
        for i in 0..30 {
            let mut fall = [0.0; 2];
            for j in (0..30).filter(|&j| j != i && acts(j)) {
                let d = [0, 1].map(|k| place(j)[k] - place(i)[k]);
                let r = d[0].hypot(d[1]);
                fall = [0, 1].map(|k| fall[k] + 0.7 * mass(j) * d[k] / r.powi(3));
            }
            let error = apart(&[run.last().v[i].map(|v| v / h)], &[fall]) / fall[0].hypot(fall[1]);
            assert!(error < 1e-13, "{period}, body {i}: {error:e}");
        }
    }
}

/// The Jacobian has the row of a test body, and in the rows of the others nothing of it: Newton's method takes as many
/// corrections as with a mass that is almost nothing, whatever the order of the bodies.
#[test]
fn corrections_are_those_of_a_vanishing_mass() {
    let (q, v) = ([0.45, 0.1], [0.0, 1.3]);
    let sun = |scene: Scene<2>| scene.body(1.0, [0.0, 0.0], [0.0, 0.0]);
    macro_rules! alike {
        ($($scheme:expr),*) => {$({
            // Of all pairs the body that acts comes first; on bonds the one that is named first.
            let took = |scene: Scene<2>| {
                let pairs = Simulation::scene(scene.clone().pairs(G)).scheme($scheme).dt(0.02).run(100).unwrap();
                let bonds = Simulation::scene(scene.bonds(G, [(0, 1)])).scheme($scheme).dt(0.02).run(100).unwrap();
                assert!(pairs.report().iterations().abs_diff(bonds.report().iterations()) <= 2);
                bonds.report().iterations()
            };
            for (test, light) in [
                (sun(Scene::new()).test_body(3.0, q, v), sun(Scene::new()).body(1e-15, q, v)),
                (sun(Scene::new().test_body(3.0, q, v)), sun(Scene::new().body(1e-15, q, v))),
            ] {
                let (test, light) = (took(test), took(light));
                assert!(test.abs_diff(light) <= 2 && light > 100, "{}: {test} and {light}", stringify!($scheme));
            }
        })*};
    }
    alike!(Implicit, DiscreteGradient);
}

/// What is watched are the bodies that act: they are a closed system.
#[test]
fn invariants_are_those_of_the_bodies_that_act() {
    let scene = sun_and_planet().test_body(5.0, [0.4, 0.9], [-0.8, 0.5]).pairs(G);
    let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.01).run(2000).unwrap();
    for invariant in [Invariant::Energy, Invariant::WorkEnergy, Invariant::LinearMomentum, Invariant::AngularMomentum] {
        let drift = run.drift(invariant).unwrap();
        assert!(drift.max_abs() < 1e-13, "{invariant:?}: {:e}", drift.max_abs());
    }
    let alone = Simulation::scene(sun_and_planet().pairs(G)).scheme(DiscreteGradient).dt(0.01).run(1).unwrap();
    let energy = |run: &Run<SceneState<2>>| run.drift(Invariant::Energy).unwrap().start();
    assert!((energy(&run) - energy(&alone)).abs() < 1e-15);
}

/// Along a chain, on bonds and within a cut-off in a box: explicit and implicit steps agree in the limit of small ones.
#[test]
fn every_link_is_one_sided() {
    let spring = Spring { k: 2.0, length: 1.0 };
    let row = || {
        Scene::<2>::new()
            .body(1.0, [0.0, 0.0], [0.0, 0.1])
            .body(2.0, [1.1, 0.0], [0.1, 0.0])
            .test_body(0.5, [2.0, 0.3], [0.0, 0.0])
            .test_body(0.7, [2.9, 0.0], [0.0, -0.2])
    };
    macro_rules! agree {
        ($scene:expr) => {{
            let end = |state: SceneState<2>| state.q;
            let leapfrog = Simulation::scene($scene).scheme(Leapfrog).dt(1e-3).run(1000).unwrap();
            let exact = Simulation::scene($scene).scheme(DiscreteGradient).dt(1e-3).run(1000).unwrap();
            let energy = exact.drift(Invariant::Energy).unwrap().max_abs();
            assert!(energy < 1e-13, "{energy:e}");
            let error = apart(&end(leapfrog.last().clone()), &end(exact.last().clone()));
            // Where the force jumps, leap-frog is off by the jump times the step.
            assert!(error < 1e-3, "{error:e}");
            end(exact.last().clone())
        }};
    }
    let chain = agree!(row().chain(spring));
    let bonds = agree!(row().bonds(spring, [(0, 1), (1, 2), (2, 3)]));
    assert!(apart(&chain, &bonds) < 1e-12);
    // Two test bodies do not feel each other: the last one flies on.
    assert!(apart(&chain[3..], &[[2.9, -0.2]]) < 1e-12);
    let atoms = LennardJones { epsilon: 1.0, sigma: 0.9 };
    agree!(row().pairs(atoms).cutoff(1.8).periodic([4.0, 4.0]));
    agree!(row().pairs(atoms).periodic([4.0, 4.0]));
}

/// Walls along a magnetic field.
#[derive(Clone, Copy, Debug)]
struct Trough {
    wall: f64,
    b: f64,
}

#[dmech::law]
impl Trough {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.wall * (q[0].abs() - 0.2).max(0.0).powi(2)
    }

    #[force]
    fn magnetic(&self, v: [f64; 2]) -> [f64; 2] {
        [self.b * v[1], -self.b * v[0]]
    }
}

/// A test body in a magnetic field and among walls: cut-off far beyond all, where equations are solved by products, all pairs, where they
/// are eliminated, a chain and bonds are the same motion.
#[test]
fn one_sided_links_are_the_same_motion_however_they_are_solved() {
    fn end<L, S>(scene: Scene<2, (), L>, scheme: S, dt: f64) -> Vec<[f64; 2]>
    where
        L: dmech::scene::Term<2, ()>,
        S: Scheme<dmech::scene::SceneSystem<2, L::Ready>>,
    {
        Simulation::scene(scene).scheme(scheme).dt(dt).run(150).unwrap().last().q.clone()
    }

    let tie = Spring { k: 2.0, length: 0.0 };
    for mass in [1.0, 0.2, 0.03] {
        for (wall, b) in [(0.0, 0.8), (1.0, 0.8), (0.0, 3.0), (2.0, 0.1)] {
            let two = || Scene::new().body(1.0, [0.5, 0.1], [0.1, 0.4]).test_body(mass, [0.2, -0.9], [0.4, 0.1]);
            let two = || two().field(Trough { wall, b });
            macro_rules! alike {
                ($($scheme:expr),*) => {$({
                    let pairs = end(two().pairs(tie), $scheme, 0.05);
                    let others = [
                        end(two().pairs(tie).cutoff(1e3), $scheme, 0.05),
                        end(two().chain(tie), $scheme, 0.05),
                        end(two().bonds(tie, [(0, 1)]), $scheme, 0.05),
                    ];
                    for other in others {
                        let apart = apart(&pairs, &other);
                        assert!(apart < 1e-9, "{}, m = {mass}, {wall}, {b}: {apart:e}", stringify!($scheme));
                    }
                })*};
            }
            alike!(DiscreteGradient, Implicit, Composed::order4(DiscreteGradient));
        }
    }
}
