//! ln x, ln (1 + x), log₂ x and log₁₀ x.
//!
//! x = 2ᵏ m with √½ ≤ m < √2, read from the bits, and f = m − 1 is exact. Then
//!
//! - ln x = k ln 2 + f − f²/2 + f³ P(f), with twenty coefficients: a least-squares fit at Chebyshev points in 60 digits, rounded
//!   from the lowest on while the rest is fitted again; relative error 1.9e−18.
//!
//! No table and no division: the polynomial is long, but by Estrin's scheme its terms do not wait for each other, and the same
//! holds for eight numbers. ln 2 = L₁ + L₂ with 42 bits in L₁: k L₁ is exact, the rounding error of k L₁ + f joins the
//! smaller terms. Other bases multiply f by 1/ln b in two parts.
//!
//! ln (1 + x) takes 1 + x as an unrounded sum u + v: f + v/2ᵏ is normalised, and the derivative 1/(1 + f) ≈ 1 − f + f² is enough for
//! what is below the last place of f.

use super::number::{Bits, Number, ROUNDER, b, c, fast_two_sum, power_of_two, sign, turned, two_product};
use crate::polynomial::nineteenth_of;
use crate::{Mask, two_sum};

const LN_2: [f64; 2] = [0.6931471805598903, 5.497923018708371e-14];

const LN: [f64; 20] = [
    0.3333333333333348,
    -0.24999999999998815,
    0.19999999999939733,
    -0.1666666666694259,
    0.14285714294382676,
    -0.12499999979272591,
    0.11111110491004385,
    -0.10000000518881062,
    0.09090934260371762,
    -0.08333341943467656,
    0.07691698308402424,
    -0.07142063107336766,
    0.0667539446546742,
    -0.0626921994517297,
    0.05815298166174756,
    -0.05329129109105801,
    0.05430461727094284,
    -0.06276977659898811,
    0.05660324005350781,
    -0.02394716120524501,
];

/// The bits of √½, rounded up, and what 1 is above it.
const SQRT_HALF: u64 = 0x3fe6_a09e_667f_3bcd;
const TO_ONE: u64 = 0x3ff0_0000_0000_0000 - SQRT_HALF;
const FRACTION: u64 = (1 << 52) - 1;
/// 2⁵² + 1023: a biased exponent in the lowest bits of 2⁵².
const BIASED: f64 = 4503599627370496.0 + 1023.0;
/// 2⁵⁴, which makes subnormal numbers normal.
const UP: f64 = 18014398509481984.0;

/// x = 2ᵏ (1 + f) for positive normal x: (k, f).
#[inline(always)]
fn split<R: Number>(x: R) -> (R, R) {
    let bits = x.bits().plus(b::<R>(TO_ONE));
    let k = R::from_bits(bits.shr(52).or(b::<R>(0x4330_0000_0000_0000))) - c(BIASED);
    let m = R::from_bits(bits.and(b::<R>(FRACTION)).plus(b::<R>(SQRT_HALF)));
    (k, m - R::ONE)
}

/// Positive, normal and finite.
#[inline(always)]
fn ordinary<R: Number>(x: R) -> R::Mask {
    c::<R>(f64::MIN_POSITIVE).less_or_equal(x).and(x.less(c(f64::INFINITY)))
}

/// ln (1 + f) − f = −f²/2 + f³ P(f).
#[inline(always)]
fn beyond_f<R: Number>(f: R) -> R {
    let f2 = f * f;
    nineteenth_of(f, LN, f2 * f, f2 * c(-0.5))
}

/// k ln 2 + ln (1 + f).
#[inline(always)]
fn natural<R: Number>((k, f): (R, R)) -> R {
    let (sum, error) = fast_two_sum(k * c(LN_2[0]), f);
    sum + (beyond_f(f) + k.mul_add(c(LN_2[1]), error))
}

/// A base: log_b 2 and 1/ln b in two parts each, of which the first of log_b 2 has 42 bits.
struct Base {
    of_2: [f64; 2],
    factor: [f64; 2],
}

const BINARY: Base = Base { of_2: [1.0, 0.0], factor: [core::f64::consts::LOG2_E, 2.0355273740931033e-17] };
const DECIMAL: Base = Base {
    of_2: [0.30102999566395283, 2.8363394551044964e-14],
    factor: [core::f64::consts::LOG10_E, 1.098319650216765e-17],
};

/// (k ln 2 + ln (1 + f))/ln b.
#[inline(always)]
fn with_base<R: Number>((k, f): (R, R), base: &Base) -> R {
    let (product, left) = two_product(f, c(base.factor[0]));
    let left = f.mul_add(c(base.factor[1]), left);
    let (sum, error) = fast_two_sum(k * c(base.of_2[0]), product);
    let more = k.mul_add(c(base.of_2[1]), error) + left;
    sum + beyond_f(f).mul_add(c(base.factor[0]), more)
}

/// A logarithm made of k and f, for every x.
#[inline(always)]
fn any<R: Number>(x: R, of: impl Fn((R, R)) -> R) -> R {
    let subnormal = x.less(c(f64::MIN_POSITIVE));
    let (k, f) = split(R::either(subnormal, x * c(UP), x));
    let value = of((R::either(subnormal, k - c(54.0), k), f));
    let value = R::either(x.less(c(f64::INFINITY)), value, x);
    let value = R::either(x.less(R::ZERO), c(f64::NAN), value);
    R::either(x.equal(R::ZERO), c(f64::NEG_INFINITY), value)
}

#[inline]
pub(crate) fn ln<R: Number>(x: R) -> R {
    if ordinary(x).all() { natural(split(x)) } else { any_ln(x) }
}

#[cold]
#[inline(never)]
fn any_ln<R: Number>(x: R) -> R {
    any(x, natural)
}

#[inline]
pub(crate) fn log2<R: Number>(x: R) -> R {
    if ordinary(x).all() { with_base(split(x), &BINARY) } else { any_log2(x) }
}

#[cold]
#[inline(never)]
fn any_log2<R: Number>(x: R) -> R {
    any(x, |parts| with_base(parts, &BINARY))
}

#[inline]
pub(crate) fn log10<R: Number>(x: R) -> R {
    if ordinary(x).all() { with_base(split(x), &DECIMAL) } else { any_log10(x) }
}

#[cold]
#[inline(never)]
fn any_log10<R: Number>(x: R) -> R {
    any(x, |parts| with_base(parts, &DECIMAL))
}

/// ln (u + v) as a sum of two, for a normal, finite u > 0 that is u + v rounded.
#[inline(always)]
pub(super) fn ln_of_sum<R: Number>(u: R, v: R) -> (R, R) {
    let (k, f) = split(u);
    // v/2ᵏ; for the largest k, where 2⁻ᵏ is not normal, v is beyond all digits.
    let scale = power_of_two::<R>((c::<R>(ROUNDER) - k.min(c(1000.0))).bits());
    let (f, below) = fast_two_sum(f, v * scale);
    let (sum, error) = fast_two_sum(k * c(LN_2[0]), f);
    let below = below * f.mul_add(f - R::ONE, R::ONE);
    (sum, beyond_f(f) + (k.mul_add(c(LN_2[1]), error) + below))
}

#[inline]
pub(crate) fn ln_1p<R: Number>(x: R) -> R {
    let (u, v) = two_sum(R::ONE, x);
    let (sum, small) = ln_of_sum(u, v);
    // The zero keeps its sign.
    let value = turned((sum + small).abs(), sign(x));
    let inside = c::<R>(-1.0).less(x).and(x.less(c(f64::INFINITY)));
    if inside.all() { value } else { outside(x, value) }
}

/// ln (1 + x) where 1 + x is not positive or not finite.
#[cold]
#[inline(never)]
fn outside<R: Number>(x: R, value: R) -> R {
    let value = R::either(x.less(c(f64::INFINITY)), value, x);
    let value = R::either(x.less(c(-1.0)), c(f64::NAN), value);
    R::either(x.equal(c(-1.0)), c(f64::NEG_INFINITY), value)
}
