//! What a law between two bodies gives along a link.

use core::array::from_fn;
use core::marker::PhantomData;

use super::packed::Packed;
use super::sweep::Kernel;
use crate::law::Potential;
use crate::law::{Numbers, PairLaw};
use crate::vector::{dot, scaled};

/// d ↦ ∇Φ(d).
pub(super) struct Slope<'a, X, P> {
    pub(super) law: &'a X,
    pub(super) t: f64,
    pub(super) data: PhantomData<fn() -> P>,
}

impl<X, P> Copy for Slope<'_, X, P> {}
impl<X, P> Clone for Slope<'_, X, P> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<const D: usize, P, R: Packed, X: PairLaw<D, P, R>> Kernel<D, 1, X::Numbers, R> for Slope<'_, X, P> {
    #[inline(always)]
    fn gradient(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [d]: [[R; D]; 1],
    ) -> [R; D] {
        self.law.between(a, b, R::from_f64(self.t)).gradient(d)
    }

    #[inline(always)]
    fn jacobian(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [d]: [[R; D]; 1],
    ) -> [[R; D]; D] {
        self.law.between(a, b, R::from_f64(self.t)).hessian(d)
    }
}

/// (d, d′) ↦ ∇̄Φ(d, d′).
pub(super) struct Secant<'a, X, P>(pub(super) Slope<'a, X, P>);

impl<X, P> Copy for Secant<'_, X, P> {}
impl<X, P> Clone for Secant<'_, X, P> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<const D: usize, P, R: Packed, X: PairLaw<D, P, R>> Kernel<D, 2, X::Numbers, R> for Secant<'_, X, P> {
    #[inline(always)]
    fn gradient(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [from, to]: [[R; D]; 2],
    ) -> [R; D] {
        self.0.law.between(a, b, R::from_f64(self.0.t)).discrete_gradient(from, to)
    }

    #[inline(always)]
    fn jacobian(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [from, to]: [[R; D]; 2],
    ) -> [[R; D]; D] {
        self.0.law.between(a, b, R::from_f64(self.0.t)).discrete_gradient_jacobian(from, to)
    }
}

/// (d, w) ↦ c ∂²Φ/∂d∂d w, linear in w: the second moment is that of the vectors which are turned.
pub(super) struct Turned<'a, X, P> {
    pub(super) slope: Slope<'a, X, P>,
    pub(super) c: f64,
}

impl<X, P> Copy for Turned<'_, X, P> {}
impl<X, P> Clone for Turned<'_, X, P> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<const D: usize, P, R: Packed, X: PairLaw<D, P, R>> Kernel<D, 2, X::Numbers, R> for Turned<'_, X, P> {
    #[inline(always)]
    fn gradient(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [d, w]: [[R; D]; 2],
    ) -> [R; D] {
        let hessian = self.slope.law.between(a, b, R::from_f64(self.slope.t)).hessian(d);
        let w = scaled(R::from_f64(self.c), w);
        from_fn(|k| dot(hessian[k], w))
    }

    #[inline(always)]
    fn jacobian(
        &self,
        a: <X::Numbers as Numbers>::Of<R>,
        b: <X::Numbers as Numbers>::Of<R>,
        [d, _]: [[R; D]; 2],
    ) -> [[R; D]; D] {
        let hessian = self.slope.law.between(a, b, R::from_f64(self.slope.t)).hessian(d);
        hessian.map(|row| scaled(R::from_f64(self.c), row))
    }
}
