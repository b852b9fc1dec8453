//! The time scale of a scene, against that of one body and against its own motion.

use core::array::from_fn;

use super::laws::{Attraction, Gravity, Pull, Pulls, Spring};
use crate::law::{Field, Law};
use crate::scene::builder::Scene;
use crate::scene::terms::{Acts, Moving, Term};
use crate::scene::vectors::Vectors;
use crate::system::{Course, Frequency, Look, Stiffness};

/// A scene after the time s, on the parabola of its accelerations.
fn look_at<const D: usize, L: Term<D, ()>>(scene: Scene<D, (), L>, least: f64, s: f64) -> Look {
    let bodies = &scene.bodies;
    let n = bodies.masses.len();
    let mut per_mass: Vec<f64> = bodies.masses.iter().map(|m| m.recip()).collect();
    bodies.pins.iter().for_each(|&i| per_mass[i] = 0.0);
    let [mut q, mut v] = [&bodies.q, &bodies.v].map(|list| Vectors::from_list(list));
    let acts = scene.laws.prepare(bodies, scene.space).unwrap();
    let mut slope = Vectors::zeros(n);
    let act = |q: &Vectors<D>, v: &Vectors<D>, slope: &mut Vectors<D>| {
        acts.set_gradient(q, bodies.t, slope);
        acts.subtract_force(1.0, q, v, bodies.t, slope);
    };
    act(&q, &v, &mut slope);
    for i in 0..n {
        let (v0, a) = (v.get(i), slope.get(i).map(|x| -per_mass[i] * x));
        v.add(i, a.map(|a| s * a));
        q.add(i, from_fn(|k| s * v0[k] + 0.5 * s * s * a[k]));
    }
    act(&q, &v, &mut slope);
    acts.look(&Moving { t: bodies.t, q: &q, v: &v, slope: &slope, per_mass: &per_mass, least })
}

fn look<const D: usize, L: Term<D, ()>>(scene: Scene<D, (), L>, least: f64) -> Look {
    look_at(scene, least, 0.0)
}

/// One body.
fn of_law<L: Law<D>, const D: usize>(law: &L, mass: f64, [q, v]: [[f64; D]; 2], least: f64) -> Look {
    let fall = law.field(mass, 0.0).slope(q, v).map(|x| -x / mass);
    let course = Course { q, v, fall, per_mass: mass.recip(), least };
    Frequency::of(course, |s, q, v| Stiffness::of(&law.field(mass, s), mass, s, q, v)).look(least)
}

/// The same of a separation.
fn of_link<L: Law<D>, const D: usize>(law: &L, mass: f64, [q, v]: [[f64; D]; 2], least: f64) -> Look {
    let fall = law.field(mass, 0.0).slope(q, v).map(|x| -x / mass);
    let course = Course { q, v, fall, per_mass: mass.recip(), least };
    Frequency::between(course, |s, q, v| Stiffness::of(&law.field(mass, s), mass, s, q, v)).look(least)
}

fn alike(what: &str, found: Look, expected: Look) {
    near(what, found, [expected.rate(), expected.growth], 1e-10);
}

fn near(what: &str, found: Look, [rate, growth]: [f64; 2], tolerance: f64) {
    assert!((found.rate() / rate - 1.0).abs() < tolerance, "{what}: ω {:e} for {rate:e}", found.rate());
    // Where it is zero, to the rounding of differences.
    let off = (found.growth - growth).abs();
    assert!(off <= tolerance * growth.abs().max(1e-2 * rate), "{what}: growth {:e} for {growth:e}", found.growth);
}

/// ω and its growth, by the twelfth powers of several; what passes counts for the one and not for the other.
fn together(looks: &[Look]) -> [f64; 2] {
    let powers = looks.iter().map(|look| {
        let power = look.rate().powi(12);
        [power, power * (1.0 - look.passing / look.power)]
    });
    let [sum, stays] = powers.clone().fold([0.0; 2], |[a, b], [x, y]| [a + x, b + y]);
    let growth = looks.iter().zip(powers).map(|(look, [_, power])| look.growth * power).sum::<f64>() / stays;
    [sum.powf(1.0 / 12.0), growth]
}

const A: [[f64; 2]; 2] = [[0.9, 0.3], [-0.4, 0.8]];
const B: [[f64; 2]; 2] = [[-0.5, 0.1], [0.3, -0.7]];
const BETWEEN: [[f64; 2]; 2] = [[1.4, 0.2], [-0.7, 1.5]];
const MASSES: [f64; 2] = [1.3, 0.4];
const REDUCED: f64 = MASSES[0] * MASSES[1] / (MASSES[0] + MASSES[1]);

fn two(masses: [f64; 2]) -> Scene<2> {
    Scene::new().body(masses[0], A[0], A[1]).body(masses[1], B[0], B[1])
}

/// Kepler's problem, in any units.
#[test]
fn two_bodies_are_one_of_reduced_mass() {
    for (length, time) in [(1.0_f64, 1.0_f64), (1.0, 1e150), (1.0, 1e-150), (1e-40, 1e-60), (1e40, 1e60), (1e30, 1e-60)]
    {
        let g = 1.7 * length.powi(3) / time / time;
        let scaled = |[q, v]: [[f64; 2]; 2]| [q.map(|x| x * length), v.map(|x| x * length / time)];
        let ([a, b], between) = ([A, B].map(scaled), scaled(BETWEEN));
        for least in [0.0, 0.3, 2.0] {
            let kepler = of_link(&Attraction(g * MASSES[0] * MASSES[1]), REDUCED, between, least / time);
            let scene = || Scene::new().body(MASSES[0], a[0], a[1]).body(MASSES[1], b[0], b[1]);
            alike("pairs", look(scene().pairs(Gravity { g }), least / time), kepler);
            alike("chain", look(scene().chain(Gravity { g }), least / time), kepler);
            alike("bonds", look(scene().bonds(Gravity { g }, [(1, 0)]), least / time), kepler);
            assert!(least > 1.0 || kepler.growth * time > 0.3, "{:e}", kepler.growth);
        }
    }
}

/// Forces count with their derivatives by the separation and by the relative velocity, also where they are not reciprocal.
#[test]
fn forces_between_two_bodies_are_one_in_their_separation() {
    let [ma, mb] = MASSES;
    let pull = Pull::<true> { k: 0.8, gamma: 3.0, beta: 1.0 };
    let law = Pulls([pull.k * ma * mb, pull.gamma * ma * mb, 0.0]);
    alike("reciprocal", look(two(MASSES).pairs(pull), 0.1), of_link(&law, REDUCED, BETWEEN, 0.1));

    let one_way = Pull::<false> { k: 0.8, gamma: 0.0, beta: 0.0 };
    let law = Pulls([one_way.k * (ma / mb + mb / ma), 0.0, 0.0]);
    alike("one way", look(two(MASSES).pairs(one_way), 0.1), of_link(&law, 1.0, BETWEEN, 0.1));

    let damped = Pull::<false> { k: 0.8, gamma: 3.0, beta: 0.6 };
    let law = Pulls([2.0 * damped.k, damped.gamma * (1.0 + damped.beta), 0.0]);
    alike("one way, damped", look(two([ma, ma]).pairs(damped), 0.1), of_link(&law, 1.0, BETWEEN, 0.1));
}

#[test]
fn a_pinned_body_has_infinite_mass() {
    let pinned = |scene: Scene<2>| scene.body(MASSES[0], A[0], A[1]).body(MASSES[1], [0.0; 2], [0.0; 2]).pin(1);
    let g = 1.7;
    let alone = of_link(&Attraction(g * MASSES[0] * MASSES[1]), MASSES[0], A, 0.0);
    alike("about a pin", look(pinned(Scene::new()).pairs(Gravity { g }), 0.0), alone);
    // A pinned body feels no field, and two of them no link.
    let field = of_law(&Attraction(g), MASSES[0], A, 0.0);
    let scene = Scene::new().body(2.0, [0.1, 0.0], [0.0; 2]).pin(0).body(MASSES[0], A[0], A[1]);
    alike("field", look(scene.field(Attraction(g)), 0.0), field);
    let still = Scene::new().body(2.0, [0.1, 0.0], [0.0; 2]).body(2.0, [0.0, 0.2], [0.0; 2]).pin(0).pin(1);
    let still = look(still.field(Attraction(g)).pairs(Gravity { g }), 0.0);
    assert_eq!((still.rate(), still.growth), (0.0, 0.0));
}

/// Two binaries far from each other, and the bodies of a field, by the twelfth powers of each.
#[test]
fn motions_are_joined_by_twelfth_powers() {
    let g = 1.7;
    let far = |q: [f64; 2]| [q[0] + 1e6, q[1] - 2e6];
    let [tight, wide] = [0.8, 0.83];
    let place = |scene: Scene<2>, scale: f64, far: &dyn Fn([f64; 2]) -> [f64; 2]| {
        let turn = if scale == wide { -1.0 } else { 1.0 };
        [(MASSES[0], A), (MASSES[1], B)]
            .iter()
            .fold(scene, |scene, (mass, [q, v])| scene.body(*mass, far(q.map(|x| scale * x)), v.map(|x| turn * x)))
    };
    let here = |q| q;
    let looks = [tight, wide].map(|scale| look(place(Scene::new(), scale, &here).pairs(Gravity { g }), 0.0));
    assert!(looks[0].growth * looks[1].growth < 0.0);
    let both = place(place(Scene::new(), tight, &here), wide, &far);
    near("binaries", look(both.clone().pairs(Gravity { g }), 0.0), together(&looks), 1e-8);
    let listed = look(both.bonds(Gravity { g }, [(0, 1)]).bonds(Gravity { g }, [(2, 3)]), 0.0);
    near("two terms", listed, together(&looks), 1e-8);

    let looks = [(MASSES[0], A), (MASSES[1], B)].map(|(mass, place)| of_law(&Attraction(g), mass, place, 0.0));
    near("fields", look(two(MASSES).field(Attraction(g)), 0.0), together(&looks), 1e-10);
}

/// ω² = k/μ along each link, and the smallest ω once for all of them.
#[test]
fn a_chain_of_springs_has_the_frequencies_of_its_links() {
    let (k, masses) = (2.3, [1.0, 0.7, 1.9, 0.4]);
    let chain = || {
        let bodies = masses.iter().enumerate();
        bodies.fold(Scene::<1>::new(), |scene, (i, &mass)| scene.body(mass, [i as f64], [0.3 * (i as f64).cos()]))
    };
    let sum: f64 = masses.windows(2).map(|m| (k / m[0] + k / m[1]).powi(6)).sum();
    for least in [0.0, 1e-3, 2.9] {
        let rate = (sum + f64::powi(least, 12)).powf(1.0 / 12.0);
        near("chain", look(chain().chain(Spring { k }), least), [rate, 0.0], 1e-12);
    }
    // Nothing acts, or nothing is pulled.
    for least in [0.0, 0.4, 1e-150, 1e150] {
        for nothing in [look(chain(), least), look(chain().chain(Spring { k: 0.0 }), least)] {
            assert!((nothing.rate() - least).abs() <= 1e-14 * least && nothing.growth == 0.0, "{nothing:?}");
        }
    }
}

/// Four bodies in all kinds of terms.
fn four(direction: f64) -> Scene<2, (), impl Term<2, ()>> {
    let bodies = [
        (1.0, [1.0, 0.2], [0.1, -0.3]),
        (0.7, [-0.6, 0.5], [0.6, 0.2]),
        (1.6, [0.1, -0.9], [-0.2, 0.4]),
        (0.2, [0.7, 1.1], [-0.5, -0.1]),
    ];
    let scene = bodies.iter().fold(Scene::new(), |scene, &(m, q, v)| scene.body(m, q, v.map(|v| direction * v)));
    let one_way = Pull::<false> { k: 0.4, gamma: 0.0, beta: 0.0 };
    scene.pairs(Gravity { g: 0.9 }).chain(Spring { k: 1.1 }).field(Attraction(0.5)).bonds(one_way, [(0, 2), (3, 1)])
}

#[test]
fn the_frequency_is_even_and_its_growth_odd() {
    for least in [0.0, 0.5] {
        let [there, back] = [1.0, -1.0].map(|direction| look(four(direction), least));
        assert_eq!(there.rate().to_bits(), back.rate().to_bits());
        assert_eq!(there.growth.to_bits(), (-back.growth).to_bits());
        assert!(there.growth.abs() > 0.1);
    }
}

/// The growth is that of ln ω along the motion, but for the change of accelerations, which a parabola does not know.
#[test]
fn growth_is_the_slope_of_the_logarithm() {
    fn slope<L: Term<2, ()>>(what: &str, scene: impl Fn() -> Scene<2, (), L>) {
        let s = 1e-4;
        let growth = (look_at(scene(), 0.0, s).rate() / look_at(scene(), 0.0, -s).rate()).ln() / (2.0 * s);
        let here = look(scene(), 0.0);
        near(what, here, [here.rate(), growth], 0.05);
    }
    slope("two bodies", || two(MASSES).pairs(Gravity { g: 1.7 }));
    slope("four bodies", || four(1.0));
    slope("four bodies back", || four(-1.0));
}

/// Frequencies too far apart for the numbers that there are.
#[test]
fn a_slow_motion_beside_a_fast_one_is_nothing() {
    let [slow, fast] = [1e-140_f64, 1e140].map(|time| Attraction(1.7 * time.powi(2)));
    let at = |law: &Attraction<f64>| {
        let course = Course { q: A[0], v: [0.0; 2], fall: [0.0; 2], per_mass: 1.0, least: 0.0 };
        Frequency::of(course, |_, q, v| Stiffness::of(&Law::<2>::field(law, 1.0, 0.0), 1.0, 0.0, q, v))
    };
    let alone = at(&fast).look(0.0);
    assert_eq!(at(&slow).and(at(&fast)).look(0.0), alone);
    assert_eq!(at(&fast).and(at(&slow)).look(0.0), alone);
    assert_eq!(Frequency::none(0.0).and(at(&fast)).look(0.0), alone);
}
