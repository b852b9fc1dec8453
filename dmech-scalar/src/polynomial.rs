//! Polynomials with 4 to 20 coefficients, lowest power first, by Estrin's scheme.
//!
//! Horner's rule is one chain of n dependent products and sums. Estrin's scheme pairs the terms,
//! (c₀ + c₁y) + y²(c₂ + c₃y) + …, and waits for three of them at eight coefficients instead of seven;
//! without a fused instruction that halves the time. (G. Estrin, Proc. Western Joint IRE–AIEE–ACM Computer
//! Conference (1960) 33–40.)

use crate::Real;

/// c₀ + c₁ y.
#[inline(always)]
fn linear<R: Real>(y: R, c: [f64; 2]) -> R {
    y.mul_add(R::from_f64(c[1]), R::from_f64(c[0]))
}

/// c₀ + … + c₃ y³, where y² is known.
#[inline(always)]
fn four<R: Real>(y: R, y2: R, c: [f64; 4]) -> R {
    linear(y, [c[2], c[3]]).mul_add(y2, linear(y, [c[0], c[1]]))
}

/// c₀ + … + c₇ y⁷, where y² and y⁴ are known.
#[inline(always)]
fn eight<R: Real>(y: R, y2: R, y4: R, c: [f64; 8]) -> R {
    let [c0, c1, c2, c3, c4, c5, c6, c7] = c;
    four(y, y2, [c4, c5, c6, c7]).mul_add(y4, four(y, y2, [c0, c1, c2, c3]))
}

/// c₀ + c₁ y + c₂ y² + c₃ y³.
#[inline(always)]
pub(crate) fn cubic<R: Real>(y: R, c: [f64; 4]) -> R {
    four(y, y * y, c)
}

/// c₀ + … + c₅ y⁵.
#[inline(always)]
pub(crate) fn quintic<R: Real>(y: R, c: [f64; 6]) -> R {
    let [c0, c1, c2, c3, c4, c5] = c;
    let y2 = y * y;
    four(y, y2, [c2, c3, c4, c5]).mul_add(y2, linear(y, [c0, c1]))
}

/// c₀ + … + c₆ y⁶.
#[inline(always)]
pub(crate) fn sextic<R: Real>(y: R, c: [f64; 7]) -> R {
    let [c0, c1, c2, c3, c4, c5, c6] = c;
    let (y2, y4) = squares(y);
    y2.mul_add(R::from_f64(c6), linear(y, [c4, c5])).mul_add(y4, four(y, y2, [c0, c1, c2, c3]))
}

/// c₀ + … + c₇ y⁷.
#[inline(always)]
pub(crate) fn septic<R: Real>(y: R, c: [f64; 8]) -> R {
    let y2 = y * y;
    eight(y, y2, y2 * y2, c)
}

/// f (c₀ + … + c₄ y⁴).
///
/// This and those below form the product with the lower half of the polynomial while the upper half is still waited for.
/// What is to be added comes after: in a function it is the error of a sum, which is known late.
#[inline(always)]
pub(crate) fn quartic_of<R: Real>(y: R, c: [f64; 5], f: R) -> R {
    let [c0, c1, c2, c3, c4] = c;
    let y2 = y * y;
    let high = y2.mul_add(R::from_f64(c4), linear(y, [c2, c3]));
    (f * y2).mul_add(high, f * linear(y, [c0, c1]))
}

/// f (c₀ + … + c₅ y⁵).
#[inline(always)]
pub(crate) fn quintic_of<R: Real>(y: R, c: [f64; 6], f: R) -> R {
    let [c0, c1, c2, c3, c4, c5] = c;
    let y2 = y * y;
    (f * y2).mul_add(four(y, y2, [c2, c3, c4, c5]), f * linear(y, [c0, c1]))
}

/// f (c₀ + … + c₉ y⁹).
#[inline(always)]
pub(crate) fn nonic_of<R: Real>(y: R, c: [f64; 10], f: R) -> R {
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9] = c;
    let (y2, y4) = squares(y);
    let high = linear(y, [c8, c9]).mul_add(y4, four(y, y2, [c4, c5, c6, c7]));
    (f * y4).mul_add(high, f * four(y, y2, [c0, c1, c2, c3]))
}

/// f (c₀ + … + c₁₀ y¹⁰).
#[inline(always)]
pub(crate) fn tenth_of<R: Real>(y: R, c: [f64; 11], f: R) -> R {
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10] = c;
    let (y2, y4) = squares(y);
    let last = y2.mul_add(R::from_f64(c10), linear(y, [c8, c9]));
    let high = last.mul_add(y4, four(y, y2, [c4, c5, c6, c7]));
    (f * y4).mul_add(high, f * four(y, y2, [c0, c1, c2, c3]))
}

/// f (c₀ + … + c₁₂ y¹²).
#[inline(always)]
pub(crate) fn twelfth_of<R: Real>(y: R, c: [f64; 13], f: R) -> R {
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12] = c;
    let (y2, y4) = squares(y);
    let last = y4.mul_add(R::from_f64(c12), four(y, y2, [c8, c9, c10, c11]));
    let high = last.mul_add(y4, four(y, y2, [c4, c5, c6, c7]));
    (f * y4).mul_add(high, f * four(y, y2, [c0, c1, c2, c3]))
}

/// f (c₀ + … + c₁₉ y¹⁹) + rest.
#[inline(always)]
pub(crate) fn nineteenth_of<R: Real>(y: R, c: [f64; 20], f: R, rest: R) -> R {
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19] = c;
    let (y2, y4) = squares(y);
    let y8 = y4 * y4;
    let last = four(y, y2, [c16, c17, c18, c19]);
    let high = last.mul_add(y8, eight(y, y2, y4, [c8, c9, c10, c11, c12, c13, c14, c15]));
    (f * y8).mul_add(high, f.mul_add(eight(y, y2, y4, [c0, c1, c2, c3, c4, c5, c6, c7]), rest))
}

/// y² and y⁴.
#[inline(always)]
fn squares<R: Real>(y: R) -> (R, R) {
    let y2 = y * y;
    (y2, y2 * y2)
}
