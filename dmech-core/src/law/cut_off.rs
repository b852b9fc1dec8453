//! A law that ends at a distance.

use core::any::{Any, TypeId};

use dmech_scalar::{Mask, Real};

use super::written::WrittenPair;
use super::{Between, Numbers, PairFields, PairLaw, Reads};
use super::{LinearInVelocity, Potential, VelocityIndependent};
use crate::vector::{by_entry, dot, either, either_matrix, scaled, sum};

/// A law of the distance, cut off at r: Φ(d) − Φ(r) within, 0 beyond. Where Φ(r) = 0 it is the law as it is.
///
/// The potential is continuous, so that the energy is an invariant; the force jumps at r by Φ′(r), unless that is 0.
///
/// Across the cut-off, with s = |d|² and i the end that lies within, the discrete gradient is
///
/// ```text
/// ∇̄Φ(a, b) = C f (a + b),   C = (φ(r²) − φ(sᵢ))/(r² − sᵢ),   f = (r² − sᵢ)/|s_b − s_a|
/// ```
///
/// the law's own secant up to the cut-off, times the part f of the way that lies within. The secant identity holds to
/// rounding, it is along a + b, and it is continuous where an end comes to lie at r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutOff<X> {
    law: X,
    cutoff: f64,
}

impl<X> CutOff<X> {
    pub(crate) fn new(law: X, cutoff: f64) -> Self {
        CutOff { law, cutoff }
    }

    /// The law itself.
    pub fn law(&self) -> &X {
        &self.law
    }

    /// The same, to be changed; of a stepper `law_mut::<LennardJones>()` finds it.
    pub fn law_mut(&mut self) -> &mut X {
        &mut self.law
    }
}

impl<X: LinearInVelocity> LinearInVelocity for CutOff<X> {}

impl<X: VelocityIndependent> VelocityIndependent for CutOff<X> {}

impl<P, X: Reads<P> + 'static> Reads<P> for CutOff<X> {
    type Numbers = X::Numbers;

    fn numbers(mass: f64, data: &P) -> X::Numbers {
        X::numbers(mass, data)
    }

    fn inner(&mut self, of: TypeId) -> Option<&mut dyn Any> {
        (TypeId::of::<X>() == of).then_some(&mut self.law)
    }
}

impl<const D: usize, P, R: Real, X: PairLaw<D, P, R> + 'static> PairLaw<D, P, R> for CutOff<X> {
    type Between<'a>
        = Cut<X::Between<'a>, R>
    where
        Self: 'a;

    const AUTONOMOUS: bool = X::AUTONOMOUS;

    #[inline(always)]
    fn between(&self, a: <X::Numbers as Numbers>::Of<R>, b: <X::Numbers as Numbers>::Of<R>, t: R) -> Self::Between<'_> {
        Cut { between: self.law.between(a, b, t), r: R::from_f64(self.cutoff) }
    }

    fn written(&self) -> Option<&dyn WrittenPair<D, P>> {
        self.law.written()
    }
}

/// The numbers of the law, and r after them.
impl<const D: usize, P, X: PairFields<D, P> + 'static> PairFields<D, P> for CutOff<X> {
    type Fields = (X::Fields, [f64; 1]);
    type Moment<R: Real> = Cut<X::Moment<R>, R>;

    fn fields(&self) -> Self::Fields {
        (self.law.fields(), [self.cutoff])
    }

    fn names(see: &mut dyn FnMut(&'static str)) {
        X::names(see);
        see("cutoff");
    }

    #[inline(always)]
    fn moment<R: Real>(
        (law, [r]): (<X::Fields as Numbers>::Of<R>, [R; 1]),
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        t: R,
    ) -> Self::Moment<R> {
        Cut { between: X::moment(law, a, b, t), r }
    }
}

/// What acts between two bodies, cut off at r.
#[derive(Clone, Copy, Debug)]
pub struct Cut<B, R> {
    between: B,
    r: R,
}

/// x at the first component: the law does not depend on the direction.
#[inline(always)]
fn along<const D: usize, R: Real>(x: R) -> [R; D] {
    let mut d = [R::ZERO; D];
    if let Some(first) = d.first_mut() {
        *first = x;
    }
    d
}

/// x where it is so, else 0.
#[inline(always)]
fn only<const D: usize, R: Real>(mask: R::Mask, x: [R; D]) -> [R; D] {
    either(mask, x, [R::ZERO; D])
}

#[inline(always)]
fn only_block<const D: usize, R: Real>(mask: R::Mask, x: [[R; D]; D]) -> [[R; D]; D] {
    either_matrix(mask, x, [[R::ZERO; D]; D])
}

/// Both ends of a way: which lie within, and the squares of the distances.
struct Ends<R: Real> {
    both: R::Mask,
    /// One of them lies beyond.
    across: R::Mask,
    /// a lies within.
    from: R::Mask,
    squares: [R; 2],
}

impl<B, R: Real> Cut<B, R> {
    #[inline(always)]
    fn within<const D: usize>(&self, d: [R; D]) -> R::Mask {
        dot(d, d).less(self.r * self.r)
    }

    #[inline(always)]
    fn ends<const D: usize>(&self, a: [R; D], b: [R; D]) -> Ends<R> {
        let (squares, square) = ([dot(a, a), dot(b, b)], self.r * self.r);
        let [from, to] = squares.map(|s| s.less(square));
        Ends { both: from.and(to), across: from.and(to.not()).or(to.and(from.not())), from, squares }
    }

    /// C f of a way across the cut-off.
    #[inline(always)]
    fn part<const D: usize>(&self, ends: &Ends<R>) -> R
    where
        B: Potential<D, R>,
    {
        let [from, to] = ends.squares;
        let (inner, outer) = (R::either(ends.from, from, to), R::either(ends.from, to, from));
        let distance = inner.sqrt();
        let secant: [R; D] = self.between.discrete_gradient(along(distance), along(self.r));
        let slope = secant.first().map_or(R::ZERO, |&x| x) / (distance + self.r);
        slope * ((self.r * self.r - inner) / (outer - inner))
    }
}

impl<const D: usize, R: Real, B: Potential<D, R>> Potential<D, R> for Cut<B, R> {
    const CENTRAL: bool = B::CENTRAL;
    const PIECEWISE: bool = true;

    #[inline(always)]
    fn potential(&self, d: [R; D]) -> R {
        let shifted = self.between.potential(d) - self.between.potential(along(self.r));
        R::either(self.within(d), shifted, R::ZERO)
    }

    #[inline(always)]
    fn gradient(&self, d: [R; D]) -> [R; D] {
        only(self.within(d), self.between.gradient(d))
    }

    #[inline(always)]
    fn hessian(&self, d: [R; D]) -> [[R; D]; D] {
        only_block::<D, R>(self.within(d), self.between.hessian(d))
    }

    #[inline(always)]
    fn discrete_gradient(&self, a: [R; D], b: [R; D]) -> [R; D] {
        let ends = self.ends(a, b);
        let inside = only(ends.both, self.between.discrete_gradient(a, b));
        if !ends.across.any() {
            return inside;
        }
        either(ends.across, scaled(self.part::<D>(&ends), sum(a, b)), inside)
    }

    #[inline(always)]
    fn discrete_gradient_jacobian(&self, a: [R; D], b: [R; D]) -> [[R; D]; D] {
        let ends = self.ends(a, b);
        let inside = only_block::<D, R>(ends.both, self.between.discrete_gradient_jacobian(a, b));
        if !ends.across.any() {
            return inside;
        }
        // K 1 + (a + b)⊗(∇Φ(b) − 2 K b)/(s_b − s_a) with K = C f, and ∇Φ(b) only where b lies within.
        let [from, to] = ends.squares;
        let (part, length, way) = (self.part::<D>(&ends), to - from, sum(a, b));
        let slope = only(ends.from.not(), self.between.gradient(b));
        let row = |k: usize, l: usize| {
            let bent = way[k] * ((slope[l] - (part + part) * b[l]) / length);
            if k == l { bent + part } else { bent }
        };
        either_matrix(ends.across, by_entry!(|k, l| row(k, l)), inside)
    }
}

impl<const D: usize, R: Real, B: Between<D, R>> Between<D, R> for Cut<B, R> {
    const POTENTIAL: bool = B::POTENTIAL;
    const FORCED: bool = B::FORCED;
    const RECIPROCAL: bool = B::RECIPROCAL;

    #[inline(always)]
    fn reaches(&self, d: [R; D]) -> Option<R::Mask> {
        Some(self.within(d))
    }

    #[inline(always)]
    fn force(&self, d: [R; D], va: [R; D], vb: [R; D]) -> [R; D] {
        only(self.within(d), self.between.force(d, va, vb))
    }

    #[inline(always)]
    fn force_jacobians(&self, d: [R; D], va: [R; D], vb: [R; D]) -> [[[R; D]; D]; 3] {
        let within = self.within(d);
        let [by_d, by_va, by_vb] = self.between.force_jacobians(d, va, vb);
        [only_block::<D, R>(within, by_d), only_block::<D, R>(within, by_va), only_block::<D, R>(within, by_vb)]
    }
}
