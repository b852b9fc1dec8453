//! Steps of generated laws do not allocate: central, linear and Newton laws, forces, masses per coordinate, every scheme.

use std::hint::black_box;

use dmech::prelude::*;

use dmech_tests::for_each_law;
use dmech_tests::laws::*;
use dmech_tests::memory::allocations;
use dmech_tests::motion::RELAXED_6;

/// A pulsating quartic bowl with drag: force, velocity, mass and time.
#[derive(Clone, Copy, Debug)]
struct Damped {
    k: f64,
    c: f64,
    omega: f64,
}

#[dmech::law]
impl Damped {
    #[potential]
    fn bowl(&self, q: [f64; 2], t: f64) -> f64 {
        self.k * (1.3 + (self.omega * t).sin()) * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2)
    }

    #[force]
    fn drag(&self, v: [f64; 2], m: f64) -> [f64; 2] {
        [-self.c * m * v[0], -self.c * v[1] * v[1].abs()]
    }
}

/// As a row of the table.
const GAUSS: Gauss = Gauss::order16();

/// Step by step, with the state read, and many at once.
fn check<L, S, const D: usize>(simulation: Simulation<L, State<D>, S>, what: &str)
where
    L: Law<D>,
    S: Scheme<Particle<L, D>>,
{
    let mut stepper = simulation.dt(0.01).stepper().unwrap();
    let start = stepper.state();
    let counted = allocations(|| {
        for _ in 0..500 {
            stepper.step().unwrap();
            black_box(stepper.state());
        }
        stepper.advance(500).unwrap();
        black_box(stepper.q());
    });
    assert_eq!(stepper.steps(), 1000);
    assert_ne!(stepper.q(), start.q, "{what}: nothing moved");
    assert_eq!(counted, 0, "{what}");
}

#[test]
fn no_step_allocates() {
    let mut checked = 0;
    macro_rules! one {
        ($scheme:ident, $law:ident, $d:literal, $q:expr, $v:expr) => {{
            let what = concat!(stringify!($scheme), " on ", stringify!($law));
            let motion = Simulation::new($law::new(), State::<$d>::new($q, $v)).mass(1.3).scheme($scheme);
            check(motion.clone(), what);
            check(motion.masses(core::array::from_fn(|i| 0.7 + i as f64)), what);
            checked += 1;
        }};
    }
    macro_rules! every {
        ($($law:tt)*) => {
            one! { Explicit, $($law)* }
            one! { Leapfrog, $($law)* }
            one! { CompensatedLeapfrog, $($law)* }
            one! { Implicit, $($law)* }
            one! { DiscreteGradient, $($law)* }
            one! { Kanatani, $($law)* }
            one! { RELAXED_6, $($law)* }
            one! { GAUSS, $($law)* }
        };
    }
    for_each_law!(every);
    assert_eq!(checked, 8 * 12);
}

#[test]
fn no_step_under_a_force_allocates() {
    let motion = Simulation::new(Damped { k: 0.7, c: 0.2, omega: 1.9 }, State::new([0.7, -0.4], [0.3, 0.8])).mass(1.3);
    check(motion.clone().scheme(Explicit), "Explicit");
    check(motion.clone().scheme(Implicit), "Implicit");
    check(motion.clone().scheme(LineIntegral::order6()), "LineIntegral");
    check(motion.clone().scheme(Gauss::order16()), "Gauss");
    check(motion.scheme(DiscreteGradient), "DiscreteGradient");
}

/// Ten bodies in space, and a chain of them: the memory before a step, Newton matrices and factors are kept.
#[test]
fn no_step_of_a_scene_allocates() {
    use dmech::models::pairs::Spring;
    use dmech::scene::{SceneSystem, Term};

    fn check<L: Term<3, ()>, S: Scheme<SceneSystem<3, L::Ready>>>(
        scene: Scene<3, (), L>,
        scheme: S,
        dt: f64,
        what: &str,
    ) {
        let mut stepper = Simulation::scene(scene).scheme(scheme).dt(dt).stepper().unwrap();
        (0..10).for_each(|_| stepper.step().unwrap());
        let before = stepper.q().clone();
        let counted = allocations(|| {
            (0..100).for_each(|_| stepper.step().unwrap());
            stepper.advance(100).unwrap();
        });
        assert_ne!(*stepper.q(), before, "{what}: nothing moved");
        assert_eq!(counted, 0, "{what}, dt = {dt}");
    }

    let bodies = || {
        (0..10).fold(Scene::<3>::new(), |scene, i| {
            let f = f64::from(i);
            scene.body(1.0 + 0.1 * f, [1.1 * f, (2.0 * f).sin(), (0.7 * f).cos()], [0.2 * f.sin(), 0.0, 0.1])
        })
    };
    let spring = Spring { k: 3.0, length: 1.3 };
    let all = bodies().pairs(spring);
    let ring = bodies().bonds(spring, (0..10).map(|i| (i, (i + 1) % 10)));
    // Steps with a small Newton matrix, and steps that need its factors.
    for dt in [0.001, 0.1] {
        check(all.clone(), Explicit, dt, "pairs, Explicit");
        check(all.clone(), Leapfrog, dt, "pairs, Leapfrog");
        check(all.clone(), Implicit, dt, "pairs, Implicit");
        check(all.clone(), GAUSS, dt, "pairs, Gauss");
        check(bodies().chain(spring), LineIntegral::order6(), dt, "chain, LineIntegral");
        check(all.clone(), DiscreteGradient, dt, "pairs, DiscreteGradient");
        check(all.clone(), Relaxed::order6(), dt, "pairs, Relaxed");
        check(bodies().chain(spring), Relaxed::order8(), dt, "chain, Relaxed");
        check(bodies().chain(spring), RungeKuttaNystrom::order12(), dt, "chain, RungeKuttaNystrom");
        check(bodies().chain(spring), Kanatani, dt, "chain, Kanatani");
        check(bodies().chain(spring), DiscreteGradient, dt, "chain, DiscreteGradient");
    }
    // Factors of a sparse matrix are not among them: as rows change places in faer they fill up more, and room is made.
    check(ring, DiscreteGradient, 0.001, "bonds, DiscreteGradient");
}
