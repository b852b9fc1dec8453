//! Few bodies of which some are test bodies, as a scene and as one law.

use dmech::models::pairs::{Charge, Coulomb, Gravity, LennardJones};
use dmech::scene::{
    FewBodies, OnBonds, OnChain, OnEach, OnEachOwn, OnNear, OnPairs, Periodic, Restricted, Scene, Term,
};

use crate::few::{Bond, Chase, Creature, Floor, LISTS, Link, Pull, Trap, part};

/// What the terms `L` make of N bodies in D dimensions, which carry `P`.
type Few<L, P, const D: usize, const N: usize, const K: usize> =
    FewBodies<<L as Term<D, P>>::Ready, D, N, K, Restricted>;

/// Which of four bodies are test bodies: the last, two, none, the first and one beside it, all.
pub const TESTS: [&[usize]; 7] = [&[3], &[2, 3], &[], &[0], &[1, 2], &[0, 1, 2, 3], &[1]];

/// Whether body i of the k-th scene is a test body.
pub fn is_test(k: usize, i: usize) -> bool {
    TESTS[k % TESTS.len()].contains(&i)
}

/// Adds body i of the k-th scene.
fn add<const D: usize, P>(
    scene: Scene<D, P>,
    (k, i): (usize, usize),
    (mass, q, v, data): (f64, [f64; D], [f64; D], P),
) -> Scene<D, P> {
    if is_test(k, i) { scene.test_body_with(mass, q, v, data) } else { scene.body_with(mass, q, v, data) }
}

pub type Clones = Few<((), OnPairs<Gravity>), (), 2, 4, 8>;

/// A sun, a planet, and two more: of two test bodies each is where the other is.
pub fn clones(k: usize) -> Scene<2, (), ((), OnPairs<Gravity>)> {
    let (a, both) = (part(k, 0.17), is_test(k, 2) && is_test(k, 3));
    let third = (0.03, [-2.0, 0.2 * a], [0.1, -0.9 + 0.1 * a], ());
    let fourth = if both { third } else { (0.02, [0.3, 3.2 + 0.2 * a], [-0.7, 0.1], ()) };
    let bodies = [(1.6 + a, [0.1, -0.1 * a], [0.0, 0.05], ()), (0.05, [1.1, 0.1], [-0.1, 1.3], ()), third, fourth];
    let scene = bodies.into_iter().enumerate().fold(Scene::new(), |scene, (i, body)| add(scene, (k, i), body));
    scene.pairs(Gravity { g: 0.9 + 0.2 * a }).at_time(0.25 * part(k, 0.71))
}

type OfCords = (((), OnChain<Link>), OnEach<Floor>);

pub type Cords = Few<OfCords, (), 1, 4, 4>;

/// Four on a line that fall, under links that differ to either side and name the time.
pub fn cords(k: usize) -> Scene<1, (), OfCords> {
    let a = part(k, 0.41);
    let scene = (0..4).fold(Scene::new(), |scene, i| {
        let x = i as f64;
        add(scene, (k, i), (0.6 + 0.2 * x, [0.2 + x + 0.1 * (x * x).sin()], [-0.4 + 0.1 * a * x], ()))
    });
    scene.chain(Link { k: 5.0 + a, omega: 1.1 }).field(Floor { k: 40.0 + 10.0 * a, c: 0.1 })
}

type OfHerds = (((), OnPairs<Chase>), OnBonds<Chase>);

pub type Herds = Few<OfHerds, Creature, 2, 3, 6>;

/// Three that run after each other, and some of them more so.
pub fn herds(k: usize) -> Scene<2, Creature, OfHerds> {
    let a = part(k, 0.61);
    let creature = |fear, hunger| Creature { fear, hunger };
    let bodies = [
        (1.0, [0.0, 0.1], [0.1, 0.2 * a], creature(0.3, 1.1)),
        (1.9, [1.0 + 0.3 * a, 0.0], [-0.2, 0.0], creature(1.7, 0.2)),
        (0.7, [0.2, 1.3], [0.0, -0.3], creature(0.4, 0.9 + 0.2 * a)),
    ];
    let scene = bodies.into_iter().enumerate().fold(Scene::new(), |scene, (i, body)| add(scene, (k, i), body));
    let more = [(2, 0), (0, 1)].into_iter().take(k % 3);
    scene.pairs(Chase { k: 0.4 + 0.1 * a, c: 0.5 }).bonds(Chase { k: 0.2, c: 0.3 }, more)
}

pub type Tethers = Few<((), OnBonds<Bond>), (), 2, 4, 8>;

/// Four along bonds whose ends differ; some are pinned, test bodies too.
pub fn tethers(k: usize) -> Scene<2, (), ((), OnBonds<Bond>)> {
    let (a, held) = (part(k, 0.37), k % 5);
    let bodies = [(1.0, [0.0, 0.1 * a]), (0.7 + 0.2 * a, [1.1, 0.1]), (1.6, [1.2, 1.0]), (0.9, [0.1, 0.9 + 0.1 * a])];
    let scene = bodies.into_iter().enumerate().fold(Scene::new(), |scene, (i, (mass, q))| {
        let moves = if i == held { 0.0 } else { 1.0 };
        add(scene, (k, i), (mass, q, [0.1 * moves, (a - 0.5) * moves], ()))
    });
    let scene = scene.bonds(Bond { k: 6.0 + a, length: 0.9 }, LISTS[k % 3].iter().copied());
    if held < 4 { scene.pin(held) } else { scene }
}

/// Three ions.
fn charged(k: usize) -> Scene<2, Charge> {
    let a = part(k, 0.23);
    let bodies = [
        (1.0, [0.9, 0.0], [0.0, 0.3 * a], Charge { q: 1.0 }),
        (1.5, [-0.4, 0.8 + 0.1 * a], [0.2, 0.0], Charge { q: 0.7 }),
        (0.8, [-0.5, -0.9], [0.0, -0.2], Charge { q: 1.2 + 0.1 * a }),
    ];
    bodies.into_iter().enumerate().fold(Scene::new(), |scene, (i, body)| add(scene, (k, i), body))
}

type OfTraps = (((), OnEach<Trap>), OnPairs<Coulomb>);

pub type Traps = Few<OfTraps, Charge, 2, 3, 6>;

/// Three ions in a trap.
pub fn traps(k: usize) -> Scene<2, Charge, OfTraps> {
    let a = part(k, 0.23);
    charged(k).field(Trap { k: 1.1 + 0.2 * a, b: 0.9 }).pairs(Coulomb { k: 0.8 })
}

type OfSprays = (((), OnEachOwn<Trap, Charge>), OnPairs<Coulomb>);

/// Three ions, each in a trap of its own.
pub fn sprays(k: usize) -> Scene<2, Charge, OfSprays> {
    let a = part(k, 0.23);
    let trap = move |i: usize, charge: &Charge| Trap { k: 1.1 + 0.2 * a + 0.3 * i as f64, b: 0.9 * charge.q };
    charged(k).field_of(trap).pairs(Coulomb { k: 0.8 })
}

type OfVapours = (((), OnNear<LennardJones>), OnPairs<Pull>);

pub type Vapours = FewBodies<<OfVapours as Term<2, (), Periodic<2>>>::Ready, 2, 4, 8, Restricted>;

/// Four atoms within a cut-off, that pull on each other in a box.
pub fn vapours(k: usize) -> Scene<2, (), OfVapours, Periodic<2>> {
    let (a, length) = (part(k, 0.17), 4.0 + 0.5 * part(k, 0.17));
    let bodies = [
        (1.0, [0.2, 0.3 + 0.1 * a], [0.3, -0.2]),
        (1.3, [length - 0.9, 0.4], [-0.4, 0.1 + 0.3 * a]),
        (0.8, [1.5, length - 0.7], [0.3, 0.2]),
        (1.1, [0.4, length + 1.6], [-0.2, -0.6]),
    ];
    let bodies = bodies.into_iter().enumerate();
    let scene = bodies.fold(Scene::new(), |scene, (i, (mass, q, v))| add(scene, (k, i), (mass, q, v, ())));
    let scene = scene.pairs(LennardJones { epsilon: 1.0 + 0.2 * a, sigma: 1.0 }).cutoff(1.5 + 0.3 * part(k, 0.53));
    scene.pairs(Pull { g: 0.2, eps: 0.3 }).periodic([length, length + 0.3]).at_time(0.25 * part(k, 0.71))
}
