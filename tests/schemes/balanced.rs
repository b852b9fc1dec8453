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

// What is measured from where it is held, and comes to rest there: a mass on a spring that stiffens, a bond, an arm in its posture, a
// charge between two others, an atom beside a wall.
law!(
    Hung,
    1,
    |self, q| {
        let x = q[0] + 0.31;
        0.5 * self.k * x * x + 0.1 * self.k * x.powi(4) - self.k * (0.31 + 0.4 * 0.31 * 0.31 * 0.31) * q[0]
    },
    |v| [-7.0 * v[0]]
);
law!(Bond, 1, |self, q| self.k * ((-1.4 * q[0]).exp() - 2.0 * (-0.7 * q[0]).exp()), |v| [-5.0 * v[0]]);
law!(Posture, 1, |self, q| 9.81 * (q[0] + 0.6).cos() + 0.5 * self.k * q[0] * q[0] + 9.81 * 0.6_f64.sin() * q[0], |v| [
    -9.0 * v[0]
]);
law!(Between, 1, |self, q| self.k / (0.9 - q[0]) + self.k / (0.9 + q[0]), |v| [-6.0 * v[0]]);
law!(
    Jones,
    1,
    |self, q| {
        let r = q[0] + 0.6;
        self.k * ((0.6 / r).powi(12) - 2.0 * (0.6 / r).powi(6))
    },
    |v| [-8.0 * v[0]]
);
law!(
    Tied,
    2,
    |self, q| {
        let mut sum = 0.0;
        for i in 0..3 {
            let angle = 2.0943951023931953 * (i as f64);
            let stretch = (q[0] - angle.cos()).hypot(q[1] - angle.sin()) - 0.35;
            sum += 0.5 * self.k * stretch * stretch;
        }
        sum
    },
    |v| v.map(|v| -6.5 * v)
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
            assert_eq!(run.report().rough(), 0, "{place}: rounding is no bend of the force");
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
    rests!(
        f64,
        tried,
        [DiscreteGradient, Implicit, Composed::order4(DiscreteGradient), Gauss::order16(), LineIntegral::order6()],
        HELD,
        [0.1, -0.2],
        50.0
    );
    rests!(f64, tried, [DiscreteGradient, Implicit, Gauss::order16()], WEAK, [0.1, -0.2], 50.0);
    rests!(
        f64,
        tried,
        [DiscreteGradient, Implicit, Composed::order4(DiscreteGradient), Gauss::order16(), LineIntegral::order6()],
        Arm { k: 150.0 },
        [0.3, 0.7],
        75.0
    );
    rests!(DoubleDouble, tried, [DiscreteGradient, Gauss::order16()], HELD, [0.1, -0.2], 50.0);
    assert_eq!(tried, 2 * 15);
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
    with!(DiscreteGradient, Implicit, Gauss::order16(), LineIntegral::order6());
}

/// Where the position is 0 there is no length to say what is small beside it.
#[test]
fn so_does_what_is_measured_from_there() {
    let mut tried = 0;
    macro_rules! at_zero {
        ($law:expr, $q:expr, [$($scheme:expr),*]) => {$({
            for (dt, far) in [(1.0 / 240.0, 1.0), (1.0 / 60.0, 1.0), (1.0 / 30.0, 0.0), (1.0 / 30.0, -0.7)] {
                let (law, start) = ($law, $q.map(|x: f64| x * far));
                let place = format!("{law:?} by {}, {dt} from {start:?}", stringify!($scheme));
                let law_alone = Simulation::new(law, State::new(start, $q.map(|_| 0.0)));
                let run = law_alone.scheme($scheme).dt(dt).record_every(10_000).run_until(40.0);
                let State { q, v, .. } = *run.unwrap_or_else(|e| panic!("{place}: {e}")).last();
                assert!(q.iter().chain(&v).all(|x| x.abs() < 1e-13), "{place}: {q:?} {v:?}");
                let single = State::of(start.map(|x| x as f32), $q.map(|_| 0.0));
                let run = Simulation::new(law, single).scheme($scheme).dt(dt).record_every(10_000).run_until(20.0);
                let State { q, v, .. } = *run.unwrap_or_else(|e| panic!("{place}, f32: {e}")).last();
                assert!(q.iter().chain(&v).all(|x| x.abs() < 1e-4), "{place}: {q:?} {v:?}");
                tried += 1;
            }
        })*};
    }
    at_zero!(
        Hung { k: 23.0 },
        [0.03],
        [Implicit, DiscreteGradient, Composed::order4(DiscreteGradient), Gauss::order16(), LineIntegral::order6()]
    );
    at_zero!(
        Bond { k: 40.0 },
        [0.02],
        [Implicit, DiscreteGradient, Composed::order4(DiscreteGradient), Gauss::order16(), LineIntegral::order6()]
    );
    at_zero!(
        Posture { k: 31.0 },
        [0.05],
        [Implicit, DiscreteGradient, Composed::order4(DiscreteGradient), Gauss::order16(), LineIntegral::order6()]
    );
    at_zero!(
        Between { k: 12.0 },
        [0.04],
        [Implicit, DiscreteGradient, Composed::order4(DiscreteGradient), Gauss::order16(), LineIntegral::order6()]
    );
    at_zero!(
        Tied { k: 17.0 },
        [0.03, -0.02],
        [Implicit, DiscreteGradient, Composed::order4(DiscreteGradient), Gauss::order16(), LineIntegral::order6()]
    );
    assert_eq!(tried, 5 * 5 * 4);
}

/// By steps that are no longer small beside a period, from where the first correction is long.
#[test]
fn so_does_it_by_long_steps() {
    macro_rules! by {
        ($($scheme:expr),*) => {$(
            let start = State::new([0.03], [0.0]);
            let hung = Simulation::new(Hung { k: 23.0 }, start).scheme($scheme).dt(0.2).run(300);
            let held = Simulation::new(Posture { k: 31.0 }, start).scheme($scheme).dt(0.2).run(300);
            for run in [hung, held] {
                let State { q, v, .. } = *run.unwrap_or_else(|e| panic!("{}: {e}", stringify!($scheme))).last();
                assert!(q.iter().chain(&v).all(|x| x.abs() < 1e-13), "{}: {q:?} {v:?}", stringify!($scheme));
            }
        )*};
    }
    by!(Implicit, DiscreteGradient, Composed::order4(DiscreteGradient), Gauss::order16(), LineIntegral::order6());
}

// The mass on a stiffening spring, with numbers by which one form of what is left of an equation is 0 to the bit and the other is not.
#[derive(Clone, Copy, Debug)]
struct Sagging {
    sag: f64,
    k: f64,
    drag: f64,
}

#[dmech::law]
impl Sagging {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        let x = q + self.sag;
        let weight = self.k * self.sag + 0.4 * self.k * self.sag.powi(3);
        0.5 * self.k * x * x + 0.1 * self.k * x.powi(4) - weight * q
    }

    #[force]
    fn drag(&self, v: f64) -> f64 {
        -self.drag * v
    }
}

/// Where nothing is left, the correction before tells no length: it is as long as the step.
#[test]
fn so_does_it_where_nothing_is_left() {
    let law = Sagging { sag: 0.6259961298245916, k: 12.329592367144208, drag: 10.297753125071909 };
    let motion = Simulation::new(law, State::new([0.017325367325768785], [0.0]));
    let run = motion.scheme(Implicit).dt(0.004166666666666667).record_every(10_000).run_until(40.0);
    let State { q: [q], v: [v], .. } = *run.unwrap_or_else(|e| panic!("{e}")).last();
    assert!(q.abs() < 1e-13 && v.abs() < 1e-13, "{q:e} {v:e}");
}

/// In a scene, many at once.
#[test]
fn so_do_many_that_are_measured_from_there() {
    macro_rules! of {
        ($law:expr, $q:expr, [$($scheme:expr),*]) => {$(
            for dt in [1.0 / 240.0, 1.0 / 60.0] {
                let law = $law;
                let start = |i: i32| $q.map(|x: f64| x * f64::from(i));
                let bodies = (-1..=2).fold(Scene::new(), |scene, i| scene.body(1.0, start(i), $q.map(|_| 0.0)));
                let run = Simulation::scene(bodies.field(law)).scheme($scheme).dt(dt).record_every(10_000).run_until(20.0);
                let run = run.unwrap_or_else(|e| panic!("{law:?} by {}, {dt}: {e}", stringify!($scheme)));
                assert!(run.last().v.iter().flatten().all(|x| x.abs() < 1e-12), "{:?}", run.last());
            }
        )*};
    }
    of!(Hung { k: 23.0 }, [0.03], [Implicit, DiscreteGradient, Gauss::order16(), LineIntegral::order6()]);
    of!(Bond { k: 40.0 }, [0.02], [Implicit, DiscreteGradient, Gauss::order16(), LineIntegral::order6()]);
    of!(Tied { k: 17.0 }, [0.03, -0.02], [Implicit, Gauss::order16(), LineIntegral::order6()]);
    of!(Jones { k: 30.0 }, [0.01], [Implicit, DiscreteGradient, Gauss::order16()]);
}

/// And beside one so heavy that it goes on moving.
#[test]
fn so_do_they_beside_what_moves() {
    macro_rules! by {
        ($($scheme:expr),*) => {$(
            let bodies = Scene::new().body(3e5, [0.2], [0.1]).body(1.0, [0.03], [0.0]).body(2.0, [0.0], [0.0]);
            let scene = Simulation::scene(bodies.field(Hung { k: 23.0 }).field(Bond { k: 40.0 }));
            let run = scene.scheme($scheme).dt(1.0 / 60.0).record_every(10_000).run_until(40.0);
            let run = run.unwrap_or_else(|e| panic!("{}: {e}", stringify!($scheme)));
            let (moves, rests) = run.last().v.split_first().unwrap();
            assert!(moves[0].abs() > 1e-3 && rests.iter().flatten().all(|x| x.abs() < 1e-12), "{:?}", run.last());
        )*};
    }
    by!(Implicit, DiscreteGradient, Gauss::order16(), LineIntegral::order6());
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
    stays!(Relaxed::order6(), Relaxed::order8(), Nystrom::order6(), Implicit, DiscreteGradient, Kanatani);
    stays!(Gauss::order16(), LineIntegral::order4());
    assert_eq!(tried, 24);
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

// An arm upright, measured from where a weak spring holds it, which does not hold it there.
law!(Upright, 1, |self, q| {
    let lean = 0.37_f64;
    self.k * ((q[0] + lean).cos() + lean.sin() * q[0]) + 0.7 * q[0] * q[0]
});

/// On a hilltop forces cancel too. A step so long that its root there does not continue that of a shorter one is refused, however well
/// it is known.
#[test]
fn a_hilltop_is_not_where_long_steps_lead() {
    let mut tried = 0;
    for [q, v] in [[0.0, 0.0], [1e-17, 0.0], [0.0, 1e-17]] {
        let law = Upright { k: 9.81 };
        let alone = Simulation::new(law, State::new([q], [v]));
        let among = Simulation::scene(Scene::new().body(1.0, [q], [v]).field(law));
        macro_rules! refuse {
            ($($motion:ident by $scheme:expr;)*) => {$(
                let moves = |dt: f64| $motion.clone().scheme($scheme).dt(dt).run(1).map(|_| ());
                assert!(moves(0.3).is_ok(), "{} from {q:e}, {v:e}: {:?}", stringify!($motion by $scheme), moves(0.3));
                for dt in [1.0, 2.0] {
                    let refused = moves(dt).unwrap_err();
                    let cause = refused.cause();
                    assert!(matches!(cause, dmech::Error::NotConverged { .. }), "{cause}");
                    tried += 1;
                }
            )*};
        }
        refuse! { alone by Implicit; alone by DiscreteGradient; among by Implicit; among by DiscreteGradient; }
    }
    assert_eq!(tried, 24);
}
