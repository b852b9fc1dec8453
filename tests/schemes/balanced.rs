//! Bodies that are held where large forces cancel: the rounding of these is many times that of what is left of them, and a step has a root
//! where nothing else is left.

use dmech::extend::{Field, Law, Real};
use dmech::prelude::*;

// An arm of two links that motors hold up, by what they know of its angles and their rates.
#[derive(Clone, Copy, Debug)]
struct Held {
    gravity: f64,
    stiff: f64,
    damping: f64,
}

#[dmech::law]
impl Held {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.gravity * (2.0 * q[0].cos() + (q[0] + q[1]).cos())
    }

    #[force]
    fn motors(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        [-self.stiff * (q[0] - 0.7) - self.damping * v[0], -self.stiff * (q[1] - 0.4) - 0.7 * self.damping * v[1]]
    }
}

// The same with motors that are no stronger than they are.
#[derive(Clone, Copy, Debug)]
struct Weak {
    held: Held,
    most: f64,
}

#[dmech::law]
impl Weak {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.held.gravity * (2.0 * q[0].cos() + (q[0] + q[1]).cos())
    }

    #[force]
    fn motors(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        let one = -self.held.stiff * (q[0] - 0.7) - self.held.damping * v[0];
        let other = -self.held.stiff * (q[1] - 0.4) - 0.7 * self.held.damping * v[1];
        [one.clamp(-self.most, self.most), other.clamp(-self.most, self.most)]
    }
}

// A mass between three springs.
law!(Free, 2, |self, q| {
    let mut sum = 0.0;
    for i in 0..3 {
        let angle = 2.0943951023931953 * (i as f64);
        let stretch = (q[0] - angle.cos()).hypot(q[1] - angle.sin()) - 0.45;
        sum += 0.5 * self.k * stretch * stretch;
    }
    sum
});

// An arm that a stiff potential holds, in a medium.
law!(
    Arm,
    2,
    |self, q| 9.81 * (2.0 * q[0].sin() + (q[0] + q[1]).sin())
        + 0.5 * self.k * ((q[0] - 0.5).powi(2) + (q[1] - 0.4).powi(2)),
    |v| v.map(|v| -10.0 * v)
);

const HELD: Held = Held { gravity: 9.81, stiff: 90.0, damping: 15.0 };
const WEAK: Weak = Weak { held: HELD, most: 60.0 };

/// After a while nothing moves, and no force is left but the rounding of those that cancel.
macro_rules! rests {
    ($R:ident, $tried:ident, [$($scheme:expr),*], $law:expr, $q:expr, $large:expr) => {$({
        for dt in [1.0 / 120.0, 1.0 / 25.0] {
            let law = $law;
            let place = format!("{law:?} by {} in {}, {dt}", stringify!($scheme), stringify!($R));
            let start = State::of($q.map($R::from_f64), $q.map(|_| $R::ZERO));
            let run = Simulation::new(law, start).scheme($scheme).dt(dt).record_every(10_000).run_until(22.0);
            let run = run.unwrap_or_else(|e| panic!("{place}: {e}"));
            let State { q, v, .. } = *run.last();
            let left = law.field($R::ONE, $R::ZERO).slope(q, v).map(|x| x.to_f64().abs() / $large);
            let rounding = 1e3 * $R::EPSILON.to_f64().max(f64::EPSILON);
            assert!(v.iter().all(|v| v.to_f64().abs() < rounding), "{place}: {v:?}");
            assert!(left.iter().all(|&left| left < rounding), "{place}: {left:?}");
            $tried += 1;
        }
    })*};
}

/// Where motors hold an arm, strong ones or weak, or a potential does.
#[test]
fn what_is_held_comes_to_rest() {
    let mut tried = 0;
    rests!(f64, tried, [DiscreteGradient, Implicit, Composed::order4(DiscreteGradient)], HELD, [0.1, -0.2], 50.0);
    rests!(f64, tried, [DiscreteGradient, Implicit], WEAK, [0.1, -0.2], 50.0);
    rests!(
        f64,
        tried,
        [DiscreteGradient, Implicit, Composed::order4(DiscreteGradient)],
        Arm { k: 150.0 },
        [0.3, 0.7],
        75.0
    );
    rests!(DoubleDouble, tried, [DiscreteGradient], HELD, [0.1, -0.2], 50.0);
    assert_eq!(tried, 2 * 9);
}

/// In scenes and side by side they do as alone.
#[test]
fn so_do_bodies_and_members() {
    let (steps, dt) = (1500, 1.0 / 60.0);
    macro_rules! with {
        ($($scheme:expr),*) => {$({
            let bodies = (0..3).fold(Scene::new(), |scene, i| scene.body(1.0, [0.05 * f64::from(i), -0.0], [0.0; 2]));
            let run = Simulation::scene(bodies.field(HELD)).scheme($scheme).dt(dt).run(steps);
            let run = run.unwrap_or_else(|e| panic!("{e}"));
            assert!(run.last().v.iter().flatten().all(|v| v.abs() < 1e-13), "{:?}", run.last());
            let laws = (0..11).map(|i| Held { stiff: 70.0 + 10.0 * f64::from(i), ..HELD });
            let members: Vec<_> = laws.map(|law| (law, State::new([0.1, 0.3], [0.0; 2]))).collect();
            let all = Ensemble::over(members.clone()).scheme($scheme).dt(dt).run(steps).unwrap();
            for (k, (law, start)) in members.into_iter().enumerate() {
                let alone = Simulation::new(law, start).scheme($scheme).dt(dt).record_every(steps).run(steps);
                assert_eq!(all.last(k).unwrap(), *alone.unwrap().last(), "{law:?}");
            }
        })*};
    }
    with!(DiscreteGradient, Implicit);
}

/// A mass that lies where three springs cancel stays there, and its energy with it.
#[test]
fn what_lies_between_springs_stays() {
    let mut tried = 0;
    macro_rules! stays {
        ($($scheme:expr),*) => {$({
            for dt in [0.03, 0.1, 0.17] {
                let place = format!("{} {dt}", stringify!($scheme));
                let law = Free { k: 10.0 };
                let run = Simulation::new(law, State::new([0.0; 2], [0.0; 2])).scheme($scheme).dt(dt).run(1000);
                let run = run.unwrap_or_else(|e| panic!("{place}: {e}"));
                let energy = run.drift(Invariant::Energy).unwrap();
                assert!(energy.max_relative() < 1e-14, "{place}: {energy:?}");
                assert!(run.last().q.iter().chain(&run.last().v).all(|x| x.abs() < 3e-13), "{place}: {:?}", run.last());
                let body = Scene::new().body(1.0, [0.0; 2], [0.0; 2]).field(law);
                let run = Simulation::scene(body).scheme($scheme).dt(dt).run(1000);
                assert!(run.unwrap_or_else(|e| panic!("{place}: {e}")).last().q[0].iter().all(|x| x.abs() < 3e-13));
                tried += 1;
            }
        })*};
    }
    stays!(Relaxed::order6(), Relaxed::order8(), Nystrom::order6());
    assert_eq!(tried, 9);
}

// A well with an edge at which the force jumps to the other side.
law!(Edge, 1, |self, q| self.k * q[0].abs() + 0.1 * q[0] * q[0], |v| [-0.3 * v[0]]);

/// What is no rounding is refused as before: at an edge the trapezoidal rule has no root.
#[test]
fn an_edge_is_no_rounding() {
    let mut refused = 0;
    for k in [1e-9, 1e-6, 1e-3, 0.3, 2.0] {
        for dt in [0.05, 0.5] {
            let run = Simulation::new(Edge { k }, State::new([0.7], [0.1])).scheme(Implicit).dt(dt).run(3000);
            refused += usize::from(run.is_err());
        }
    }
    assert_eq!(refused, 10);
}
