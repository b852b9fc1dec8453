//! Polynomials with 4, 6 or 8 coefficients, lowest power first, by Estrin's scheme.
//!
//! Horner's rule is one chain of n dependent products and sums. Estrin's scheme pairs the terms,
//! (c₀ + c₁y) + y²(c₂ + c₃y) + …, and waits for three of them at eight coefficients instead of seven;
//! without a fused instruction that halves the time. (G. Estrin, Proc. Western Joint IRE–AIEE–ACM Computer
//! Conference (1960) 33–40.)

use crate::Real;

/// c₀ + c₁ y.
#[inline(always)]
fn linear(y: f64, c: [f64; 2]) -> f64 {
    Real::mul_add(c[1], y, c[0])
}

/// c₀ + c₁ y + c₂ y² + c₃ y³.
#[inline(always)]
pub(crate) fn cubic(y: f64, c: [f64; 4]) -> f64 {
    Real::mul_add(linear(y, [c[2], c[3]]), y * y, linear(y, [c[0], c[1]]))
}

/// c₀ + … + c₅ y⁵.
#[inline(always)]
pub(crate) fn quintic(y: f64, c: [f64; 6]) -> f64 {
    let y2 = y * y;
    let high = Real::mul_add(linear(y, [c[4], c[5]]), y2, linear(y, [c[2], c[3]]));
    Real::mul_add(high, y2, linear(y, [c[0], c[1]]))
}

/// c₀ + … + c₇ y⁷.
#[inline(always)]
pub(crate) fn septic(y: f64, c: [f64; 8]) -> f64 {
    let y2 = y * y;
    let low = cubic(y, [c[0], c[1], c[2], c[3]]);
    let high = cubic(y, [c[4], c[5], c[6], c[7]]);
    Real::mul_add(high, y2 * y2, low)
}
