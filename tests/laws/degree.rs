//! Of which degree a potential is as a polynomial: read from the formula, said by the law, handed on by all that holds it.

use dmech::extend::{Between, Field, LinkLaw, MassIndependent, Masses, PairLaw, Particle, System};
use dmech::models::pairs::{self, FermiPastaUlamTsingou};
use dmech::models::*;
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};

use dmech_tests::few::Trap;
use dmech_tests::{for_each_law, laws};

/// What the system of one particle says, and with it all that hold or borrow the law.
fn degree<L: Law<D> + MassIndependent, const D: usize>(_: &L) -> Option<u32> {
    let degree = <Particle<L, D> as System>::DEGREE;
    assert_eq!(<Particle<Masses<L, D>, D> as System>::DEGREE, degree, "with masses of its own for each coordinate");
    assert_eq!(<Particle<Option<L>, D> as System>::DEGREE, degree, "if it is there");
    let forced = <L::Field<'_> as Field<D>>::FORCED;
    assert_eq!(<L::Field<'_> as Potential<D>>::DEGREE, degree);
    assert!(forced || !<L::Field<'_> as Potential<D>>::LINEAR || degree.is_some_and(|degree| degree <= 2));
    assert!(!<L::Field<'_> as Potential<D>>::PIECEWISE || degree.is_none());
    degree
}

/// Between two bodies in D dimensions.
fn between<X: LinkLaw<D, P>, const D: usize, P>(_: &X) -> Option<u32> {
    let degree = <<X as PairLaw<D, P>>::Between<'_> as Potential<D>>::DEGREE;
    assert_eq!(<<Option<X> as PairLaw<D, P>>::Between<'_> as Potential<D>>::DEGREE, degree, "if it is there");
    degree
}

#[test]
fn of_every_model() {
    assert_eq!(degree::<_, 1>(&Quartic { beta: 1.7 }), Some(4));
    assert_eq!(degree::<_, 2>(&HenonHeiles { lambda: 0.8 }), Some(3));
    assert_eq!(degree::<_, 3>(&Anharmonic { k: 1.1, c: 0.4, d: 0.8 }), Some(4));
    assert_eq!(degree::<_, 1>(&Pendulum { k: 1.4 }), None);
    assert_eq!(degree::<_, 2>(&Kepler { gm: 1.3 }), None);
    assert_eq!(degree::<_, 3>(&Kepler3 { gm: 1.3 }), None);
    assert_eq!(degree::<_, 1>(&Morse { depth: 1.5, width: 1.2, length: 0.8 }), None);
    assert_eq!(degree::<_, 1>(&LennardJones { epsilon: 0.7, sigma: 1.2 }), None);
    assert_eq!(degree::<_, 1>(&Wall { k: 40.0, pull: 1.3 }), None, "a choice of polynomials is none");
    // Beside a force nothing follows from the potential alone, also where the force does no work.
    assert_eq!(degree::<_, 3>(&MagneticField { charge: 1.7, field: [0.3, -0.6, 1.1] }), None);
    assert_eq!(degree::<_, 1>(&Duffing { alpha: -0.9, beta: 1.2, delta: 0.0, gamma: 0.0, omega: 1.0 }), None);
    assert_eq!(degree::<_, 1>(&VanDerPol { mu: 1.6 }), None);
}

#[test]
fn of_every_law_of_the_suites() {
    let mut said = vec![];
    macro_rules! one {
        ($law:ident, $d:literal, $q:expr, $v:expr) => {
            if let Some(degree) = degree::<_, $d>(&laws::$law::new()) {
                said.push((stringify!($law), degree));
            }
        };
    }
    for_each_law!(one);
    said.sort_unstable();
    assert_eq!(said, [("Anharmonic", 4), ("Chain", 4), ("Coupled", 2), ("HenonHeiles", 3), ("Oscillator", 2)]);
}

#[test]
fn of_every_model_between_two_bodies() {
    let chain = FermiPastaUlamTsingou { k: 1.3, alpha: 0.0, beta: 0.4 };
    assert_eq!(between::<_, 1, ()>(&chain), Some(4));
    assert_eq!(between::<_, 1, ()>(&pairs::Spring { k: 1.7, length: 1.1 }), None, "a length on a line too");
    assert_eq!(between::<_, 2, ()>(&pairs::Spring { k: 1.7, length: 0.0 }), None, "whatever the length is");
    assert_eq!(between::<_, 3, ()>(&pairs::Gravity { g: 1.3 }), None);
    assert_eq!(between::<_, 2, pairs::Charge>(&pairs::Coulomb { k: 1.3 }), None);
    assert_eq!(between::<_, 1, ()>(&pairs::Toda { a: 0.8, b: 1.4 }), None);
    assert_eq!(between::<_, 1, ()>(&pairs::Hertz { k: 1.6 }), None);
    assert_eq!(between::<_, 2, pairs::Sphere>(&pairs::HertzSpheres { modulus: 2.3 }), None);
}

/// Even powers of the distance.
#[derive(Clone, Copy, Debug)]
struct Even {
    k: f64,
}

#[dmech::law]
impl Even {
    #[pair]
    fn energy(&self, r: f64, ma: f64, mb: f64, t: f64) -> f64 {
        ma * mb * r * r * (0.5 * self.k + 0.25 * t.sin() * r.powi(4))
    }
}

/// The same powers with friction beside them.
#[derive(Clone, Copy, Debug)]
struct Rubbed {
    k: f64,
}

#[dmech::law]
impl Rubbed {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        self.k * r * r
    }
    #[pair_force]
    fn friction(&self, va: [f64; 2], vb: [f64; 2]) -> [f64; 2] {
        [vb[0] - va[0], vb[1] - va[1]]
    }
}

#[test]
fn between_two_bodies_odd_powers_of_the_distance_are_roots() {
    assert_eq!(between::<_, 1, ()>(&Even { k: 1.3 }), Some(6));
    assert_eq!(between::<_, 2, ()>(&Even { k: 1.3 }), Some(6));
    assert_eq!(between::<_, 3, ()>(&Even { k: 1.3 }), Some(6));
    assert_eq!(between::<_, 2, ()>(&Rubbed { k: 1.3 }), None, "a force acts beside it");
    const { assert!(<<Rubbed as PairLaw<2, ()>>::Between<'_> as Between<2>>::FORCED) };
}

/// A field that names mass and time is a polynomial in the coordinates still.
#[derive(Clone, Copy, Debug)]
struct Tide {
    k: f64,
    w: f64,
}

#[dmech::law]
impl Tide {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64, t: f64) -> f64 {
        let s = q[0] * q[0] - q[1] * q[1];
        if self.k > 0.0 { m * self.k * (self.w * t).sin() } else { m }.sqrt() * s * s / (self.w + t)
    }
}

#[test]
fn mass_and_time_are_no_coordinates() {
    assert_eq!(<Particle<Tide, 2> as System>::DEGREE, Some(4));
    const { assert!(!<Tide as Law<2>>::AUTONOMOUS) };
    assert_eq!(degree::<_, 2>(&Trap { k: 1.3, b: 0.7 }), None);
    const { assert!(<<Trap as Law<2>>::Field<'_> as Field<2>>::CONSERVES_ENERGY) };
}

/// By hand, with and without a word of its degree.
#[derive(Clone, Copy, Debug)]
struct ByHand<const SAYS: bool> {
    k: f64,
}

impl<const SAYS: bool> Conservative for ByHand<SAYS> {}

impl<const SAYS: bool> Potential<1> for ByHand<SAYS> {
    const DEGREE: Option<u32> = if SAYS { Some(2) } else { None };

    fn potential(&self, [x]: [f64; 1]) -> f64 {
        0.5 * self.k * x * x
    }
    fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] {
        [self.k * x]
    }
    fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] {
        [[self.k]]
    }
    fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
        [0.5 * self.k * (a + b)]
    }
    fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] {
        [[0.5 * self.k]]
    }
}

/// A steady push beside the parabola.
#[derive(Clone, Copy, Debug)]
struct Pushed;

impl Law<1> for Pushed {
    type Field<'a> = Push;

    fn field(&self, _: f64, _: f64) -> Push {
        Push(ByHand { k: 1.3 })
    }
}

#[derive(Clone, Copy, Debug)]
struct Push(ByHand<true>);

impl Potential<1> for Push {
    const DEGREE: Option<u32> = <ByHand<true> as Potential<1>>::DEGREE;

    fn potential(&self, q: [f64; 1]) -> f64 {
        self.0.potential(q)
    }
    fn gradient(&self, q: [f64; 1]) -> [f64; 1] {
        self.0.gradient(q)
    }
    fn hessian(&self, q: [f64; 1]) -> [[f64; 1]; 1] {
        self.0.hessian(q)
    }
    fn discrete_gradient(&self, a: [f64; 1], b: [f64; 1]) -> [f64; 1] {
        self.0.discrete_gradient(a, b)
    }
    fn discrete_gradient_jacobian(&self, a: [f64; 1], b: [f64; 1]) -> [[f64; 1]; 1] {
        self.0.discrete_gradient_jacobian(a, b)
    }
}

impl Field<1> for Push {
    const FORCED: bool = true;
    const CONSERVES_ENERGY: bool = false;

    fn force(&self, _: [f64; 1], _: [f64; 1], _: f64) -> [f64; 1] {
        [1.0]
    }
}

/// What the system of a scene says.
fn in_a_scene<const D: usize, P, L: Term<D, P, B>, B>(_: &Scene<D, P, L, B>) -> Option<u32> {
    <SceneSystem<D, L::Ready> as System>::DEGREE
}

#[test]
fn a_force_beside_a_polynomial_by_hand_leaves_none() {
    assert_eq!(<Push as Potential<1>>::DEGREE, Some(2));
    assert_eq!(<Particle<Pushed, 1> as System>::DEGREE, None);
    let body = || Scene::new().body(1.3, [0.4], [0.0]);
    assert_eq!(in_a_scene(&body().field(ByHand::<true> { k: 1.3 })), Some(2));
    assert_eq!(in_a_scene(&body().field(Pushed)), None);
}

#[test]
fn a_law_by_hand_says_it_itself() {
    let law = ByHand::<true> { k: 1.3 };
    assert_eq!(law.field(1.0, 0.0).gradient([2.0]), [2.6]);
    assert_eq!(<Particle<ByHand<true>, 1> as System>::DEGREE, Some(2));
    assert_eq!(<Particle<ByHand<false>, 1> as System>::DEGREE, None);
}

#[test]
fn the_derivation_tells_it() {
    let tells = |text: &str| text.lines().filter(|line| line.contains("polynomial")).collect::<Vec<_>>().join("\n");
    assert_eq!(tells(HenonHeiles { lambda: 0.8 }.derivation()), "  a polynomial of degree 3");
    assert_eq!(tells(Even { k: 1.3 }.derivation()), "  a polynomial of degree 6");
    assert_eq!(tells(FermiPastaUlamTsingou::default().derivation()), "  a polynomial of degree 4");
    assert_eq!(tells(Pendulum { k: 1.4 }.derivation()), "");
    assert_eq!(tells(Trap { k: 1.3, b: 0.7 }.derivation()), "");
    assert_eq!(tells(Rubbed { k: 1.3 }.derivation()), "");
}
