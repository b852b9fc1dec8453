//! Division by x³ with two roundings instead of three.

/// The upper 17 of the 53 bits of a significand (and sign and exponent): the cube of such a number is exact.
const HEAD: u64 = !((1 << 36) - 1);

/// (d + rest)/x³, where |rest| is at most an ulp or so of d; 1/2 < x < 1e100.
///
/// x = h (1 + ε) with h the first 17 bits of x, so ε < 2⁻¹⁶ and h³ is exact; (1 + ε)⁻³ = 1 − 3ε + 6ε² − 10ε³ up
/// to 15ε⁴ < 2⁻⁶⁰. Rounded are d/h³ and the last sum; the correction is smaller by 2⁻¹⁴.
#[inline(always)]
pub(crate) fn over_cube(d: f64, rest: f64, x: f64) -> f64 {
    let head = f64::from_bits(x.to_bits() & HEAD);
    let cube = head * head * head;
    let epsilon = (x - head) / head;
    let quotient = d / cube;
    quotient + (rest / cube - quotient * epsilon * (3.0 - epsilon * (6.0 - 10.0 * epsilon)))
}

/// a + b as (sum, rounding error), for |a| ≥ |b| (T. J. Dekker, Numer. Math. 18 (1971) 224–242).
#[inline(always)]
pub(crate) fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}
