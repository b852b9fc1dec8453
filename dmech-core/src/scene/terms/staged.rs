//! What acts at eight moments side by side.

use dmech_scalar::{Lanes, Real};

use super::Acts;
use super::each::EachReady;
use super::linked::{LinkedReady, OnLink};
use super::links::Links;
use super::whose::OfBodies;
use crate::law::{Between, LinkLaw, PairLaw, Potential};
use crate::scene::eights::Eights;
use crate::scene::space::Space;
use crate::scene::vectors::Vectors;
use crate::system::AtStages;
use crate::vector::{difference, sum};

/// Where all bodies are at eight moments.
#[derive(Clone, Copy, Debug)]
pub struct Moments<'a, const D: usize> {
    /// The times.
    pub(in crate::scene) t: Lanes,
    /// Positions, with driven bodies where they are.
    pub(in crate::scene) q: &'a Eights<D>,
    /// Velocities, where a force depends on them.
    pub(in crate::scene) v: &'a Eights<D>,
    /// The positions one by one, where distances decide who is linked; else of one moment, for the number of bodies.
    pub(in crate::scene) apart: &'a [Vectors<D>],
}

impl<const D: usize> Moments<'_, D> {
    #[inline(always)]
    fn body(&self, i: usize, forced: bool) -> BodyAtStages<D> {
        BodyAtStages { q: self.q.get(i), v: if forced { self.v.get(i) } else { [Lanes::ZERO; D] } }
    }
}

/// One body at eight moments.
#[derive(Clone, Copy, Debug)]
pub struct BodyAtStages<const D: usize> {
    /// Where it is.
    pub(in crate::scene) q: [Lanes; D],
    /// Its velocity, where a force depends on it.
    pub(in crate::scene) v: [Lanes; D],
}

/// What acts in a scene, asked for eight moments at once: each law in lanes.
pub trait ActsAtStages<const D: usize>: Acts<D> {
    /// Distances decide who is linked.
    const OF_DISTANCE: bool;
    /// What the bodies of one link feel of each other.
    type Felt: Copy;
    /// Nothing.
    const UNFELT: Self::Felt;

    /// out += ∇Φ − F.
    fn add_slopes(&self, at: &Moments<'_, D>, out: &mut Eights<D>);
    /// What acts between body a and the next one. Asked for only of a [chain](Acts::CHAIN), as is [`slope`](Self::slope).
    fn felt(&self, t: Lanes, a: usize, bodies: [&BodyAtStages<D>; 2]) -> Self::Felt;
    /// ∇Φ − F of a body between the links to the one before and the one after.
    fn slope(&self, t: Lanes, body: usize, at: &BodyAtStages<D>, links: [&Self::Felt; 2]) -> [Lanes; D];
}

impl<const D: usize> ActsAtStages<D> for () {
    const OF_DISTANCE: bool = false;
    type Felt = ();
    const UNFELT: () = ();

    fn add_slopes(&self, _: &Moments<'_, D>, _: &mut Eights<D>) {}

    fn felt(&self, _: Lanes, _: usize, _: [&BodyAtStages<D>; 2]) {}

    #[inline(always)]
    fn slope(&self, _: Lanes, _: usize, _: &BodyAtStages<D>, _: [&(); 2]) -> [Lanes; D] {
        [Lanes::ZERO; D]
    }
}

impl<const D: usize, A: ActsAtStages<D>, B: ActsAtStages<D>> ActsAtStages<D> for (A, B) {
    const OF_DISTANCE: bool = A::OF_DISTANCE || B::OF_DISTANCE;
    type Felt = (A::Felt, B::Felt);
    const UNFELT: Self::Felt = (A::UNFELT, B::UNFELT);

    #[inline]
    fn add_slopes(&self, at: &Moments<'_, D>, out: &mut Eights<D>) {
        self.0.add_slopes(at, out);
        self.1.add_slopes(at, out);
    }

    #[inline(always)]
    fn felt(&self, t: Lanes, a: usize, bodies: [&BodyAtStages<D>; 2]) -> Self::Felt {
        (self.0.felt(t, a, bodies), self.1.felt(t, a, bodies))
    }

    #[inline(always)]
    fn slope(&self, t: Lanes, body: usize, at: &BodyAtStages<D>, [before, after]: [&Self::Felt; 2]) -> [Lanes; D] {
        let last = self.1.slope(t, body, at, [&before.1, &after.1]);
        // A sum with nothing would be rounded to a zero of the other sign, and so cannot be left out by a compiler.
        if A::NOTHING { last } else { sum(self.0.slope(t, body, at, [&before.0, &after.0]), last) }
    }
}

impl<const D: usize, W: OfBodies<Law: AtStages<D, f64>>> ActsAtStages<D> for EachReady<W> {
    const OF_DISTANCE: bool = false;
    type Felt = ();
    const UNFELT: () = ();

    fn add_slopes(&self, at: &Moments<'_, D>, out: &mut Eights<D>) {
        for i in 0..self.masses.len() {
            out.add(i, self.slope(at.t, i, &at.body(i, Self::FORCED), [&(); 2]));
        }
    }

    fn felt(&self, _: Lanes, _: usize, _: [&BodyAtStages<D>; 2]) {}

    #[inline(always)]
    fn slope(&self, t: Lanes, body: usize, at: &BodyAtStages<D>, _: [&(); 2]) -> [Lanes; D] {
        self.laws.of(body).slopes(self.masses[body], t, at.q, at.v)
    }
}

impl<const D: usize, P, X: LinkLaw<D, P>, T: Links, B: Space<D>> ActsAtStages<D> for LinkedReady<X, T, P, B> {
    const OF_DISTANCE: bool = T::OF_DISTANCE;
    /// What the first feels, and the opposite of what the second does.
    type Felt = [[Lanes; D]; 2];
    const UNFELT: Self::Felt = [[Lanes::ZERO; D]; 2];

    #[inline]
    fn add_slopes(&self, at: &Moments<'_, D>, out: &mut Eights<D>) {
        let visit = |a, b| {
            // Not by `map`: it is not inlined for so large an array, and copies it for each pair.
            let (at_a, at_b) = (at.body(a, Self::FORCED), at.body(b, Self::FORCED));
            let [on_a, off_b] = self.between_at_stages(at.t, [a, b], [&at_a, &at_b]);
            out.add(a, on_a);
            out.subtract(b, off_b);
        };
        match (T::OF_DISTANCE, at.apart) {
            (true, [a, b, c, d, e, f, g, h]) => self.each([a, b, c, d, e, f, g, h], visit),
            (_, [first, ..]) => self.each([first], visit),
            _ => {}
        }
    }

    #[inline(always)]
    fn felt(&self, t: Lanes, a: usize, bodies: [&BodyAtStages<D>; 2]) -> Self::Felt {
        self.between_at_stages(t, [a, a + 1], bodies)
    }

    #[inline(always)]
    fn slope(&self, _: Lanes, _: usize, _: &BodyAtStages<D>, [before, after]: [&Self::Felt; 2]) -> [Lanes; D] {
        difference(after[0], before[1])
    }
}

impl<X: crate::law::Reads<P>, T: Links, P, B> LinkedReady<X, T, P, B> {
    /// What the bodies of a link feel of each other: ∇Φ − F of the first, and the opposite for the second.
    #[inline(always)]
    fn between_at_stages<const D: usize>(
        &self,
        t: Lanes,
        [a, b]: [usize; 2],
        [at_a, at_b]: [&BodyAtStages<D>; 2],
    ) -> [[Lanes; D]; 2]
    where
        X: LinkLaw<D, P>,
        B: Space<D>,
    {
        let between = |a, b| PairLaw::<D, P, Lanes>::between(&self.law, self.numbers.at(a), self.numbers.at(b), t);
        let (d, forward) = (self.space.image(difference(at_a.q, at_b.q)), between(a, b));
        let none = [Lanes::ZERO; D];
        let mut on_a = none;
        if OnLink::<D, P, X, Lanes>::POTENTIAL {
            on_a = forward.gradient(d);
        }
        let mut off_b = on_a;
        if OnLink::<D, P, X, Lanes>::FORCED {
            let (force, gradient) = (forward.force(d, at_a.v, at_b.v), on_a);
            on_a = difference(gradient, force);
            off_b = if OnLink::<D, P, X, Lanes>::RECIPROCAL {
                on_a
            } else {
                sum(gradient, between(b, a).force(d.map(|x| -x), at_b.v, at_a.v))
            };
        }
        let (acts_a, acts_b) = (self.acting.acts(a), self.acting.acts(b));
        [if acts_b { on_a } else { none }, if acts_a { off_b } else { none }]
    }
}
