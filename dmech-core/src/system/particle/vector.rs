//! Arithmetic of arrays, for schemes and for laws by hand.

use core::array::from_fn;

use dmech_scalar::{Mask, Real};

/// x + c y.
#[inline(always)]
pub fn add_scaled<const D: usize, R: Real>(x: [R; D], c: R, y: [R; D]) -> [R; D] {
    from_fn(|i| c.mul_add(y[i], x[i]))
}

/// c x.
#[inline(always)]
pub fn scaled<const D: usize, R: Real>(c: R, x: [R; D]) -> [R; D] {
    x.map(|x| c * x)
}

/// x + y.
#[inline(always)]
pub fn sum<const D: usize, R: Real>(x: [R; D], y: [R; D]) -> [R; D] {
    from_fn(|i| x[i] + y[i])
}

/// x − y.
#[inline(always)]
pub fn difference<const D: usize, R: Real>(x: [R; D], y: [R; D]) -> [R; D] {
    from_fn(|i| x[i] - y[i])
}

/// x·y.
#[inline(always)]
pub fn dot<const D: usize, R: Real>(x: [R; D], y: [R; D]) -> R {
    if D == 0 {
        return R::ZERO;
    }
    let mut sum = x[0] * y[0];
    for i in 1..D {
        sum = x[i].mul_add(y[i], sum);
    }
    sum
}

/// Σ wᵢ xᵢ yᵢ; [`dot`] to the bit where the weights are 1.
#[inline(always)]
pub fn weighted<const D: usize, R: Real>(weights: [f64; D], x: [R; D], y: [R; D]) -> R {
    dot(from_fn(|i| R::from_f64(weights[i]) * x[i]), y)
}

/// Every component is finite in every lane.
#[inline(always)]
pub fn finite<const D: usize, R: Real>(x: [R; D]) -> bool {
    x.iter().all(|x| x.finite().all())
}
