//! eˣ, 2ˣ and eˣ − 1.
//!
//! x = k ln 2 + r with the nearest integer k, |r| ≤ ln 2/2, in two parts: ln 2 = L₁ + L₂, where L₁ has 42 bits, so that k L₁ and
//! x − k L₁ are exact; the rounding error of the second difference is kept. Then
//!
//! - eʳ = 1 + r + r² Q(r), with eleven coefficients: a least-squares fit at Chebyshev points in 60 digits, rounded from
//!   the lowest on while the rest is fitted again; error 8e−20. (One less would do for eˣ, not for eˣ − 1 where it is small.) For 2ʳ,
//!   |r| ≤ 1/2, the same with ln 2 r and ten coefficients of its own; error 4.4e−18.
//!
//! 1 + r is rounded, and its error joins the smaller terms, so that hardly more than the last rounding remains. The factor 2ᵏ
//! is exact. Where it is no normal number, or the result is not, it is applied in two halves. For eˣ − 1 the sum
//! 2ᵏ − 1 + 2ᵏ r is formed instead, in this order.

use super::number::{Bits, Number, c, fast_two_sum, nearest_integer, power_of_two, sign, turned, two_product};
use crate::polynomial::{nonic_of, tenth_of};
use crate::{Mask, two_sum};

const LN_2: [f64; 2] = [0.6931471805598903, 5.497923018708371e-14];

/// Below this |x| all that is multiplied with the power of two stays normal and finite, so that the product may be taken
/// before the sum or after it.
pub(super) const MODERATE: f64 = 660.0;

const EXP: [f64; 11] = [
    0.5,
    0.16666666666666685,
    0.041666666666666526,
    0.008333333333315969,
    0.0013888888888968043,
    0.00019841269898620266,
    2.4801587155237098e-05,
    2.7557232902697543e-06,
    2.755741758743475e-07,
    2.5112649881903777e-08,
    2.0871151225785464e-09,
];

const EXP2: [f64; 10] = [
    0.24022650695910133,
    0.055504108664820966,
    0.009618129107593413,
    0.0013333558146617292,
    0.00015403530457946382,
    1.5252733616936431e-05,
    1.3215434882408159e-06,
    1.0178155021851589e-07,
    7.0738503888348936e-09,
    4.440764967356689e-10,
];

/// x = k ln 2 + first − second: `first` is exact, `second` is k L₂.
#[inline(always)]
fn reduced<R: Number>(x: R) -> (R, R::Bits, R, R) {
    let (k, k_bits) = nearest_integer(x, core::f64::consts::LOG2_E);
    (k, k_bits, k.mul_add(c(-LN_2[0]), x), k * c(LN_2[1]))
}

/// e^(first − second) as a sum of two. The polynomial does not wait for the difference: with s = `second` < 6e−11,
/// e^(−s) = 1 − s to 2e−21.
#[inline(always)]
fn inner_exp<R: Number>(first: R, second: R) -> (R, R) {
    let (sum, error) = fast_two_sum(R::ONE, first);
    let factor = first * first * (R::ONE - second);
    (sum, tenth_of(first, EXP, factor) + second.mul_add(-sum, error))
}

/// k and what is left: x = k ln 2 + r + rest.
#[derive(Clone, Copy)]
pub(super) struct Parts<R: Number> {
    pub(super) k: R,
    pub(super) k_bits: R::Bits,
    pub(super) r: R,
    pub(super) rest: R,
}

#[inline(always)]
pub(super) fn parts<R: Number>(x: R) -> Parts<R> {
    let (k, k_bits, first, second) = reduced(x);
    let r = first - second;
    Parts { k, k_bits, r, rest: (first - r) - second }
}

impl<R: Number> Parts<R> {
    /// eˣ − 1 as a sum of two, where 2ᵏ is normal.
    #[inline(always)]
    pub(super) fn less_one(self) -> (R, R) {
        let Self { k_bits, r, rest, .. } = self;
        let power = power_of_two::<R>(k_bits);
        let (without, error) = two_sum(power, -R::ONE);
        let (sum, next) = fast_two_sum(without, power * r);
        let small = tenth_of(r, EXP, r * r) + rest.mul_add(r, rest);
        (sum, power.mul_add(small, next + error))
    }
}

/// (large + small) 2ᵏ, where the power and the result are normal.
#[inline(always)]
fn scaled<R: Number>((large, small): (R, R), k_bits: R::Bits) -> R {
    let power = power_of_two::<R>(k_bits);
    small.mul_add(power, large * power)
}

/// (large + small) 2ᵏ for |k| < 1100: 0 and ∞ too.
#[inline(always)]
fn scaled_twice<R: Number>((large, small): (R, R), k: R, k_bits: R::Bits) -> R {
    let (_, half) = nearest_integer(k, 0.5);
    (large + small) * power_of_two(half) * power_of_two(k_bits.minus(half))
}

/// x between two bounds; NaN stays.
#[inline(always)]
fn between<R: Number>(x: R, low: f64, high: f64) -> R {
    let x = R::either(x.less(c(low)), c(low), x);
    R::either(c::<R>(high).less(x), c(high), x)
}

#[inline]
pub(crate) fn exp<R: Number>(x: R) -> R {
    if x.abs().less(c(MODERATE)).all() {
        let (_, k_bits, first, second) = reduced(x);
        scaled(inner_exp(first, second), k_bits)
    } else {
        any_exp(x)
    }
}

#[cold]
#[inline(never)]
fn any_exp<R: Number>(x: R) -> R {
    let (k, k_bits, first, second) = reduced(between(x, -746.0, 710.0));
    scaled_twice(inner_exp(first, second), k, k_bits)
}

/// e^(large + small), where |large| < [`MODERATE`] and `small` is below its last place or little more.
#[inline(always)]
pub(super) fn exp_of_sum<R: Number>(large: R, small: R) -> R {
    let (_, k_bits, first, second) = reduced(large);
    scaled(inner_exp(first, second - small), k_bits)
}

/// The same for any `large`.
#[inline(always)]
pub(super) fn exp_of_sum_anywhere<R: Number>(large: R, small: R) -> R {
    let (k, k_bits, first, second) = reduced(between(large, -746.0, 710.0));
    let small = R::either(large.abs().less(c(746.0)), small, R::ZERO);
    scaled_twice(inner_exp(first, second - small), k, k_bits)
}

/// 2ʳ as a sum of two.
#[inline(always)]
fn inner_exp2<R: Number>(r: R) -> (R, R) {
    let (linear, left) = two_product(r, c(core::f64::consts::LN_2));
    let (sum, error) = fast_two_sum(R::ONE, linear);
    (sum, nonic_of(r, EXP2, r * r) + (r.mul_add(c(2.3190468138462996e-17), left) + error))
}

#[inline]
pub(crate) fn exp2<R: Number>(x: R) -> R {
    if x.abs().less(c(950.0)).all() {
        let (k, k_bits) = nearest_integer(x, 1.0);
        scaled(inner_exp2(x - k), k_bits)
    } else {
        any_exp2(x)
    }
}

#[cold]
#[inline(never)]
fn any_exp2<R: Number>(x: R) -> R {
    let x = between(x, -1077.0, 1025.0);
    let (k, k_bits) = nearest_integer(x, 1.0);
    scaled_twice(inner_exp2(x - k), k, k_bits)
}

#[inline]
pub(crate) fn exp_m1<R: Number>(x: R) -> R {
    // eˣ is less than a quarter of the last place of 1 below −50.
    let (large, small) = parts(R::either(x.less(c(-50.0)), c(-50.0), x)).less_one();
    // The zero keeps its sign.
    let value = turned((large + small).abs(), sign(x));
    let overflow = x.less(c(MODERATE));
    if overflow.all() { value } else { R::either(overflow, value, exp(x)) }
}
