//! What a law between two bodies gives along a link.

use core::marker::PhantomData;

use super::packed::Packed;
use super::sweep::Kernel;
use super::way::Way;
use crate::law::{Numbers, PairLaw, Potential, Reads};
use crate::scene::space::Space;
use crate::vector::{by_component, by_entry, dot, scaled};

/// What a law reads of a body, in a scalar.
type Read<X, P, R> = <<X as Reads<P>>::Numbers as Numbers>::Of<R>;

/// d ↦ ∇Φ(d).
pub(super) struct Slope<'a, X, P, B> {
    pub(super) law: &'a X,
    pub(super) t: f64,
    pub(super) space: B,
    pub(super) data: PhantomData<fn() -> P>,
}

impl<X, P, B: Copy> Copy for Slope<'_, X, P, B> {}
impl<X, P, B: Copy> Clone for Slope<'_, X, P, B> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<X, P, B> Slope<'_, X, P, B> {
    #[inline(always)]
    fn between<const D: usize, R: Packed>(&self, a: Read<X, P, R>, b: Read<X, P, R>) -> X::Between<'_>
    where
        X: PairLaw<D, P, R>,
    {
        self.law.between(a, b, R::from_f64(self.t))
    }
}

impl<const D: usize, P, R: Packed, X: PairLaw<D, P, R>, B: Space<D>> Kernel<D, 1, X::Numbers, R>
    for Slope<'_, X, P, B>
{
    #[inline(always)]
    fn gradient(&self, a: Read<X, P, R>, b: Read<X, P, R>, [d]: [[R; D]; 1]) -> [R; D] {
        self.between(a, b).gradient(self.space.image(d))
    }

    #[inline(always)]
    fn jacobian(&self, a: Read<X, P, R>, b: Read<X, P, R>, [d]: [[R; D]; 1]) -> [[R; D]; D] {
        self.between(a, b).hessian(self.space.image(d))
    }
}

/// (d, d′) ↦ ∇̄Φ(d, d′).
#[derive(Clone, Copy)]
pub(super) struct Secant<S>(pub(super) S);

impl<const D: usize, P, R: Packed, X: PairLaw<D, P, R>, B: Space<D>> Kernel<D, 2, X::Numbers, R>
    for Secant<Slope<'_, X, P, B>>
{
    #[inline(always)]
    fn gradient(&self, a: Read<X, P, R>, b: Read<X, P, R>, [from, to]: [[R; D]; 2]) -> [R; D] {
        Way::new(&self.0.space, from, to).discrete_gradient(&self.0.between(a, b))
    }

    #[inline(always)]
    fn jacobian(&self, a: Read<X, P, R>, b: Read<X, P, R>, [from, to]: [[R; D]; 2]) -> [[R; D]; D] {
        Way::new(&self.0.space, from, to).discrete_gradient_jacobian(&self.0.between(a, b))
    }
}

/// (d, w) ↦ c ∂²Φ/∂d∂d w, linear in w: the second moment is that of the vectors which are turned.
#[derive(Clone, Copy)]
pub(super) struct Turned<S> {
    pub(super) slope: S,
    pub(super) c: f64,
}

impl<const D: usize, P, R: Packed, X: PairLaw<D, P, R>, B: Space<D>> Kernel<D, 2, X::Numbers, R>
    for Turned<Slope<'_, X, P, B>>
{
    const PLACES: usize = 1;

    #[inline(always)]
    fn gradient(&self, a: Read<X, P, R>, b: Read<X, P, R>, [d, w]: [[R; D]; 2]) -> [R; D] {
        let hessian = self.slope.jacobian(a, b, [d]);
        let w = scaled(R::from_f64(self.c), w);
        by_component!(|k| dot(hessian[k], w))
    }

    #[inline(always)]
    fn jacobian(&self, a: Read<X, P, R>, b: Read<X, P, R>, [d, _]: [[R; D]; 2]) -> [[R; D]; D] {
        let hessian = self.slope.jacobian(a, b, [d]);
        by_entry!(|k, l| R::from_f64(self.c) * hessian[k][l])
    }
}
