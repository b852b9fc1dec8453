//! Power series with coefficients of 31 digits.

use super::DoubleDouble;
use super::arithmetic::{fast_two_sum, split_product};

/// Σ cₙ yⁿ. From n = `double` on the terms are so small that `f64` is enough for them.
pub(super) fn sum<const N: usize>(coefficients: &[DoubleDouble; N], double: usize, y: DoubleDouble) -> DoubleDouble {
    let mut tail = 0.0;
    for c in coefficients[double..].iter().rev() {
        tail = tail * y.hi + c.hi;
    }
    let mut sum = DoubleDouble::pair(tail, 0.0);
    for &c in coefficients[..double].iter().rev() {
        sum = sum * y + c;
    }
    sum
}

/// 1/(n + 1)!: (eʸ − 1)/y. With |y| ≤ 0.36 the first term left out is below 2⁻¹¹⁰ of the sum.
pub(super) const EXP_M1: [DoubleDouble; 24] = inverse_factorials(1, 1);
/// 1/(2n)!: cosh √y, and cos √−y. Enough for |y| ≤ π²/16.
pub(super) const COS: [DoubleDouble; 16] = inverse_factorials(0, 2);
/// 1/(2n + 1)!: sinhc √y, and sinc √−y. Enough for |y| ≤ π²/16.
pub(super) const SINC: [DoubleDouble; 16] = inverse_factorials(1, 2);
/// (2n + 2)/(2n + 3)!: the slope of sinhc √y, and minus that of sinc √−y. Enough for |y| ≤ 9/4.
pub(super) const SINC_SLOPE: [DoubleDouble; 18] = {
    let mut coefficients = inverse_factorials(3, 2);
    let mut n = 0;
    while n < coefficients.len() {
        coefficients[n] = times(coefficients[n], (2 * n + 2) as f64);
        n += 1;
    }
    coefficients
};
/// (2n + 2)/(2n + 3): the slope of atanhc √y, and minus that of atanc √−y. Enough for |y| ≤ 1/4.
pub(super) const ATANC_SLOPE: [DoubleDouble; 55] = {
    let mut coefficients = [DoubleDouble::pair(0.0, 0.0); 55];
    let mut n = 0;
    while n < coefficients.len() {
        coefficients[n] = over(DoubleDouble::pair((2 * n + 2) as f64, 0.0), (2 * n + 3) as f64);
        n += 1;
    }
    coefficients
};

/// 1/k! for k = first, first + step, …
const fn inverse_factorials<const N: usize>(first: usize, step: usize) -> [DoubleDouble; N] {
    let mut coefficients = [DoubleDouble::pair(1.0, 0.0); N];
    let mut n = 0;
    while n < N {
        let mut k = 2;
        while k <= first + n * step {
            coefficients[n] = over(coefficients[n], k as f64);
            k += 1;
        }
        n += 1;
    }
    coefficients
}

/// x b, when the program is compiled.
const fn times(x: DoubleDouble, b: f64) -> DoubleDouble {
    let (product, error) = split_product(x.hi, b);
    let (hi, lo) = fast_two_sum(product, x.lo * b + error);
    DoubleDouble::pair(hi, lo)
}

/// x/b, when the program is compiled.
const fn over(x: DoubleDouble, b: f64) -> DoubleDouble {
    let quotient = x.hi / b;
    let (covered, error) = split_product(quotient, b);
    let (hi, lo) = fast_two_sum(quotient, (((x.hi - covered) - error) + x.lo) / b);
    DoubleDouble::pair(hi, lo)
}
