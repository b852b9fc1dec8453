//! Few bodies, as a scene and as one law: laws of every kind that a scene tells apart.

use dmech::models::pairs::{Charge, Coulomb, LennardJones, Spring};
use dmech::scene::{FewBodies, OnBonds, OnChain, OnEach, OnEachOwn, OnNear, OnPairs, Periodic, Scene, Term};

/// What the terms `L` make of N bodies in D dimensions, which carry `P`.
pub type Few<L, P, const D: usize, const N: usize, const K: usize> = FewBodies<<L as Term<D, P>>::Ready, D, N, K>;

/// The same in a box.
pub type FewInBox<L, P, const D: usize, const N: usize, const K: usize> =
    FewBodies<<L as Term<D, P, Periodic<D>>>::Ready, D, N, K>;

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
fn falling(a: f64) -> Scene<1> {
    (0..4).fold(Scene::new(), |scene, i| {
        let x = f64::from(i);
        scene.body(0.6 + 0.2 * x, [0.2 + x + 0.1 * (x * x).sin()], [-0.4 + 0.1 * a * x])
    })
}

/// They are a chain.
pub fn rope(k: usize) -> Scene<1, (), OfRope> {
    let a = part(k, 0.41);
    falling(a).chain(Link { k: 5.0 + a, omega: 1.1 }).field(Floor { k: 40.0 + 10.0 * a, c: 0.1 + 0.1 * part(k, 0.53) })
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

type OfPlasma = (((), OnEachOwn<Trap, Charge>), OnPairs<Pull>);

/// Three ions, each in a well of its own, whose charges turn either way; one may be pinned.
pub fn plasma(k: usize) -> Scene<2, Charge, OfPlasma> {
    let (a, held) = (part(k, 0.23), k % 4);
    let bodies = [
        (1.0, [0.9, 0.0], [0.0, 0.3 * a], 1.0),
        (1.5, [-0.4, 0.8 + 0.1 * a], [0.2, 0.0], -0.7),
        (0.8, [-0.5, -0.9], [0.0, -0.2], 1.2 + 0.1 * a),
    ];
    let scene = bodies.into_iter().enumerate().fold(Scene::new(), |scene, (i, (mass, q, v, charge))| {
        scene.body_with(mass, q, if i == held { [0.0; 2] } else { v }, Charge { q: charge })
    });
    let scene = if held < 3 { scene.pin(held) } else { scene };
    let well = move |i: usize, &Charge { q }: &Charge| Trap { k: 1.1 + 0.3 * a + 0.2 * i as f64, b: 0.9 * q };
    scene.field_of(well).pairs(Pull { g: 0.3, eps: 0.4 })
}

/// A well that grows and shrinks, steeper for what is heavy, in a wind that turns.
#[derive(Clone, Copy, Debug)]
pub struct Swell {
    pub k: f64,
    pub omega: f64,
}

#[dmech::law]
impl Swell {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64, t: f64) -> f64 {
        let s = q[0] * q[0] + q[1] * q[1];
        self.k * (1.0 + 0.4 * (self.omega * t).sin()) * m * m * s * (1.0 + 0.5 * s)
    }
    #[force]
    fn wind(&self, q: [f64; 2], t: f64) -> [f64; 2] {
        let c = 3.0 * (1.7 * self.omega * t).cos();
        [c * q[1], -c * q[0] * q[0]]
    }
}

/// Pushes between bodies that come and go.
#[derive(Clone, Copy, Debug)]
pub struct Gusts {
    pub c: f64,
    pub omega: f64,
}

#[dmech::law]
impl Gusts {
    #[pair_force]
    fn force(&self, d: [f64; 2], ma: f64, mb: f64, t: f64) -> [f64; 2] {
        let c = self.c * ma * mb * mb * (self.omega * t).cos() / (1.0 + d[0] * d[0] + d[1] * d[1]);
        [c * d[0], c * d[1]]
    }
}

type OfTides = (((), OnEach<Swell>), OnPairs<Gusts>);

pub type Tides = Few<OfTides, (), 2, 3, 6>;

/// Three under laws that name the time, and read masses.
pub fn tides(k: usize) -> Scene<2, (), OfTides> {
    let a = part(k, 0.31);
    Scene::new()
        .body(0.7, [0.9, 0.1 * a], [0.0, 0.6])
        .body(1.6, [-0.4, 0.8], [0.5, -0.1 * a])
        .body(1.1, [-0.6, -0.9], [-0.3, 0.2])
        .field(Swell { k: 0.6 + 0.1 * a, omega: 1.3 })
        .pairs(Gusts { c: 0.2, omega: 2.1 + 0.2 * a })
        .at_time(0.25 * part(k, 0.71))
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

/// They are linked as a list says.
pub fn beads(k: usize) -> Scene<1, (), OfBeads> {
    let a = part(k, 0.43);
    let list = LISTS[(k + k / 16) % LISTS.len()].iter().copied();
    falling(a).bonds(Link { k: 5.0 + a, omega: 1.1 }, list).field(Floor { k: 40.0 + 10.0 * a, c: 0.1 })
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

type OfFluid = ((), OnNear<LennardJones>);

pub type Fluid = FewInBox<OfFluid, (), 3, 4, 12>;

/// Four atoms within a cut-off, in a box of another size for each k.
pub fn fluid(k: usize) -> Scene<3, (), OfFluid, Periodic<3>> {
    let a = part(k, 0.17);
    let (length, fast) = (4.0 + 0.5 * a, 1.2);
    Scene::new()
        .body(1.0, [0.2, 0.3 + 0.1 * a, 0.1], [0.3, fast, -0.2])
        .body(1.3, [length - 0.9, 0.4, 0.2], [-0.4, 0.1, 0.3 * a])
        .body(0.8, [1.9, 0.2, length - 0.7], [fast, -0.3, 0.2])
        .body(1.1, [0.3, length + 1.6, 1.1], [-0.2, 0.4, -fast])
        .pairs(LennardJones { epsilon: 1.0 + 0.2 * a, sigma: 1.0 })
        .cutoff(1.5 + 0.3 * part(k, 0.53))
        .periodic([length, length + 0.3, length - 0.2])
        .at_time(0.25 * part(k, 0.71))
}

type OfLoops = (((), OnBonds<Spring>), OnPairs<Pull>);

pub type Loops = FewInBox<OfLoops, (), 2, 3, 6>;

/// Three that are linked across the edge of a box and jump to other images; for every other k two of them are half a box apart at first.
pub fn loops(k: usize) -> Scene<2, (), OfLoops, Periodic<2>> {
    let a = part(k, 0.23);
    let (lists, odd): ([List; 3], _) = ([&[(0, 1)], &[(1, 0), (2, 1)], &[]], (k % 2) as f64);
    Scene::new()
        .body(1.0, [0.5, 0.5], [1.4 + a, 0.2])
        .body(1.3, [1.5, 1.75 - 0.1 * odd], [-0.5, 0.9])
        .body(0.9, [5.75 - 0.1 * a, 0.25 - 0.94 * odd], [0.2, -1.1])
        .bonds(Spring { k: 0.3 + 0.1 * a, length: 0.8 }, lists[k % lists.len()].iter().copied())
        .pairs(Pull { g: 0.1, eps: 0.3 })
        .periodic([2.0 + 0.25 * odd, 2.5])
}

/// Ropes that hang from one of their ends, from both, from none; sometimes all are held.
pub fn hung(k: usize) -> Scene<2, (), OfHung> {
    let a = part(k, 0.37);
    let held: &[usize] = [&[0][..], &[0, 3], &[], &[2, 1], &[0, 1, 2, 3]][k % 5];
    let bodies = (0..4).fold(Scene::new(), |scene, i| {
        let (x, moves) = (f64::from(i), if held.contains(&(i as usize)) { 0.0 } else { 1.0 });
        scene.body(0.6 + 0.2 * x, [x - 0.1 * a, 0.1 * x * x + 0.37], [0.2 * moves * a, -0.3 * moves])
    });
    let scene = bodies.chain(Spring { k: 20.0 + a, length: 1.0 }).pairs(Shy { k: 0.3, c: 0.2 }).field(Down { g: 1.0 });
    held.iter().fold(scene, |scene, &i| scene.pin(i))
}

type OfHung = ((((), OnChain<Spring>), OnPairs<Shy>), OnEach<Down>);

pub type Hung = Few<OfHung, (), 2, 4, 8>;

/// Weight.
#[derive(Clone, Copy, Debug)]
pub struct Down {
    pub g: f64,
}

#[dmech::law]
impl Down {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64) -> f64 {
        m * self.g * q[1]
    }
}

/// Bodies that do not like to be near each other, and slow each other down.
#[derive(Clone, Copy, Debug)]
pub struct Shy {
    pub k: f64,
    pub c: f64,
}

#[dmech::law]
impl Shy {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        self.k / (0.2 + r * r)
    }
    #[pair_force]
    fn force(&self, va: [f64; 2], vb: [f64; 2]) -> [f64; 2] {
        [-self.c * (va[0] - vb[0]), -self.c * (va[1] - vb[1])]
    }
}

pub type Tied = Few<((), OnBonds<Bond>), (), 2, 4, 8>;

/// Molecules of which one body or none is held.
pub fn tied(k: usize) -> Scene<2, (), ((), OnBonds<Bond>)> {
    let (a, held) = (part(k, 0.37), k % 5);
    let moves = |i: usize| if i == held { 0.0 } else { 1.0 };
    let bodies = [(1.0, [0.0, 0.1 * a]), (0.7 + 0.2 * a, [1.1, 0.1]), (1.6, [1.2, 1.0]), (0.9, [0.1, 0.9 + 0.1 * a])];
    let bodies = bodies.into_iter().enumerate();
    let scene =
        bodies.fold(Scene::new(), |scene, (i, (m, q))| scene.body(m, q, [0.1 * moves(i), (a - 0.5) * moves(i)]));
    let scene = scene.bonds(Bond { k: 6.0 + a, length: 0.9 }, LISTS[k % 3].iter().copied());
    if held < 4 { scene.pin(held) } else { scene }
}

/// A sun with three planets.
pub fn planets() -> Scene<2> {
    Scene::new()
        .body(5.0, [0.1, 0.0], [0.0, -0.113])
        .body(0.3, [1.1, 0.2], [-0.2, 2.05])
        .body(0.1, [-2.3, 0.1], [0.1, -1.3])
        .body(0.02, [0.0, 4.4], [-1.1, 0.0])
}

/// Friction between two bodies.
#[derive(Clone, Copy, Debug)]
pub struct Damper {
    pub c: f64,
}

#[dmech::law]
impl Damper {
    #[pair_force]
    fn force(&self, va: [f64; 2], vb: [f64; 2]) -> [f64; 2] {
        [self.c * (vb[0] - va[0]), self.c * (vb[1] - va[1])]
    }
}
