//! What acts at eight moments side by side.

use core::array::from_fn;

use dmech_scalar::Lanes;

use super::each::EachReady;
use super::linked::LinkedReady;
use super::links::Links;
use super::{Acts, Driven};
use crate::law::{Between, Law, LinkLaw, PairLaw, Potential};
use crate::scene::eights::Eights;
use crate::scene::space::Space;
use crate::scene::vectors::Vectors;
use crate::system::AtStages;

/// Where all bodies are at eight moments.
#[derive(Clone, Copy, Debug)]
pub struct Moments<'a, const D: usize> {
    /// The times.
    pub(in crate::scene) t: Lanes,
    /// Positions.
    pub(in crate::scene) q: &'a Eights<D>,
    /// Velocities, where a force depends on them.
    pub(in crate::scene) v: &'a Eights<D>,
    /// The positions one by one, where distances decide who is linked; else of one moment, for the number of bodies.
    pub(in crate::scene) apart: &'a [Vectors<D>],
}

/// What acts in a scene, asked for eight moments at once: each law in lanes.
pub trait ActsAtStages<const D: usize>: Acts<D> {
    /// Distances decide who is linked.
    const OF_DISTANCE: bool;

    /// out += ∇Φ − F.
    fn add_slopes(&self, at: &Moments<'_, D>, out: &mut Eights<D>);
}

impl<const D: usize> ActsAtStages<D> for () {
    const OF_DISTANCE: bool = false;

    fn add_slopes(&self, _: &Moments<'_, D>, _: &mut Eights<D>) {}
}

impl<const D: usize, A: ActsAtStages<D>, B: ActsAtStages<D>> ActsAtStages<D> for (A, B) {
    const OF_DISTANCE: bool = A::OF_DISTANCE || B::OF_DISTANCE;

    #[inline]
    fn add_slopes(&self, at: &Moments<'_, D>, out: &mut Eights<D>) {
        self.0.add_slopes(at, out);
        self.1.add_slopes(at, out);
    }
}

/// Driven bodies are where they are: [`Moments`] has them there.
impl<const D: usize, A: ActsAtStages<D>> ActsAtStages<D> for Driven<D, A> {
    const OF_DISTANCE: bool = A::OF_DISTANCE;

    #[inline]
    fn add_slopes(&self, at: &Moments<'_, D>, out: &mut Eights<D>) {
        self.acts.add_slopes(at, out);
    }
}

impl<const D: usize, X: Law<D> + AtStages<D, f64>> ActsAtStages<D> for EachReady<X> {
    const OF_DISTANCE: bool = false;

    fn add_slopes(&self, at: &Moments<'_, D>, out: &mut Eights<D>) {
        for (i, &mass) in self.masses.iter().enumerate() {
            let v = if Self::FORCED { at.v.get(i) } else { [Lanes::default(); D] };
            out.add(i, self.law.slopes(mass, at.t, at.q.get(i), v));
        }
    }
}

impl<const D: usize, P, X: LinkLaw<D, P>, T: Links, B: Space<D>> ActsAtStages<D> for LinkedReady<X, T, P, B> {
    const OF_DISTANCE: bool = T::OF_DISTANCE;

    #[inline]
    fn add_slopes(&self, at: &Moments<'_, D>, out: &mut Eights<D>) {
        let visit = |a, b| self.add_link_at_stages(a, b, at, out);
        match (T::OF_DISTANCE, at.apart) {
            (true, [a, b, c, d, e, f, g, h]) => self.each([a, b, c, d, e, f, g, h], visit),
            (_, [first, ..]) => self.each([first], visit),
            _ => {}
        }
    }
}

impl<X: crate::law::Reads<P>, T: Links, P, B> LinkedReady<X, T, P, B> {
    /// What the bodies of a link feel of each other.
    #[inline(always)]
    fn add_link_at_stages<const D: usize>(&self, a: usize, b: usize, at: &Moments<'_, D>, out: &mut Eights<D>)
    where
        X: LinkLaw<D, P>,
        B: Space<D>,
    {
        let between = |a, b| PairLaw::<D, P, Lanes>::between(&self.law, self.numbers.at(a), self.numbers.at(b), at.t);
        let (qa, qb) = (at.q.get(a), at.q.get(b));
        let mut d = qa;
        for k in 0..D {
            d[k] -= qb[k];
        }
        let (d, forward) = (self.space.image(d), between(a, b));
        let (acts_a, acts_b) = (self.acting.acts(a), self.acting.acts(b));
        let mut on_a = [Lanes::default(); D];
        if <X as PairLaw<D, P, Lanes>>::Between::<'_>::POTENTIAL {
            on_a = forward.gradient(d);
        }
        let forced = <X as PairLaw<D, P, Lanes>>::Between::<'_>::FORCED;
        let reciprocal = !forced || <X as PairLaw<D, P, Lanes>>::Between::<'_>::RECIPROCAL;
        if forced {
            let (va, vb) = (at.v.get(a), at.v.get(b));
            if !reciprocal && acts_a {
                let back = between(b, a).force(d.map(|x| -x), vb, va);
                out.subtract(b, from_fn(|k| on_a[k] + back[k]));
            }
            let force = forward.force(d, va, vb);
            for k in 0..D {
                on_a[k] -= force[k];
            }
        }
        if acts_b {
            out.add(a, on_a);
        }
        if reciprocal && acts_a {
            out.subtract(b, on_a);
        }
    }
}
