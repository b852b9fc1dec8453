//! sinh, cosh and tanh.
//!
//! sinh and cosh are half of eᵃ ∓ e⁻ᵃ, a = |x| = k ln 2 + r as in [`exponential`](super::exponential), both powers
//! from one pair of even polynomials, z = r²:
//!
//! - e^±r = 1 + z C(z) ± (r + r z S(z)), S with five coefficients and C with six, least-squares fits at Chebyshev points in 60 digits;
//!   relative errors 2.7e−19 and 8.5e−22.
//!
//! With A = 2^(k−1) and B = 2^(−k−1) this gives sinh a = (A − B) + (A + B) r + …, the large terms summed with their errors. There is no
//! division, and sinh keeps all digits for small x, where A = B.
//!
//! tanh a = E/(E + 2) with E = e²ᵃ − 1 as an unrounded sum; the quotient is corrected by its remainder.

use super::exponential::{Parts, parts};
use super::number::{Bits, Number, ROUNDER, b, c, fast_two_sum, power_of_two, quotient, sign, turned};
use crate::polynomial::{quartic_of, quintic_of};
use crate::two_sum;

const SINH: [f64; 5] =
    [0.16666666666666677, 0.008333333333321428, 0.00019841269886631242, 2.7557243702649166e-06, 2.510921428216453e-08];

const COSH: [f64; 6] = [
    0.5,
    0.041666666666666685,
    0.0013888888888873296,
    2.4801587349152193e-05,
    2.7557251880530763e-07,
    2.0921746128555634e-09,
];

/// sinh and cosh are infinite here, 2ᵏ⁻² is not.
const OVERFLOWN: f64 = 710.6;
/// tanh is 1 from here on.
const FLAT: f64 = 22.0;

/// (eᵃ ∓ e⁻ᵃ)/2.
#[inline(always)]
fn half_of_both<R: Number>(x: R, minus: bool) -> R {
    let a = x.abs();
    let Parts { k, k_bits, r, rest } = parts(R::either(c::<R>(OVERFLOWN).less(a), c(OVERFLOWN), a));
    let z = r * r;
    let even = quintic_of(z, COSH, z);
    let odd = quartic_of(z, SINH, r * z) + rest;
    // Half of A and B, so that A is finite; of e⁻ᵃ any small number will do when a is large.
    let up = power_of_two::<R>(k_bits.minus(b::<R>(2)));
    let down = power_of_two::<R>((c::<R>(ROUNDER - 2.0) - k.min(c(100.0))).bits());
    let (growing, growing_error) = fast_two_sum(up, up * r);
    let (falling, falling_error) = fast_two_sum(down, -(down * r));
    let (growing_small, falling_small) =
        (up.mul_add(even + odd, growing_error), down.mul_add(even - odd, falling_error));
    let (sum, error) = if minus { two_sum(growing, -falling) } else { two_sum(growing, falling) };
    let small = if minus { growing_small - falling_small } else { growing_small + falling_small };
    let half = sum + (small + error);
    half + half
}

#[inline]
pub(crate) fn sinh<R: Number>(x: R) -> R {
    let a = x.abs();
    // Quarters of subnormal numbers would be rounded.
    let value = R::either(a.less(c(1e-9)), a, half_of_both(x, true));
    turned(value, sign(x))
}

#[inline]
pub(crate) fn cosh<R: Number>(x: R) -> R {
    half_of_both(x, false)
}

#[inline]
pub(crate) fn tanh<R: Number>(x: R) -> R {
    let a = x.abs();
    let a = R::either(c::<R>(FLAT).less(a), c(FLAT), a);
    let (large, small) = parts(a + a).less_one();
    let (p, p_rest) = fast_two_sum(large, small);
    let (q, q_rest) = two_sum(p, c(2.0));
    turned(quotient((p, p_rest), (q, q_rest + p_rest)), sign(x))
}
