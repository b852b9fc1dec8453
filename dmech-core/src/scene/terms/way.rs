//! The way of a separation in a step, where its image may become another one.

use crate::law::Potential;
use crate::scene::space::Images;
use crate::vector::{difference, dot, either, either_matrix, sum};
use dmech_scalar::{Mask, Real};

/// From one separation to another.
///
/// In a box the nearest image of the end may be another one than that of the start. The secant is then
///
/// ```text
/// G = (∇̄Φ(a, a + Δ) + ∇̄Φ(b − Δ, b))/2 + c Δ/|Δ|²,   c = (Φ(b) − Φ(a + Δ) + Φ(b − Δ) − Φ(a))/2
/// ```
///
/// with the images a and b of both ends and the way Δ itself, so that G·Δ = Φ(b) − Φ(a): the energy is kept.
pub(in crate::scene) struct Way<'a, B, const D: usize, R: Real> {
    space: &'a B,
    from: [R; D],
    to: [R; D],
}

/// Both ends as images, each with where the other would be if the image stayed.
struct Ends<const D: usize, R: Real> {
    moved: [R; D],
    a: [R; D],
    beyond: [R; D],
    before: [R; D],
    b: [R; D],
    /// The image has become another one.
    jumps: R::Mask,
}

impl<'a, const D: usize, R: Real, B: Images<D, R>> Way<'a, B, D, R> {
    #[inline(always)]
    pub(in crate::scene) fn new(space: &'a B, from: [R; D], to: [R; D]) -> Self {
        Way { space, from, to }
    }

    #[inline(always)]
    fn ends(&self) -> Ends<D, R> {
        let (a, b, moved) =
            (self.space.nearest(self.from), self.space.nearest(self.to), difference(self.to, self.from));
        let (beyond, before) = (sum(a, moved), difference(b, moved));
        let mut jumps = R::Mask::of(false);
        for k in 0..D {
            jumps = jumps.or(self.space.half(k).less((beyond[k] - b[k]).abs()));
        }
        Ends { moved, a, beyond, before, b, jumps }
    }

    /// ∇̄Φ.
    #[inline(always)]
    pub(in crate::scene) fn discrete_gradient(&self, law: &impl Potential<D, R>) -> [R; D] {
        if !B::PERIODIC {
            return law.discrete_gradient(self.from, self.to);
        }
        let ends = self.ends();
        let plain = law.discrete_gradient(ends.a, ends.b);
        if ends.jumps.any() { either(ends.jumps, ends.secant(law), plain) } else { plain }
    }

    /// ∂∇̄Φ/∂(the end).
    #[inline(always)]
    pub(in crate::scene) fn discrete_gradient_jacobian(&self, law: &impl Potential<D, R>) -> [[R; D]; D] {
        if !B::PERIODIC {
            return law.discrete_gradient_jacobian(self.from, self.to);
        }
        let ends = self.ends();
        let plain = law.discrete_gradient_jacobian(ends.a, ends.b);
        if !ends.jumps.any() {
            return plain;
        }
        either_matrix(ends.jumps, ends.secant_jacobian(law), plain)
    }
}

impl<const D: usize, R: Real> Ends<D, R> {
    /// c/|Δ|².
    fn missing(&self, law: &impl Potential<D, R>) -> R {
        let end = law.potential(self.b) - law.potential(self.beyond);
        let start = law.potential(self.before) - law.potential(self.a);
        R::from_f64(0.5) * (end + start) / dot(self.moved, self.moved)
    }

    fn secant(&self, law: &impl Potential<D, R>) -> [R; D] {
        let (half, missing) = (R::from_f64(0.5), self.missing(law));
        let ends = sum(law.discrete_gradient(self.a, self.beyond), law.discrete_gradient(self.before, self.b));
        core::array::from_fn(|k| missing.mul_add(self.moved[k], half * ends[k]))
    }

    /// The ends b and a + Δ move with the end of the way; a and b − Δ stay.
    fn secant_jacobian(&self, law: &impl Potential<D, R>) -> [[R; D]; D] {
        let (half, missing) = (R::from_f64(0.5), self.missing(law));
        let per_square = dot(self.moved, self.moved).recip();
        let ends = [(self.a, self.beyond), (self.before, self.b)].map(|(a, b)| law.discrete_gradient_jacobian(a, b));
        let slope = difference(law.gradient(self.b), law.gradient(self.beyond));
        let mut jacobian = [[R::ZERO; D]; D];
        for k in 0..D {
            for l in 0..D {
                let bent = half * slope[l] - (missing + missing) * self.moved[l];
                jacobian[k][l] = half * (ends[0][k][l] + ends[1][k][l]) + self.moved[k] * bent * per_square;
            }
            jacobian[k][k] += missing;
        }
        jacobian
    }
}
