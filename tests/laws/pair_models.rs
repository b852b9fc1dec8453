//! The library of laws between two bodies: every derivative against differences of the formula in the documentation, the secant
//! identity in ulps, and the values that the documentation names. A new model is a new row of `every_model`.

use dmech::extend::{PairLaw, Symmetric, VelocityIndependent};
use dmech::models::pairs::*;
use dmech::prelude::*;

use super::pairs::{is_a_potential, norm, numbers};

/// A body: its mass and what it carries.
type Body<P> = (f64, P);

const BALL: Sphere = Sphere { radius: 0.7 };
const LARGE: Sphere = Sphere { radius: 1.2 };
const ION: Charge = Charge { q: 0.8 };
const ELECTRON: Charge = Charge { q: -1.9 };

/// A law of the distance, by its formula, from one distance to another, in one to three dimensions.
fn of_the_distance<P, L>(law: L, bodies: [Body<P>; 2], formula: impl Fn(f64) -> f64, [from, to]: [f64; 2])
where
    L: PairLaw<1, P> + PairLaw<2, P> + PairLaw<3, P> + Symmetric + VelocityIndependent + core::fmt::Debug,
{
    let energy = |d: &[f64]| formula(d.iter().map(|x| x * x).sum::<f64>().sqrt());
    check(&law, &bodies, |d: [f64; 1]| energy(&d), [from], [to]);
    check(&law, &bodies, |d: [f64; 2]| energy(&d), [0.6 * from, -0.8 * from], [0.28 * to, 0.96 * to]);
    let turned = [[2.0, -1.0, 2.0].map(|x| x / 3.0 * from), [-0.36, 0.48, 0.8].map(|x| x * to)];
    check(&law, &bodies, |d: [f64; 3]| energy(&d), turned[0], turned[1]);
}

/// A law of the separation on a line.
fn on_a_line<L>(law: L, formula: impl Fn(f64) -> f64, [from, to]: [f64; 2])
where
    L: PairLaw<1, ()> + VelocityIndependent + core::fmt::Debug,
{
    check(&law, &[(1.3, ()), (0.4, ())], |[d]: [f64; 1]| formula(d), [from], [to]);
}

fn check<P, L, const D: usize>(
    law: &L,
    bodies: &[Body<P>; 2],
    energy: impl Fn([f64; D]) -> f64,
    from: [f64; D],
    to: [f64; D],
) where
    L: PairLaw<D, P> + core::fmt::Debug,
{
    assert!(L::AUTONOMOUS);
    let [a, b] = [0, 1].map(|i| numbers(law, bodies[i].0, &bodies[i].1));
    let acts = law.between(a, b, 0.0);
    is_a_potential(&acts, energy, from, to);
    is_a_potential(&acts, |d| acts.potential(d), to, from);
    let ulps = secant(&acts, from, to);
    let what = format!("{law:?} in {D} dimensions");
    println!("{what:<80} {ulps:5.2} ulps");
    assert!(ulps < 2.0, "{what}: the secant identity fails by {ulps} ulps");
}

/// By how many ulps ∇̄Φ(a, b)·(b − a) and Φ(b) − Φ(a) differ at most, from ends that are far apart to ends that nearly coincide.
///
/// An ulp is one of |Φ(a)| + |Φ(b)| and of what Φ changes by where the position changes by an ulp of its own.
fn secant<const D: usize>(acts: &impl Potential<D>, from: [f64; D], to: [f64; D]) -> f64 {
    let dot = |x: [f64; D], y: [f64; D]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
    let error = |exponent: i32| {
        let part = 10.0_f64.powi(-exponent);
        let to = core::array::from_fn(|i| from[i] + part * (to[i] - from[i]));
        let step = core::array::from_fn(|i| to[i] - from[i]);
        let work = dot(acts.discrete_gradient(from, to), step);
        let ends = [from, to].map(|d| acts.potential(d).abs() + norm(acts.gradient(d)) * norm(d));
        (work - (acts.potential(to) - acts.potential(from))).abs() / (f64::EPSILON * (ends[0] + ends[1]))
    };
    (0..=15).map(error).fold(0.0, f64::max)
}

#[test]
fn every_model() {
    let (light, heavy) = ((0.7, ()), (2.5, ()));
    of_the_distance(Gravity { g: 1.3 }, [light, heavy], |r| -1.3 * 0.7 * 2.5 / r, [0.9, 1.7]);
    of_the_distance(Coulomb { k: 1.3 }, [(0.7, ION), (2.5, ELECTRON)], |r| -1.3 * 0.8 * 1.9 / r, [0.9, 1.7]);
    of_the_distance(Coulomb { k: 1.3 }, [(0.7, ION), (2.5, ION)], |r| 1.3 * 0.8 * 0.8 / r, [1.1, 0.6]);
    let lennard_jones = |r: f64| 2.8 * ((1.1 / r).powi(12) - (1.1 / r).powi(6));
    of_the_distance(LennardJones { epsilon: 0.7, sigma: 1.1 }, [light, heavy], lennard_jones, [1.4, 1.9]);
    let morse = |r: f64| 1.5 * (1.0 - (1.2 * (0.8 - r)).exp()).powi(2);
    of_the_distance(Morse { depth: 1.5, width: 1.2, length: 0.8 }, [light, heavy], morse, [0.6, 1.9]);
    let spring = |r: f64| 0.85 * (r - 1.1) * (r - 1.1);
    of_the_distance(Spring { k: 1.7, length: 1.1 }, [light, heavy], spring, [0.6, 1.9]);
    // k = 4/3 E √R for the force, two fifths of it for the energy.
    let spheres = |r: f64| 0.4 * (4.0 / 3.0) * 2.3 * (0.7_f64 * 1.2 / 1.9).sqrt() * (1.9 - r).max(0.0).powf(2.5);
    of_the_distance(HertzSpheres { modulus: 2.3 }, [(0.7, BALL), (2.5, LARGE)], spheres, [1.3, 1.6]);
    // Apart.
    of_the_distance(HertzSpheres { modulus: 2.3 }, [(0.7, BALL), (2.5, LARGE)], spheres, [2.1, 2.8]);

    let fput = |d: f64| 0.65 * d.powi(2) - 0.25 * d.powi(3) / 3.0 + 0.1 * d.powi(4);
    on_a_line(FermiPastaUlamTsingou { k: 1.3, alpha: 0.25, beta: 0.4 }, fput, [0.7, -0.4]);
    let toda = |d: f64| 0.8 / 1.4 * ((1.4 * d).exp() - 1.4 * d - 1.0);
    on_a_line(Toda { a: 0.8, b: 1.4 }, toda, [0.7, -0.9]);
    let hertz = |d: f64| 1.6 * d.max(0.0).powf(2.5);
    on_a_line(Hertz { k: 1.6 }, hertz, [0.4, 0.9]);
    on_a_line(Hertz { k: 1.6 }, hertz, [-0.4, -0.1]);
}

/// What acts between two bodies that carry nothing, or these.
macro_rules! between {
    ($law:expr, $d:literal) => {
        PairLaw::<$d, ()>::between(&$law, numbers::<(), _>(&$law, 1.0, &()), numbers::<(), _>(&$law, 1.0, &()), 0.0)
    };
    ($law:expr, $d:literal, $a:expr, $b:expr) => {
        PairLaw::<$d, _>::between(&$law, numbers(&$law, 1.0, &$a), numbers(&$law, 1.0, &$b), 0.0)
    };
}

fn near(computed: f64, expected: f64, what: &str) {
    assert!((computed - expected).abs() <= 1e-14 * (1.0 + expected.abs()), "{what}: {computed} {expected}");
}

#[test]
fn wells_are_where_they_are_said_to_be() {
    let atoms = LennardJones { epsilon: 0.7, sigma: 1.1 };
    assert_eq!(atoms.energy(1.1), 0.0);
    near(atoms.rest(), 2.0_f64.powf(1.0 / 6.0) * 1.1, "2^(1/6) σ");
    let molecule = Morse { depth: 1.5, width: 1.2, length: 0.8 };
    near(molecule.energy(60.0), 1.5, "dissociated");
    let spring = Spring { k: 1.7, length: 1.1 };
    macro_rules! well {
        ($law:expr, $rest:expr, $depth:expr, $small_period:expr) => {{
            let (acts, rest, what) = (between!($law, 1), $rest, stringify!($law));
            near(acts.potential([rest]), -$depth, what);
            near(acts.gradient([rest])[0], 0.0, what);
            assert!([0.9, 1.1].iter().all(|x| acts.potential([x * rest]) > -$depth), "{what}");
            // Reduced mass 3.
            near($small_period, core::f64::consts::TAU * (3.0 / acts.hessian([rest])[0][0]).sqrt(), what);
        }};
    }
    well!(atoms, atoms.rest(), 0.7, atoms.small_period(3.0));
    well!(molecule, 0.8, 0.0, molecule.period(0.0, 3.0));
    well!(spring, 1.1, 0.0, spring.period(3.0));
}

/// Coulomb's law is gravity where g m_a m_b = −k q_a q_b.
#[test]
fn charges_fall_as_masses_do() {
    let (charges, masses) = (Coulomb { k: 2.0 }, Gravity { g: 2.0 });
    let acts = between!(charges, 2, Charge { q: 1.5 }, Charge { q: -0.7 });
    let [a, b] = [1.5, 0.7].map(|mass| numbers(&masses, mass, &()));
    let falls = PairLaw::<2, ()>::between(&masses, a, b, 0.0);
    let (here, there) = ([0.6, -0.7], [0.5, -0.9]);
    near(acts.potential(here), falls.potential(here), "energy");
    for i in 0..2 {
        near(acts.gradient(here)[i], falls.gradient(here)[i], "gradient");
        near(acts.discrete_gradient(here, there)[i], falls.discrete_gradient(here, there)[i], "discrete gradient");
    }
    let pair = [Charge { q: 1.5 }, Charge { q: -0.7 }];
    near(charges.period(1.3, 1.5 * 0.7 / 2.2, pair), masses.period(1.3, 2.2), "period");
}

/// A Toda spring is linear for small r, that of Fermi, Pasta, Ulam and Tsingou to the fourth power of r, and its pull has a limit.
#[test]
fn a_toda_spring_begins_as_a_linear_one() {
    let (a, b) = (0.8, 1.4);
    let toda = Toda { a, b };
    let linear = FermiPastaUlamTsingou { k: a * b, alpha: 0.0, beta: 0.0 };
    let cubic = FermiPastaUlamTsingou { alpha: -a * b * b / 2.0, beta: a * b.powi(3) / 6.0, ..linear };
    let (toda, linear, cubic) = (between!(toda, 1), between!(linear, 1), between!(cubic, 1));
    let errors = [0.1, 0.01].map(|r: f64| {
        let [exact] = toda.gradient([-r]);
        [linear.gradient([-r]), cubic.gradient([-r])].map(|[pull]| (pull - exact).abs())
    });
    let order = |i: usize| (errors[0][i] / errors[1][i]).log10();
    assert!((order(0) - 2.0).abs() < 0.05 && (order(1) - 4.0).abs() < 0.05, "{errors:?}");
    near(toda.gradient([-60.0])[0], -a, "the greatest pull");
    near(toda.hessian([0.0])[0][0], a * b, "stiffness");
    assert_eq!((toda.potential([0.0]), toda.gradient([0.0])), (0.0, [0.0]));
}

/// Nothing at all outside a contact, and inside it the force of the textbooks, 4/3 E √R δ^(3/2).
#[test]
fn balls_that_are_apart_do_not_feel_each_other() {
    fn nothing<const D: usize>(acts: &impl Potential<D>, here: [f64; D], there: [f64; D]) {
        assert_eq!((acts.potential(here), acts.gradient(here), acts.hessian(here)), (0.0, [0.0; D], [[0.0; D]; D]));
        assert_eq!(acts.discrete_gradient(here, there), [0.0; D]);
        assert_eq!(acts.discrete_gradient_jacobian(here, there), [[0.0; D]; D]);
    }
    let (line, spheres) = (Hertz { k: 1.6 }, HertzSpheres { modulus: 2.3 });
    let beads = between!(line, 1);
    nothing(&beads, [-0.3], [-0.1]);
    nothing(&beads, [-0.3], [0.0]);
    let balls = between!(spheres, 2, BALL, LARGE);
    nothing(&balls, [1.6, 1.7], [-2.0, 0.3]);
    let radius = 0.7 * 1.2 / 1.9_f64;
    for overlap in [0.01, 0.2, 0.6_f64] {
        let force = 4.0 / 3.0 * 2.3 * radius.sqrt() * overlap.powf(1.5);
        near(balls.gradient([0.0, 1.9 - overlap])[1], -force, "between spheres");
        near(spheres.on_a_line(BALL, LARGE).force(overlap), force, "on a line");
        near(line.force(overlap), beads.gradient([overlap])[0], "of beads");
    }
}

/// No pair model is refused as one that is not what its method computes, at distances of all sizes and none.
#[test]
fn no_pair_model_is_refused() {
    let places = || (-40..=40).map(|exponent| 1.37 * 10.0_f64.powf(f64::from(exponent) / 4.0)).chain([0.0]);
    macro_rules! accepted {
        ($($law:expr, $data:expr;)*) => {$(
            for place in places() {
                let scene = Scene::new().body_with(1.3, [0.0], [0.1], $data).body_with(0.4, [place], [0.0], $data);
                let error = Simulation::scene(scene.chain($law)).scheme(Explicit).dt(0.1).stepper().err();
                assert!(!matches!(error, Some(dmech::Error::NotAsWritten(_))), "{error:?}");
            }
        )*};
    }
    accepted! {
        Gravity::default(), ();
        Coulomb::default(), ION;
        LennardJones::default(), ();
        Morse::default(), ();
        Spring::default(), ();
        FermiPastaUlamTsingou::default(), ();
        Toda::default(), ();
        Hertz::default(), ();
        HertzSpheres::default(), BALL;
    }
}
