//! What is stepped is what the author's methods compute: a name that stands for something else than a macro takes it for is
//! refused before the first step, with both values, and no law is refused for its rounding.

use approx::assert_relative_eq;
use std::ops::{Add, Mul, Sub};

use dmech::extend::{Disagreement, NoScheme};
use dmech::models::*;
use dmech::prelude::*;

/// Not those of `std`.
mod consts {
    pub(super) const PI: f64 = 3.0;
    #[expect(clippy::approx_constant, reason = "wrong on purpose")]
    pub(super) const SQRT_2: f64 = 1.414_213_562;
}

/// Not that of nalgebra.
#[derive(Clone, Copy, Debug)]
struct Vector2<T> {
    x: T,
    y: T,
}

impl From<[f64; 2]> for Vector2<f64> {
    fn from([x, y]: [f64; 2]) -> Self {
        Vector2 { x: y, y: x }
    }
}

impl Vector2<f64> {
    fn norm_squared(self) -> f64 {
        self.x * self.x + 2.0 * self.y * self.y
    }
}

#[derive(Clone, Copy, Debug)]
struct Constant;

#[dmech::law]
impl Constant {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        (consts::PI * q).sin()
    }
}

/// A constant that is wrong in its tenth digit only.
#[derive(Clone, Copy, Debug)]
struct NearlyRight {
    k: f64,
}

#[dmech::law]
impl NearlyRight {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.k * consts::SQRT_2 * (q[0] * q[0] + q[1].powi(4))
    }
}

#[derive(Clone, Copy, Debug)]
struct OwnVector;

#[dmech::law]
impl OwnVector {
    #[potential]
    fn energy(&self, q: Vector2<f64>) -> f64 {
        q.norm_squared()
    }
}

#[derive(Clone, Copy, Debug)]
struct Pushed;

#[dmech::law]
impl Pushed {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        q[0] * q[0] + q[1] * q[1]
    }
    #[force]
    fn push(&self, v: [f64; 2], m: f64, t: f64) -> [f64; 2] {
        [-v[0], m * (consts::PI * t).cos()]
    }
}

#[derive(Clone, Copy, Debug, dmech::Law)]
#[potential(|q: [f64; 2], t: f64| self.k * (q[0] * q[0] + consts::PI * q[1] * t))]
struct Derived {
    k: f64,
}

#[derive(Clone, Copy, Debug, dmech::Law)]
#[potential(|q: f64| -> f64 { let k = self.0; 0.5 * k * q * q })]
struct DerivedRight(f64);

#[derive(Clone, Copy, Debug)]
#[expect(dead_code)]
struct Generic<T> {
    k: f64,
    what: T,
}

#[dmech::law]
impl<T: Copy + 'static> Generic<T> {
    #[potential]
    fn energy(&self, q: [f64; 3]) -> f64 {
        self.k * (q[0] * q[0] + consts::PI * q[1] * q[1] + q[2] * q[2])
    }
}

#[derive(Clone, Copy, Debug)]
struct Charge {
    q: f64,
}

#[derive(Clone, Copy, Debug)]
struct Coulomb;

#[dmech::law]
impl Coulomb {
    #[pair]
    fn energy(&self, r: f64, a: &Charge, b: &Charge) -> f64 {
        a.q * b.q / (consts::PI * r)
    }
}

#[derive(Clone, Copy, Debug)]
struct Swirl;

#[dmech::law]
impl Swirl {
    #[pair_force]
    fn force(&self, d: [f64; 2], va: [f64; 2], mb: f64) -> [f64; 2] {
        [-mb * consts::PI * d[1], d[0] - va[1]]
    }
}

/// Two variables called x: the one of the macro, and the one that it is given.
macro_rules! law {
    ($name:ident, $x:ident, $y:expr) => {
        #[derive(Clone, Copy, Debug)]
        struct $name;

        #[dmech::law]
        impl $name {
            #[potential]
            fn energy(&self, q: f64) -> f64 {
                let x = 2.0 * q;
                let $x = 3.0 * x;
                0.5 * x * x + $y
            }
        }
    };
}

law!(Hygienic, x, x * 0.25);
law!(Apart, y, y * 0.25);

fn refusal<L: Law<D>, const D: usize>(law: L, start: State<D>) -> Disagreement {
    match Simulation::new(law, start).scheme(Explicit).dt(0.1).stepper().err() {
        Some(Error::NotAsWritten(disagreement)) => disagreement,
        other => panic!("{other:?}"),
    }
}

fn starts<L: Law<D>, const D: usize>(law: L, start: State<D>) {
    let stepper = Simulation::new(law, start).scheme(Explicit).dt(0.1).stepper();
    assert_eq!(stepper.err(), None);
}

#[test]
fn another_meaning_is_refused_with_both_values() {
    let refused = refusal(Constant, State::new([0.25], [0.0]));
    assert_eq!((refused.quantity(), refused.place(), refused.time()), ("potential", &[0.25][..], 0.0));
    assert!((refused.written() - 0.75_f64.sin()).abs() < 1e-15 && (refused.derived() - 0.5_f64.sqrt()).abs() < 1e-15);
    let said = Error::NotAsWritten(refused).to_string();
    println!("{said}");
    assert!(said.starts_with(
        "the law is not stepped as it is written: at q = 0.25, t = 0.0 the method gives the potential 0.68"
    ));

    let refused = refusal(NearlyRight { k: 1.7 }, State::new([0.3, -0.8], [0.0, 0.1]));
    assert_relative_eq!(refused.written(), refused.derived(), max_relative = 1e-9);
    refusal(OwnVector, State::new([0.3, -0.8], [0.0, 0.1]));
    let refused = refusal(Pushed, State::new([0.3, -0.8], [0.0, 0.1]).at_time(0.2));
    assert_eq!((refused.quantity(), refused.time()), ("force", 0.2));
    refusal(Derived { k: 1.7 }, State::new([0.3, -0.8], [0.0, 0.1]).at_time(0.2));
    refusal(Generic { k: 0.7, what: "anything" }, State::new([0.3, -0.8, 0.1], [0.0, 0.1, 0.0]));
    refusal(Hygienic, State::new([0.3], [0.0]));
    starts(Apart, State::new([0.3], [0.0]));
    starts(DerivedRight(2.0), State::new([0.3], [0.0]));
}

/// Between ends that only a run knows.
#[derive(Clone, Copy, Debug)]
struct Clamped {
    low: f64,
    high: f64,
}

#[dmech::law]
impl Clamped {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        q.clamp(self.low, self.high).powi(2)
    }

    #[invariant]
    fn scaled(&self, q: f64, v: f64) -> f64 {
        2.0 * (0.5 * v * v + self.energy(q))
    }
}

/// Its force alone.
#[derive(Clone, Copy, Debug)]
struct Pushing {
    low: f64,
    high: f64,
}

#[dmech::law]
impl Pushing {
    #[force]
    fn push(&self, q: f64) -> f64 {
        -q.clamp(self.low, self.high)
    }
}

/// A method that panics is told of as that: no name in it stands for anything else, and NaN is not what it gives.
#[test]
fn a_method_that_panics_is_told() {
    let start = State::new([0.25], [0.5]);
    starts(Clamped { low: -1.0, high: 1.0 }, start);
    let wrong = Clamped { low: 1.0, high: -1.0 };
    for refused in [refusal(wrong, start), refusal(Pushing { low: 1.0, high: -1.0 }, start)] {
        assert!(refused.panics() && refused.written().is_nan(), "{refused:?}");
        let said = Error::NotAsWritten(refused).to_string();
        assert!(said.contains("at q = 0.25, t = 0.0 a method panics") && said.contains("`clamp`"), "{said}");
        assert!(!said.contains("NaN") && !said.contains("name"), "{said}");
    }
    assert!(!refusal(Constant, start).panics());
    let report = verify(wrong, start);
    assert!(report.checks()[0].note().contains("a method panics"), "{report}");
    let scene = Scene::new().body(1.0, [0.25], [0.5]).field(wrong);
    let said = Simulation::scene(scene).scheme(Explicit).dt(0.1).run(1).unwrap_err().to_string();
    assert!(said.contains("on body 0 at q = 0.25, t = 0.0 a method panics"), "{said}");
}

/// At rest in the minimum at t = 0 they agree; around it they do not.
#[test]
fn a_special_start_hides_nothing() {
    refusal(Constant, State::new([0.0], [0.0]));
    refusal(NearlyRight { k: 1.7 }, State::new([0.0, 0.0], [0.0, 0.0]));
    refusal(Pushed, State::new([0.0, 0.0], [0.0, 0.0]));
    refusal(Derived { k: 1.7 }, State::new([0.0, 0.0], [0.0, 0.0]));
    refusal(Hygienic, State::new([0.0], [0.0]));
}

#[test]
fn whatever_it_is_stepped_with() {
    let single = Simulation::new(Constant, State::<1, f32>::of([0.25], [0.0])).scheme(Leapfrog).dt(0.1).stepper();
    assert!(matches!(single.err(), Some(Error::NotAsWritten(_))));
    let start = State::of([DoubleDouble::from(0.25)], [DoubleDouble::from(0.0)]);
    let double = Simulation::new(Constant, start).scheme(Leapfrog).dt(0.1).run(3);
    assert!(matches!(double.err().map(|e| e.cause()), Some(Error::NotAsWritten(_))));
    let start = State::of([DoubleDouble::from(0.3); 2], [DoubleDouble::from(0.1); 2]);
    assert!(Simulation::new(Pushed, start).scheme(Implicit).dt(0.1).stepper().is_err());
    let masses = Simulation::new(NearlyRight { k: 1.0 }, State::new([0.3, 0.2], [0.0, 0.0])).masses([1.0, 3.0]);
    assert!(matches!(masses.scheme(Leapfrog).dt(0.1).stepper().err(), Some(Error::NotAsWritten(_))));
    let adaptive = Simulation::new(Constant, State::new([0.25], [0.0])).scheme(Nystrom::order4()).adaptive(1e-6);
    assert!(matches!(adaptive.stepper().err(), Some(Error::NotAsWritten(_))));
    let report = verify(Constant, State::new([0.25], [0.0]));
    assert!(!report.passed());
    println!("{report}");
    assert!(report.checks()[0].note().contains("0.25"), "{}", report.checks()[0].note());
    verify(Apart, State::new([0.25], [0.1])).assert();
    Study::new(Constant, State::new([0.25], [0.0]), 1.0)
        .scheme(Leapfrog)
        .ladder([0.1, 0.05])
        .exact(|_| [0.0])
        .run()
        .unwrap_err();
}

#[test]
fn in_scenes() {
    fn refusal<const D: usize, P, L>(simulation: Simulation<(), Scene<D, P, L>, NoScheme>) -> String
    where
        L: dmech::scene::Term<D, P>,
        Explicit: dmech::scheme::Scheme<dmech::scene::SceneSystem<D, L::Ready>>,
    {
        let error = simulation.scheme(Explicit).dt(0.1).stepper().err().unwrap();
        assert!(matches!(error, Error::NotAsWritten(_)), "{error}");
        error.to_string()
    }
    let line = || (0..5).fold(Scene::new(), |scene, i| scene.body(1.0, [0.3 * f64::from(i)], [0.1]));
    let said = refusal(Simulation::scene(line().field(Constant)));
    assert!(said.contains("written: on body 0 at q = "), "{said}");
    let ions = || {
        Scene::new()
            .body_with(1.0, [1.2, 0.0, 0.2], [0.0, 1.05, 0.0], Charge { q: 1.0 })
            .body_with(6.0, [0.0, 0.1, 0.0], [0.0, -0.15, 0.02], Charge { q: -1.5 })
            .body_with(1.5, [0.0, 4.0, -0.5], [-0.42, 0.0, 0.1], Charge { q: 0.7 })
    };
    let said = refusal(Simulation::scene(ions().pairs(Coulomb)));
    assert!(
        said.contains("between bodies 0 and 1 at d = (1.2, -0.1, 0.2), t = 0.0 the method gives the potential"),
        "{said}"
    );
    refusal(Simulation::scene(ions().chain(Coulomb)));
    refusal(Simulation::scene(ions().bonds(Coulomb, [(0, 2)])));
    // It is only its numbers that are too large for one of the two.
    let heavy = |x: f64| Scene::new().body(1e200, [x, 0.0], [0.0; 2]).body(1e200, [1.0 + x, 0.0], [0.0, 1.0]);
    let said = refusal(Simulation::scene(heavy(0.3).pairs(pairs::Gravity { g: 1e-200 })));
    assert!(said.contains("larger than any number: take other units") && !said.contains("name"), "{said}");
    let small = Scene::new().body(1.0, [0.0], [0.0]).body(1.0, [1.25e-30], [0.0]);
    let said = refusal(Simulation::scene(small.pairs(pairs::LennardJones { epsilon: 1e-60, sigma: 1e-30 })));
    assert!(said.contains("NaN. The two calculate in another order") && said.contains("Or, where they are"), "{said}");
    let plane = Scene::new().body(1.0, [0.3, 0.1], [0.0, 0.2]).body(2.0, [0.5, -0.4], [0.1, 0.0]);
    refusal(Simulation::scene(plane.clone().chain(Swirl)));
    refusal(Simulation::scene(plane.field(Pushed)));
}

/// What its author wrote, a law written by hand is itself.
#[test]
fn a_law_by_hand_is_its_own() {
    struct Hand;
    impl Conservative for Hand {}
    impl Potential<1> for Hand {
        fn potential(&self, [x]: [f64; 1]) -> f64 {
            0.5 * x * x
        }
        fn gradient(&self, q: [f64; 1]) -> [f64; 1] {
            q
        }
        fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] {
            [[1.0]]
        }
        fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
            [0.5 * (a + b)]
        }
        fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] {
            [[0.5]]
        }
    }
    starts(Hand, State::new([0.3], [0.0]));
    let report = verify(Hand, State::new([0.3], [0.0]));
    assert_eq!(report.checks()[0].outcome(), dmech_study::verify::Outcome::NotApplicable);
}

/// Roundings of all kinds, of which none is another law.
macro_rules! laws {
    ($($name:ident, $d:literal: |$this:ident, $q:ident, $v:ident, $t:ident| $energy:expr, $force:expr;)*) => {$(
        #[derive(Clone, Copy, Debug)]
        #[allow(non_camel_case_types)]
        struct $name {
            k: f64,
        }

        #[dmech::law]
        impl $name {
            #[potential]
            #[allow(unused_variables)]
            fn energy(&self, q: [f64; $d], t: f64) -> f64 {
                let ($this, $q, $t) = (self.k, q, t);
                let energy = $energy;
                energy
            }
            #[force]
            #[allow(unused_variables)]
            fn force(&self, q: [f64; $d], v: [f64; $d], t: f64) -> [f64; $d] {
                let ($this, $q, $v, $t) = (self.k, q, v, t);
                let force = $force;
                force
            }
        }
    )*

    const LAWS: usize = [$(stringify!($name)),*].len();

    fn all(mut check: impl FnMut(&str, &mut dyn FnMut(f64, &[f64], &[f64], f64) -> Option<Error>)) {
        $({
            check(stringify!($name), &mut |k, q, v, t| {
                let (q, v) = (std::array::from_fn(|i| q[i]), std::array::from_fn(|i| v[i]));
                let start = State::<$d>::new(q, v).at_time(t);
                Simulation::new($name { k }, start).scheme(Explicit).dt(0.1).stepper().err()
            });
        })*
    }
    };
}

laws! {
    cancelled, 1: |k, q, v, t| k * ((1.0 + q[0]) - 1.0), [(3.0 + v[0]) - 3.0];
    rise, 1: |k, q, v, t| k * (1.0 - q[0].cos()), [(1.0 - v[0].exp()) * t];
    square_apart, 2: |k, q, v, t| k * (q[0] * q[0] - 2.0 * q[0] * q[1] + q[1] * q[1]), [q[0] - q[1] + v[1], -k * v[0]];
    stretched, 2: |k, q, v, t| 0.5 * k * (q[0].hypot(q[1]) - 1.0).powi(2), [0.0 * v[0], 0.0];
    hertz, 1: |k, q, v, t| k * (-q[0]).max(0.0).powf(2.5), [-v[0].abs().powf(1.5) * v[0].signum()];
    lennard_jones, 2: |k, q, v, t| {
        let s = 1.0 / (q[0] * q[0] + q[1] * q[1]);
        4.0 * k * (s.powi(6) - s.powi(3))
    }, [0.0 * v[0], 0.0];
    roots, 2: |k, q, v, t| k * (q[0] * q[0] + q[1] * q[1]).powf(0.75) + q[0].abs().powf(1.25) + q[1].cbrt().powi(4),
        [(q[0] * q[0] + 1.0).powf(-1.5), v[1].abs().sqrt()];
    sums, 1: |k, q, v, t| {
        let mut sum = 0.0;
        for i in 0..50 {
            sum += k * q[0] * q[0] + 0.1 * i as f64;
        }
        sum
    }, [(0..40).map(|i| v[0] * 0.1 * i as f64).sum::<f64>()];
    seam, 1: |k, q, v, t| if (q[0] + 0.1) - 0.4 > 0.0 { k * (q[0] - 0.3) } else { 0.0 }, [((q[0] + 0.1) - 0.4).signum() - v[0]];
    angle, 2: |k, q, v, t| k * ((q[1] + 0.1) - 0.1).atan2(q[0]).cos(), [q[1].atan2(-q[0].abs()).sin(), v[0]];
    hills, 2: |k, q, v, t| k * (-(q[0] * q[0] + q[1] * q[1])).exp() + q[0].tanh() - q[1].atan(), [v[0].sinh(), v[1].cosh()];
    saturated, 1: |k, q, v, t| k * (1.0 + q[0].exp()).ln() - q[0].asinh(), [v[0] / (1.0 + v[0] * v[0]).sqrt() + (k * t).sin()];
    clamped, 1: |k, q, v, t| k * q[0].clamp(-0.5, 0.5).powi(2), [v[0].min(0.3).max(-t)];
    wells, 1: |k, q, v, t| k * (q[0] * q[0] - 1.0).powi(2) + (q[0] - 2.0) * (q[0] - 3.0) * (q[0] + 5.0), [v[0].powi(7)];
    three, 3: |k, q, v, t| {
        let r = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt();
        -k / r + k * ((q[0] - q[1]) + (q[1] - q[2]) + (q[2] - q[0])) / (r * r)
    },
        [k * (v[1] * q[2] - v[2] * q[1]), v[2] * q[0] - v[0] * q[2], v[0] * q[1] - v[1] * q[0]];
}

#[test]
fn no_law_is_refused_for_its_rounding() {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut throw = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let (mut laws, mut starts, mut refused) = (0, 0, vec![]);
    all(|name, begin| {
        laws += 1;
        let mut start = |k: f64, q: [f64; 3], v: [f64; 3], t: f64| {
            // Where they lose all digits of the position these are other laws than those that their text means.
            let digits = q.iter().chain(&v).all(|x| *x == 0.0 || x.abs() > 1e-10);
            if ["cancelled", "angle"].contains(&name) && !digits {
                return;
            }
            starts += 1;
            if let Some(error @ Error::NotAsWritten(_)) = begin(k, &q, &v, t) {
                refused.push(format!("{name} k = {k:?}, q = {q:?}, v = {v:?}, t = {t:?}: {error}"));
            }
        };
        let special = [
            0.0, -0.0, 1.0, -1.0, 0.3, 0.5, -0.5, 1e-9, 1.2e-8, 1e-17, 1e-160, 1e-300, 30.0, 710.0, 1e8, 1e30, 1e160,
            1e300,
        ];
        for x in special {
            for y in [0.0, x, -x, 0.7 * x, 1.0, 1e-8, 1e8] {
                for k in [1.0, 1.7e-23, 3.1e22] {
                    start(k, [x, y, x], [y, x, 0.0], 0.0);
                    start(k, [x, y, x - y], [0.0; 3], y);
                }
            }
        }
        for _ in 0..5000 {
            let size = 10.0_f64.powf(12.0 * throw() * throw());
            let mut vector = || [size * throw(), size * throw(), size * throw()];
            let (q, v) = (vector(), vector());
            start(10.0_f64.powf(3.0 * throw()), q, v, 100.0 * throw());
        }
    });
    println!("{laws} laws, {starts} starts, {} refused", refused.len());
    for refused in refused.iter().step_by(1 + refused.len() / 40) {
        println!("{refused}");
    }
    assert!(laws == LAWS && laws == 15 && starts > 80_000);
    assert_eq!(refused.len(), 0);
}

/// The models, at starts of all sizes, and right at what is singular in them.
#[test]
fn no_model_is_refused() {
    fn check<L: Law<D> + Copy, const D: usize>(law: L) {
        for exponent in -40..=40 {
            for (i, sign) in [1.0, -1.0].into_iter().enumerate() {
                let x = sign * 1.37 * 10.0_f64.powf(f64::from(exponent) / 4.0);
                let q = std::array::from_fn(|k| if k == i { x } else { 0.61 * x });
                let start = State::new(q, q.map(|x| 0.3 * x)).at_time(0.1 * x);
                let error = Simulation::new(law, start).scheme(Explicit).dt(0.1).stepper().err();
                assert!(!matches!(error, Some(Error::NotAsWritten(_))), "{error:?}");
            }
        }
        let error = Simulation::new(law, State::new([0.0; D], [0.0; D])).scheme(Explicit).dt(0.1).stepper().err();
        assert!(!matches!(error, Some(Error::NotAsWritten(_))), "{error:?}");
    }
    check::<_, 3>(Anharmonic::default());
    check::<_, 3>(Kepler3::default());
    check::<_, 1>(LennardJones::default());
    check::<_, 3>(MagneticField::default());
    check::<_, 1>(DampedPendulum::default());
    check::<_, 1>(DrivenPendulum::default());
    check::<_, 1>(Duffing::default());
    check::<_, 2>(HenonHeiles::default());
    check::<_, 2>(Kepler { gm: 1.3 });
    check::<_, 1>(Morse::default());
    check::<_, 1>(Pendulum::default());
    check::<_, 1>(Quartic::default());
    check::<_, 1>(VanDerPol::default());
    check::<_, 1>(Wall::default());
}

/// A vector of one's own whose arithmetic is that of nalgebra is as good.
#[test]
fn the_same_under_another_name() {
    mod own {
        use super::*;

        #[derive(Clone, Copy, Debug)]
        pub(super) struct Vector3<T>(pub(super) [T; 3]);

        impl From<[f64; 3]> for Vector3<f64> {
            fn from(x: [f64; 3]) -> Self {
                Vector3(x)
            }
        }
        impl From<Vector3<f64>> for [f64; 3] {
            fn from(x: Vector3<f64>) -> Self {
                x.0
            }
        }
        impl Add for Vector3<f64> {
            type Output = Self;
            fn add(self, other: Self) -> Self {
                Vector3(std::array::from_fn(|i| self.0[i] + other.0[i]))
            }
        }
        impl Sub for Vector3<f64> {
            type Output = Self;
            fn sub(self, other: Self) -> Self {
                Vector3(std::array::from_fn(|i| self.0[i] - other.0[i]))
            }
        }
        impl Mul<f64> for Vector3<f64> {
            type Output = Self;
            fn mul(self, c: f64) -> Self {
                Vector3(self.0.map(|x| c * x))
            }
        }
        impl Vector3<f64> {
            pub(super) fn dot(&self, other: &Self) -> f64 {
                (0..3).map(|i| self.0[i] * other.0[i]).sum()
            }
        }
    }
    use own::Vector3;

    #[derive(Clone, Copy, Debug)]
    struct Bound {
        k: f64,
    }

    #[dmech::law]
    impl Bound {
        #[potential]
        fn energy(&self, q: Vector3<f64>) -> f64 {
            self.k * (q + q).dot(&(q * 0.5))
        }
        #[force]
        fn force(&self, q: Vector3<f64>, v: Vector3<f64>) -> Vector3<f64> {
            q * 0.1 - v * self.k
        }
    }

    starts(Bound { k: 0.7 }, State::new([0.3, 0.1, -0.4], [0.0, 0.1, 0.2]));
}
