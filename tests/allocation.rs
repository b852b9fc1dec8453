//! Steps of generated laws do not allocate: central, linear and Newton laws, forces, masses per coordinate, every scheme.

use std::hint::black_box;

use dmech::prelude::*;

#[path = "../dmech-core/tests/common/counting.rs"]
mod counting;
mod laws;
use counting::allocations;
use laws::*;

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

/// Step by step, with the state read, and many at once.
fn check<L, S, const D: usize>(simulation: Simulation<L, State<D>, S>, what: &str)
where
    L: Law<D>,
    S: Scheme<L, D>,
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
            one! { Implicit, $($law)* }
            one! { DiscreteGradient, $($law)* }
            one! { Kanatani, $($law)* }
        };
    }
    for_each_law!(every);
    assert_eq!(checked, 5 * 12);
}

#[test]
fn no_step_under_a_force_allocates() {
    let motion = Simulation::new(Damped { k: 0.7, c: 0.2, omega: 1.9 }, State::new([0.7, -0.4], [0.3, 0.8])).mass(1.3);
    check(motion.clone().scheme(Explicit), "Explicit");
    check(motion.clone().scheme(Implicit), "Implicit");
    check(motion.scheme(DiscreteGradient), "DiscreteGradient");
}
