//! Division by x³ with two roundings instead of three.

use crate::functions::{Bits, Number, b, c};

/// The upper 17 of the 53 bits of a significand (and sign and exponent): the cube of such a number is exact.
const HEAD: u64 = !((1 << 36) - 1);

/// (d + rest)/x³, where |rest| is at most an ulp or so of d; 1/2 < x < 1e100.
///
/// x = h (1 + ε) with h the first 17 bits of x, so ε < 2⁻¹⁶ and h³ is exact; (1 + ε)⁻³ = 1 − 3ε + 6ε² − 10ε³ up
/// to 15ε⁴ < 2⁻⁶⁰. Rounded are d/h³ and the last sum; the correction is smaller by 2⁻¹⁴.
#[inline(always)]
pub(crate) fn over_cube<R: Number>(d: R, rest: R, x: R) -> R {
    let head = R::from_bits(x.bits().and(b::<R>(HEAD)));
    let cube = head * head * head;
    let epsilon = (x - head) / head;
    let quotient = d / cube;
    let bend = c::<R>(6.0) - epsilon * c(10.0);
    quotient + (rest / cube - quotient * epsilon * (c::<R>(3.0) - epsilon * bend))
}
