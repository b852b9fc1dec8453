//! What a law between two bodies gives along a link.

use core::marker::PhantomData;

use super::packed::Packed;
use super::sweep::Kernel;
use super::way::Way;
use crate::law::{Numbers, PairLaw, Potential};
use crate::scene::space::Space;
use crate::vector::{by_component, by_entry, dot, scaled};

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

impl<const D: usize, P, R: Packed, X: PairLaw<D, P, R>, B: Space<D>> Kernel<D, 1, X::Numbers, R>
    for Slope<'_, X, P, B>
{
    #[inline(always)]
    fn gradient(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [d]: [[R; D]; 1],
    ) -> [R; D] {
        self.law.between(a, b, R::from_f64(self.t)).gradient(self.space.image(d))
    }

    #[inline(always)]
    fn jacobian(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [d]: [[R; D]; 1],
    ) -> [[R; D]; D] {
        self.law.between(a, b, R::from_f64(self.t)).hessian(self.space.image(d))
    }
}

/// (d, d′) ↦ ∇̄Φ(d, d′).
pub(super) struct Secant<'a, X, P, B>(pub(super) Slope<'a, X, P, B>);

impl<X, P, B: Copy> Copy for Secant<'_, X, P, B> {}
impl<X, P, B: Copy> Clone for Secant<'_, X, P, B> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<const D: usize, P, R: Packed, X: PairLaw<D, P, R>, B: Space<D>> Kernel<D, 2, X::Numbers, R>
    for Secant<'_, X, P, B>
{
    #[inline(always)]
    fn gradient(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [from, to]: [[R; D]; 2],
    ) -> [R; D] {
        let between = self.0.law.between(a, b, R::from_f64(self.0.t));
        Way::new(&self.0.space, from, to).discrete_gradient(&between)
    }

    #[inline(always)]
    fn jacobian(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [from, to]: [[R; D]; 2],
    ) -> [[R; D]; D] {
        let between = self.0.law.between(a, b, R::from_f64(self.0.t));
        Way::new(&self.0.space, from, to).discrete_gradient_jacobian(&between)
    }
}

/// (d, w) ↦ c ∂²Φ/∂d∂d w, linear in w: the second moment is that of the vectors which are turned.
pub(super) struct Turned<'a, X, P, B> {
    pub(super) slope: Slope<'a, X, P, B>,
    pub(super) c: f64,
}

impl<X, P, B: Copy> Copy for Turned<'_, X, P, B> {}
impl<X, P, B: Copy> Clone for Turned<'_, X, P, B> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<const D: usize, P, R: Packed, X: PairLaw<D, P, R>, B: Space<D>> Kernel<D, 2, X::Numbers, R>
    for Turned<'_, X, P, B>
{
    const PLACES: usize = 1;

    #[inline(always)]
    fn gradient(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [d, w]: [[R; D]; 2],
    ) -> [R; D] {
        let hessian = self.slope.law.between(a, b, R::from_f64(self.slope.t)).hessian(self.slope.space.image(d));
        let w = scaled(R::from_f64(self.c), w);
        by_component!(|k| dot(hessian[k], w))
    }

    #[inline(always)]
    fn jacobian(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [d, _]: [[R; D]; 2],
    ) -> [[R; D]; D] {
        let hessian = self.slope.law.between(a, b, R::from_f64(self.slope.t)).hessian(self.slope.space.image(d));
        by_entry!(|k, l| R::from_f64(self.c) * hessian[k][l])
    }
}
