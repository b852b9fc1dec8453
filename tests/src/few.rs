//! Few bodies, as a scene and as one law: laws of every kind that a scene tells apart.

use dmech::models::pairs::{Charge, Coulomb, Spring};
use dmech::scene::{FewBodies, OnBonds, OnChain, OnEach, OnPairs, Scene, Term};

/// What the terms `L` make of N bodies in D dimensions, which carry `P`.
pub type Few<L, P, const D: usize, const N: usize, const K: usize> = FewBodies<<L as Term<D, P>>::Ready, D, N, K>;

/// A number that differs from member to member, in [0, 1).
pub fn part(k: usize, of: f64) -> f64 {
    (0.37 + of * k as f64).fract()
}

/// Gravity, softened.
#[derive(Clone, Copy, Debug)]
pub struct Pull {
    pub g: f64,
    pub eps: f64,
}

#[dmech::law]
impl Pull {
    #[pair]
    fn energy(&self, r: f64, ma: f64, mb: f64) -> f64 {
        -self.g * ma * mb / (r * r + self.eps * self.eps).sqrt()
    }
}

pub type Stars = Few<((), OnPairs<Pull>), (), 2, 3, 6>;

/// Three stars in the plane.
pub fn stars(k: usize) -> Scene<2, (), ((), OnPairs<Pull>)> {
    let (a, b) = (part(k, 0.17), part(k, 0.29));
    Scene::new()
        .body(1.3 + a, [0.7 + 0.4 * a, 0.1], [-0.05, 0.4 + 0.2 * b])
        .body(0.8, [-0.5, 0.2 * b], [0.1, -0.6])
        .body(0.4 + 0.1 * b, [0.1, 1.4], [0.5, 0.1 * a])
        .pairs(Pull { g: 0.9 + 0.2 * b, eps: 0.2 + 0.1 * a })
        .at_time(0.25 * part(k, 0.71))
}

/// A spring that stiffens, of another strength to either side, whose length is driven.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    pub k: f64,
    pub omega: f64,
}

#[dmech::law]
impl Link {
    #[pair]
    fn energy(&self, d: [f64; 1], ma: f64, t: f64) -> f64 {
        let x = d[0] + 1.0 + 0.05 * (self.omega * t).cos();
        0.5 * self.k * x * x + 0.1 * ma * x.powi(3) + 0.25 * x.powi(4)
    }
}

/// A contact with a floor, and a drag.
#[derive(Clone, Copy, Debug)]
pub struct Floor {
    pub k: f64,
    pub c: f64,
}

#[dmech::law]
impl Floor {
    #[potential]
    fn energy(&self, q: f64, m: f64) -> f64 {
        let contact = if q < 0.0 { 0.5 * self.k * q * q } else { 0.0 };
        contact + 0.3 * m * q
    }
    #[force]
    fn drag(&self, v: f64) -> f64 {
        -self.c * v
    }
}

type OfRope = (((), OnChain<Link>), OnEach<Floor>);

pub type Rope = Few<OfRope, (), 1, 4, 4>;

/// Four bodies on a line, that fall.
pub fn rope(k: usize) -> Scene<1, (), OfRope> {
    let a = part(k, 0.41);
    let bodies = (0..4).fold(Scene::new(), |scene, i| {
        let x = f64::from(i);
        scene.body(0.6 + 0.2 * x, [0.2 + x + 0.1 * (x * x).sin()], [-0.4 + 0.1 * a * x])
    });
    bodies.chain(Link { k: 5.0 + a, omega: 1.1 }).field(Floor { k: 40.0 + 10.0 * a, c: 0.1 + 0.1 * part(k, 0.53) })
}

/// Whom a body runs from and whom it runs after.
#[derive(Clone, Copy, Debug)]
pub struct Creature {
    pub fear: f64,
    pub hunger: f64,
}

/// A force that is not reciprocal, beside a potential.
#[derive(Clone, Copy, Debug)]
pub struct Chase {
    pub k: f64,
    pub c: f64,
}

#[dmech::law]
impl Chase {
    #[pair]
    fn energy(&self, d: [f64; 2], a: &Creature, b: &Creature) -> f64 {
        self.k * (1.0 + a.fear * b.fear) / (0.3 + d[0] * d[0] + d[1] * d[1])
    }
    #[pair_force]
    fn force(&self, d: [f64; 2], va: [f64; 2], vb: [f64; 2], ma: f64, a: &Creature, b: &Creature) -> [f64; 2] {
        let c = self.c * ma * (a.fear - a.hunger) * b.hunger;
        [c * d[0] - 0.1 * b.fear * (va[0] - vb[0]), c * d[1] - 0.1 * b.fear * (va[1] - vb[1])]
    }
}

pub type Creatures = Few<((), OnPairs<Chase>), Creature, 2, 3, 6>;

/// Three that run after each other.
pub fn creatures(k: usize) -> Scene<2, Creature, ((), OnPairs<Chase>)> {
    let a = part(k, 0.61);
    Scene::new()
        .body_with(1.0, [0.0, 0.1], [0.1, 0.2 * a], Creature { fear: 0.3, hunger: 1.1 })
        .body_with(1.9, [1.0 + 0.3 * a, 0.0], [-0.2, 0.0], Creature { fear: 1.7, hunger: 0.2 })
        .body_with(0.7, [0.2, 1.3], [0.0, -0.3], Creature { fear: 0.4, hunger: 0.9 + 0.2 * a })
        .pairs(Chase { k: 0.4 + 0.1 * a, c: 0.5 })
}

/// A well, and a field B.
#[derive(Clone, Copy, Debug)]
pub struct Trap {
    pub k: f64,
    pub b: f64,
}

#[dmech::law]
impl Trap {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        0.5 * self.k * (q[0] * q[0] + q[1] * q[1])
    }
    #[force]
    fn lorentz(&self, v: [f64; 2]) -> [f64; 2] {
        [self.b * v[1], -self.b * v[0]]
    }
}

type OfIons = (((), OnEach<Trap>), OnPairs<Coulomb>);

pub type Ions = Few<OfIons, Charge, 2, 3, 6>;

/// Three ions in a trap.
pub fn ions(k: usize) -> Scene<2, Charge, OfIons> {
    let a = part(k, 0.23);
    Scene::new()
        .body_with(1.0, [0.9, 0.0], [0.0, 0.3 * a], Charge { q: 1.0 })
        .body_with(1.5, [-0.4, 0.8 + 0.1 * a], [0.2, 0.0], Charge { q: 0.7 })
        .body_with(0.8, [-0.5, -0.9], [0.0, -0.2], Charge { q: 1.2 + 0.1 * a })
        .field(Trap { k: 1.1 + 0.2 * a, b: 0.9 })
        .pairs(Coulomb { k: 0.8 })
}

/// Bonds: a list.
type List = &'static [(usize, usize)];

/// A bond whose two ends differ, that diverges where they meet.
#[derive(Clone, Copy, Debug)]
pub struct Bond {
    pub k: f64,
    pub length: f64,
}

#[dmech::law]
impl Bond {
    #[pair]
    fn energy(&self, d: [f64; 2], ma: f64, mb: f64) -> f64 {
        let r = (d[0] * d[0] + d[1] * d[1]).sqrt();
        0.5 * self.k * (r - self.length) * (r - self.length) + 0.05 * ma / r + 0.1 * mb * d[0]
    }
}

pub type Molecules = Few<((), OnBonds<Bond>), (), 2, 4, 8>;

/// Those of four bodies: a ring, a star, one bond, none, and two of which each is listed from its end.
pub const LISTS: [List; 5] =
    [&[(0, 1), (1, 2), (2, 3), (3, 0)], &[(1, 0), (1, 2), (3, 1)], &[(2, 0)], &[], &[(3, 2), (1, 0)]];

/// Four bodies, of which those that are not linked may be in one place.
pub fn molecules(k: usize) -> Scene<2, (), ((), OnBonds<Bond>)> {
    let (a, list) = (part(k, 0.37), LISTS[k % LISTS.len()]);
    let fourth = if list.len() < 2 { [1.1, 0.1] } else { [0.1, 0.9 + 0.1 * a] };
    Scene::new()
        .body(1.0, [0.0, 0.1 * a], [0.1, -0.2])
        .body(0.7 + 0.2 * a, [1.1, 0.1], [-0.1, 0.3 * a])
        .body(1.6, [1.2, 1.0], [0.2, 0.1])
        .body(0.9, fourth, [-0.1, 0.3 * a])
        .bonds(Bond { k: 6.0 + a, length: 0.9 + 0.1 * a }, list.iter().copied())
        .at_time(0.25 * part(k, 0.71))
}

type OfClusters = (((), OnPairs<Pull>), OnBonds<Spring>);

pub type Clusters = Few<OfClusters, (), 3, 4, 12>;

/// Four in space that all pull on each other, and are linked.
pub fn clusters(k: usize) -> Scene<3, (), OfClusters> {
    let (a, list) = (part(k, 0.19), LISTS[k / 16 % LISTS.len()]);
    Scene::new()
        .body(1.2, [0.0, 0.1 * a, 0.4], [0.1, -0.2, 0.0])
        .body(0.7, [1.1, 0.1, 0.0], [-0.1, 0.3 * a, 0.2])
        .body(1.5, [1.2, 1.0, -0.1], [0.2, 0.1, 0.1])
        .body(0.8 + 0.1 * a, [0.1, 1.1, 0.3], [-0.1, 0.3, -0.2])
        .pairs(Pull { g: 0.3, eps: 0.3 })
        .bonds(Spring { k: 3.0 + a, length: 1.0 }, list.iter().copied())
}

type OfBeads = (((), OnBonds<Link>), OnEach<Floor>);

pub type Beads = Few<OfBeads, (), 1, 4, 4>;

/// Four on a line that fall, linked as the list says.
pub fn beads(k: usize) -> Scene<1, (), OfBeads> {
    let a = part(k, 0.43);
    let bodies = (0..4).fold(Scene::new(), |scene, i| {
        let x = f64::from(i);
        scene.body(0.6 + 0.2 * x, [0.2 + x + 0.1 * (x * x).sin()], [-0.4 + 0.1 * a * x])
    });
    let list = LISTS[(k + k / 16) % LISTS.len()].iter().copied();
    bodies.bonds(Link { k: 5.0 + a, omega: 1.1 }, list).field(Floor { k: 40.0 + 10.0 * a, c: 0.1 })
}

pub type Packs = Few<((), OnBonds<Chase>), Creature, 2, 3, 6>;

/// Three, some of which run after each other.
pub fn packs(k: usize) -> Scene<2, Creature, ((), OnBonds<Chase>)> {
    let a = part(k, 0.67);
    let lists: [List; 4] = [&[(0, 1), (1, 2)], &[(1, 0), (0, 2)], &[], &[(2, 0), (0, 1), (1, 2)]];
    Scene::new()
        .body_with(1.0, [0.0, 0.1], [0.1, 0.2 * a], Creature { fear: 0.3, hunger: 1.1 })
        .body_with(1.9, [1.0 + 0.3 * a, 0.0], [-0.2, 0.0], Creature { fear: 1.7, hunger: 0.2 })
        .body_with(0.7, [0.2, 1.3], [0.0, -0.3], Creature { fear: 0.4, hunger: 0.9 + 0.2 * a })
        .bonds(Chase { k: 0.4 + 0.1 * a, c: 0.5 }, lists[k % lists.len()].iter().copied())
}
