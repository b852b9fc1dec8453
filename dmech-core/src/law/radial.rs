//! Potentials of the distance alone, Φ = φ(s) with s = |d|², in any number of dimensions.
//!
//! With c = 2 φ′ the gradient is c d; with C = (φ(s_b) − φ(s_a))/(s_b − s_a) the discrete gradient is C (a + b), along the
//! sum, which is what keeps the angular momentum (Kanatani (3.25) is an instance).

use dmech_scalar::Real;

use crate::vector::{dot, scaled, sum};

/// |d|².
#[inline(always)]
pub fn square<const D: usize, R: Real>(d: [R; D]) -> R {
    dot(d, d)
}

/// c d.
#[inline(always)]
pub fn gradient<const D: usize, R: Real>(c: R, d: [R; D]) -> [R; D] {
    scaled(c, d)
}

/// c 1 + 2c′ d⊗d, with c′ = dc/ds.
#[inline(always)]
pub fn hessian<const D: usize, R: Real>(c: R, c1: R, d: [R; D]) -> [[R; D]; D] {
    rank_one(c, scaled(c1 + c1, d), d)
}

/// C (a + b).
#[inline(always)]
pub fn discrete_gradient<const D: usize, R: Real>(c: R, a: [R; D], b: [R; D]) -> [R; D] {
    scaled(c, sum(a, b))
}

/// C 1 + 2 ∂C/∂s_b (a + b)⊗b.
#[inline(always)]
pub fn discrete_gradient_jacobian<const D: usize, R: Real>(c: R, c1: R, a: [R; D], b: [R; D]) -> [[R; D]; D] {
    rank_one(c, scaled(c1 + c1, sum(a, b)), b)
}

/// c 1 + x⊗y.
#[inline(always)]
fn rank_one<const D: usize, R: Real>(c: R, x: [R; D], y: [R; D]) -> [[R; D]; D] {
    // Loops, as nested closures over arrays are not inlined.
    let mut sum = [[R::ZERO; D]; D];
    for i in 0..D {
        for j in 0..D {
            sum[i][j] = if i == j { x[i].mul_add(y[j], c) } else { x[i] * y[j] };
        }
    }
    sum
}
