//! A force that does no work, v × B, leaves the energy of a scene as it leaves that of one body.

use dmech::models::pairs::{Charge, Coulomb};
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};

/// An anisotropic well and a field b (1 + α sin x + βy²) along z, with z along x: another at every place, or with α = β = c = 0 not.
#[derive(Clone, Copy, Debug)]
struct Trap {
    k: f64,
    b: f64,
    c: f64,
    varies: f64,
}

#[dmech::law]
impl Trap {
    #[potential]
    fn energy(&self, q: [f64; 3]) -> f64 {
        0.5 * self.k * (q[0] * q[0] + q[1] * q[1] + 1.7 * q[2] * q[2]) + 0.11 * self.k * q[0].powi(4)
    }

    #[force]
    fn magnetic(&self, q: [f64; 3], v: [f64; 3]) -> [f64; 3] {
        let along_z = self.b * (1.0 + self.varies * (0.8 * q[0].sin() + 0.3 * q[1] * q[1]));
        let along_x = self.c * q[2];
        [along_z * v[1], along_x * v[2] - along_z * v[0], -along_x * v[1]]
    }
}

/// −c v beside it.
#[derive(Clone, Copy, Debug)]
struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn force(&self, v: [f64; 3]) -> [f64; 3] {
        [-self.c * v[0], -self.c * v[1], -self.c * v[2]]
    }
}

const VARIES: Trap = Trap { k: 0.7, b: 2.7, c: 0.5, varies: 1.0 };
const UNIFORM: Trap = Trap { k: 0.0, b: 2.7, c: 0.0, varies: 0.0 };

/// Four ions of which one may be pinned.
fn ions(pinned: bool) -> Scene<3, Charge> {
    let places = [[0.9, 0.1, -0.3], [-0.8, 0.5, 0.2], [0.1, -1.1, 0.6], [-0.2, 0.3, -1.4]];
    let velocities = [[0.3, 0.5, 0.1], [-0.2, 0.4, -0.5], [0.6, -0.1, 0.2], [0.1, 0.2, 0.7]];
    places.into_iter().zip(velocities).zip(0_u8..).fold(Scene::new(), |scene, ((q, v), i)| {
        let charge = Charge { q: 0.5 + 0.2 * f64::from(i) };
        let v = if pinned && i == 2 { [0.0; 3] } else { v };
        let scene = scene.body_with(0.7 + 0.4 * f64::from(i), q, v, charge);
        if pinned && i == 2 { scene.pin(2) } else { scene }
    })
}

/// The energy of a scene is watched, must be exact, and is.
fn keeps<L, S>(what: &str, scene: Scene<3, Charge, L>, scheme: S)
where
    L: Term<3, Charge>,
    S: Scheme<SceneSystem<3, L::Ready>>,
{
    let run = Simulation::scene(scene).scheme(scheme).dt(0.05).run(2000).unwrap();
    let energy = run.drift(Invariant::Energy).unwrap_or_else(|| panic!("{what}: the energy is not watched"));
    println!("{what:<36} {:<42} energy {:.1e}", S::NAME, energy.max_relative());
    assert_eq!(run.kept(Invariant::Energy), Kept::Exact, "{what}, {}", S::NAME);
    assert!(energy.max_relative() < 1e-14, "{what}, {}: {energy:?}", S::NAME);
}

#[test]
fn the_energy_is_exact_in_a_magnetic_field() {
    for (name, trap) in [("a field that varies", VARIES), ("a uniform field", UNIFORM)] {
        keeps(name, ions(false).field(trap), DiscreteGradient);
        for pinned in [false, true] {
            let scene = ions(pinned).field(trap).pairs(Coulomb { k: 0.6 });
            keeps(&format!("{name}, pairs, pinned {pinned}"), scene.clone(), DiscreteGradient);
            keeps(&format!("{name}, pairs, pinned {pinned}"), scene, Composed::order4(DiscreteGradient));
        }
    }
}

/// The largest distance between the positions of two runs at their ends.
fn apart(a: &SceneState<3>, b: &SceneState<3>) -> f64 {
    let pairs = a.q.as_flattened().iter().zip(b.q.as_flattened());
    pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// The middle of the step costs neither its order nor that it is its own inverse; the way back is one in the opposite field.
#[test]
fn steps_are_of_second_order_and_lead_back() {
    let field = |trap| ions(false).field(trap).pairs(Coulomb { k: 0.6 });
    let end = |scene: &Scene<_, _, _>, steps: u32| {
        let dt = 2.0 / f64::from(steps);
        Simulation::scene(scene.clone()).scheme(DiscreteGradient).dt(dt).run(steps.into()).unwrap().last().clone()
    };
    let scene = field(VARIES);
    let [coarse, middle, fine] = [100, 200, 400].map(|steps| end(&scene, steps));
    let order = (apart(&coarse, &middle) / apart(&middle, &fine)).log2();
    assert!((order - 2.0).abs() < 0.03, "order {order}");

    let opposite = Trap { b: -VARIES.b, c: -VARIES.c, ..VARIES };
    let home = end(&field(opposite).starting_from(&fine.reversed()), 400);
    let start = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.1).run(0).unwrap();
    assert!(apart(&home, start.last()) < 1e-13, "{:e}", apart(&home, start.last()));
}

/// Beside a drag nothing is claimed of the energy; what it does is counted, to rounding.
#[test]
fn work_is_counted_beside_a_drag() {
    let scene = ions(false).field(VARIES).field(Drag { c: 0.05 }).pairs(Coulomb { k: 0.6 });
    let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.05).run(1000).unwrap();
    assert!(run.drift(Invariant::Energy).is_none());
    let work = run.drift(Invariant::WorkEnergy).unwrap();
    assert!(work.max_relative() < 1e-14, "{work:?}");
}
