//! Angles.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4};

use super::DoubleDouble;
use super::power::sqrt;
use super::series::{self, COS, SINC};
use crate::functions::two_product;
use crate::two_sum;

const ONE: DoubleDouble = DoubleDouble::pair(1.0, 0.0);
/// π/4.
const QUARTER: DoubleDouble = DoubleDouble::pair(FRAC_PI_4, 3.061616997868383e-17);

/// π/2 in five parts, 265 bits: beside 29 π/2 there are numbers whose distance from it is no more than 6·10⁻³⁶.
const HALF_PI: [f64; 5] =
    [FRAC_PI_2, 6.123233995736766e-17, -1.4973849048591698e-33, 5.562271104316826e-50, 2.836115989820158e-66];

/// Beyond this there is no more than `f64` can tell.
const FAR: f64 = (1_u64 << 50) as f64;

/// sin and cos of r with |r| ≤ π/4 and a little more.
fn kernels(r: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let y = -(r * r);
    (r * series::sum(&SINC, 9, y), series::sum(&COS, 9, y))
}

/// x − k π/2.
fn reduced(x: DoubleDouble, k: f64) -> DoubleDouble {
    let multiples = HALF_PI.map(|part| two_product(-k, part));
    let r = multiples[..3].iter().fold(x, |r, &(hi, lo)| r + DoubleDouble::pair(hi, lo));
    // The first difference has two parts or three. Where the second takes away more than 31 digits of it, three count.
    if r.hi.abs() > k.abs() * 1e-15 {
        return r;
    }
    let [(a, b), (c, d), (e, f), (g, h), (last, _)] = multiples;
    let mut terms = [last, h, g, f, e, d, c, b, x.lo, a, x.hi];
    // Each pass leaves the rounding of the sum so far behind (T. Ogita, S. M. Rump and S. Oishi, SIAM J. Sci. Comput. 26
    // (2005) 1955–1988, algorithm SumK); three make the sum as good as one with four times the digits.
    for _ in 0..3 {
        for i in 1..terms.len() {
            (terms[i], terms[i - 1]) = two_sum(terms[i], terms[i - 1]);
        }
    }
    terms.iter().fold(DoubleDouble::pair(0.0, 0.0), |sum, &x| sum.plus(x))
}

/// sin x and cos x.
pub(super) fn sin_cos(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    if x.hi.is_nan() || x.hi.abs() > FAR {
        return (DoubleDouble::from(x.hi.sin()), DoubleDouble::from(x.hi.cos()));
    }
    if x.hi == 0.0 {
        return (x, ONE);
    }
    let k = (x.hi * FRAC_2_PI).round();
    let (sin, cos) = kernels(if k == 0.0 { x } else { reduced(x, k) });
    match (k as i64).rem_euclid(4) {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// tan x.
pub(super) fn tan(x: DoubleDouble) -> DoubleDouble {
    let (sin, cos) = sin_cos(x);
    sin / cos
}

/// The angle of the point (x, y): from the angle θ in `f64`, θ + (y cos θ − x sin θ)/√(x² + y²).
pub(super) fn atan2(y: DoubleDouble, x: DoubleDouble) -> DoubleDouble {
    let angle = y.hi.atan2(x.hi);
    if x.hi == 0.0 || y.hi == 0.0 || !(x.hi.is_finite() && y.hi.is_finite()) {
        // A multiple of π/4, or NaN.
        let eighths = (angle / FRAC_PI_4).round();
        return if eighths == 0.0 || angle.is_nan() { DoubleDouble::from(angle) } else { QUARTER.times(eighths) };
    }
    let exponent = |x: f64| (x.to_bits() >> 52 & 0x7ff) as i32 - 1023;
    let k = -exponent(x.hi).max(exponent(y.hi));
    let (x, y) = (x.scaled(k), y.scaled(k));
    let (sin, cos) = sin_cos(DoubleDouble::from(angle));
    ((y * cos - x * sin) / sqrt(x * x + y * y)).plus(angle)
}

/// arctan x.
pub(super) fn atan(x: DoubleDouble) -> DoubleDouble {
    atan2(x, ONE)
}

/// √(1 − x²).
fn complement(x: DoubleDouble) -> DoubleDouble {
    sqrt((ONE - x) * (ONE + x))
}

/// arcsin x.
pub(super) fn asin(x: DoubleDouble) -> DoubleDouble {
    atan2(x, complement(x))
}

/// arccos x.
pub(super) fn acos(x: DoubleDouble) -> DoubleDouble {
    atan2(complement(x), x)
}
