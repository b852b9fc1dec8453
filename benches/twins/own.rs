//! The same scenes by the project.

use dmech::models::pairs::{Gravity, LennardJones};
use dmech::prelude::*;
use dmech::scene::{Acts, Chain, Linked, SceneSystem, Term, Vectors};

use super::Loop;

/// k d²/2 + β d⁴/4: the library's spring has a cubic term as well, which takes time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bond {
    k: f64,
    beta: f64,
}

#[dmech::law]
impl Bond {
    #[pair]
    fn energy(&self, d: f64) -> f64 {
        0.5 * self.k * d * d + 0.25 * self.beta * d.powi(4)
    }
}

/// Three bodies of mass 1 in the plane as one law of six coordinates, g = 1.
#[derive(Clone, Copy, Debug)]
struct ThreeBodies {
    g: f64,
}

#[dmech::law]
impl ThreeBodies {
    #[potential]
    fn energy(&self, q: [f64; 6]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let (x, y) = (q[2 * i] - q[2 * j], q[2 * i + 1] - q[2 * j + 1]);
                sum -= self.g / (x * x + y * y).sqrt();
            }
        }
        sum
    }
}

fn scene_loop<const D: usize, A: Acts<D> + 'static, S: Scheme<SceneSystem<D, A>> + 'static>(
    mut stepper: Stepper<SceneSystem<D, A>, S>,
    look: impl Fn(&Vectors<D>) -> f64 + 'static,
) -> Loop {
    Box::new(move |steps| {
        stepper.advance(steps).expect("a finite motion");
        look(&stepper.q())
    })
}

/// Gravitating bodies at rest: masses times g and positions.
pub(super) fn gravity(bodies: &[(f64, [f64; 3])], dt: f64) -> Loop {
    let mut scene = Scene::new();
    for &(mass, q) in bodies {
        scene = scene.body(mass, q, [0.0; 3]);
    }
    let simulation = Simulation::scene(scene.pairs(Gravity { g: 1.0 })).scheme(Leapfrog).dt(dt);
    scene_loop(simulation.stepper().expect("a scene"), |q| q.get(0)[0])
}

/// A chain with fixed ends, at rest.
pub(super) fn chain<S>(scheme: S, q: &[f64], k: f64, beta: f64, dt: f64) -> Loop
where
    S: Scheme<SceneSystem<1, <((), Linked<Bond, Chain>) as Term<1, ()>>::Ready>> + 'static,
{
    let mut scene = Scene::new().body(1.0, [0.0], [0.0]);
    for &q in q {
        scene = scene.body(1.0, [q], [0.0]);
    }
    let n = q.len();
    let scene = scene.body(1.0, [0.0], [0.0]).chain(Bond { k, beta }).pin(0).pin(n + 1);
    let simulation = Simulation::scene(scene).scheme(scheme).dt(dt);
    scene_loop(simulation.stepper().expect("a scene"), move |q| q.get(n / 2 + 1)[0])
}

/// The figure eight, unrolled and as a scene.
pub(super) fn eight(q: [f64; 6], v: [f64; 6], dt: f64) -> [Loop; 2] {
    let law = Simulation::new(ThreeBodies { g: 1.0 }, State::new(q, v)).scheme(Leapfrog).dt(dt);
    let mut law = law.stepper().expect("a law");
    let unrolled: Loop = Box::new(move |steps| {
        law.advance(steps).expect("a finite motion");
        law.q()[0]
    });
    let mut scene = Scene::new();
    for i in 0..3 {
        scene = scene.body(1.0, [q[2 * i], q[2 * i + 1]], [v[2 * i], v[2 * i + 1]]);
    }
    let simulation = Simulation::scene(scene.pairs(Gravity { g: 1.0 })).scheme(Leapfrog).dt(dt);
    [unrolled, scene_loop(simulation.stepper().expect("a scene"), |q| q.get(0)[0])]
}

/// 4 n³ atoms of Lennard-Jones as dense as a liquid, cut off at 2.5 in a periodic box. They melt before they are timed.
pub(super) fn liquid(n: usize, dt: f64) -> Loop {
    let spacing = (4.0 / 0.8442_f64).cbrt();
    let basis = [[0.25, 0.25, 0.25], [0.25, 0.75, 0.75], [0.75, 0.25, 0.75], [0.75, 0.75, 0.25]];
    let mut scene = Scene::<3>::new();
    let mut dice = 1_u64;
    for cell in 0..n.pow(3) {
        let corner = [cell / n / n, cell / n % n, cell % n].map(|x| x as f64);
        for at in basis {
            let speeds = [(); 3].map(|()| {
                dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                4.15 * ((dice >> 11) as f64 / (1_u64 << 53) as f64 - 0.5)
            });
            scene = scene.body(1.0, [0, 1, 2].map(|k| spacing * (corner[k] + at[k])), speeds);
        }
    }
    let scene = scene.pairs(LennardJones::default()).cutoff(2.5).periodic([spacing * n as f64; 3]);
    let mut stepper = Simulation::scene(scene).scheme(Leapfrog).dt(dt).stepper().expect("a scene");
    stepper.advance(100).expect("a finite motion");
    scene_loop(stepper, |q| q.get(0)[0])
}
