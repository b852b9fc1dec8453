//! f(x)/x for sin, sinh, arctan and artanh, and their slopes.
//!
//! The quotients are as accurate as the functions, which are accurate near 0. The slopes are differences that cancel near
//! 0: there they are summed as series in y = x², to |x| = 3/2 for sinc and sinhc, which loses up to 1 bit beyond, and to
//! |x| = 1/2 for atanc and atanhc, which loses up to 3.

use super::DoubleDouble;
use super::exponential::exp;
use super::hyperbolic::{abs, atanh, sinh};
use super::series::{self, ATANC_SLOPE, SINC_SLOPE};
use super::trigonometric::{atan, sin_cos};

const ONE: DoubleDouble = DoubleDouble::pair(1.0, 0.0);

/// f(x)/x, 1 at 0.
fn quotient(x: DoubleDouble, f: impl FnOnce(DoubleDouble) -> DoubleDouble) -> DoubleDouble {
    if x.hi == 0.0 { ONE } else { f(x) / x }
}

/// sin(x)/x.
pub(super) fn sinc(x: DoubleDouble) -> DoubleDouble {
    quotient(x, |x| sin_cos(x).0)
}

/// (cos x − sinc x)/x².
pub(super) fn sinc_slope(x: DoubleDouble) -> DoubleDouble {
    if x.hi.abs() < 1.5 {
        return -series::sum(&SINC_SLOPE, 11, -(x * x));
    }
    let (sin, cos) = sin_cos(x);
    // Divided twice, because x² overflows before the result vanishes.
    (cos - sin / x) / x / x
}

/// sinh(x)/x.
pub(super) fn sinhc(x: DoubleDouble) -> DoubleDouble {
    // Divided first: sinh overflows before the quotient does.
    if x.hi.abs() > 700.0 { large(x, |a| a) } else { quotient(x, sinh) }
}

/// ((a − 1) eᵃ + (a + 1) e⁻ᵃ)/(2a³) with a = |x|.
pub(super) fn sinhc_slope(x: DoubleDouble) -> DoubleDouble {
    if x.hi.abs() < 1.5 {
        return series::sum(&SINC_SLOPE, 11, x * x);
    }
    let a = abs(x);
    if a.hi > 700.0 {
        return large(x, |a| a * a / (a.plus(-1.0) / a));
    }
    let e = exp(a);
    (a.plus(-1.0) * e + a.plus(1.0) / e).scaled(-1) / (a * a * a)
}

/// eᵃ/2 over a divisor, by way of e^(a/2).
fn large(x: DoubleDouble, divisor: impl FnOnce(DoubleDouble) -> DoubleDouble) -> DoubleDouble {
    let a = abs(x);
    // e⁸⁰⁰ is infinite after any division by a power of 800.
    if a.hi > 800.0 {
        return DoubleDouble::from(f64::INFINITY);
    }
    let root = exp(a.scaled(-1));
    root.scaled(-1) / divisor(a) * root
}

/// arctan(x)/x.
pub(super) fn atanc(x: DoubleDouble) -> DoubleDouble {
    quotient(x, atan)
}

/// (1/(1 + x²) − atanc x)/x².
pub(super) fn atanc_slope(x: DoubleDouble) -> DoubleDouble {
    let a = abs(x);
    if a.hi < 0.5 {
        return -series::sum(&ATANC_SLOPE, 29, -(x * x));
    }
    // Times a², which overflows.
    let over_a = ONE / a;
    (over_a / (a + over_a) - atan(a) * over_a) * over_a * over_a
}

/// artanh(x)/x.
pub(super) fn atanhc(x: DoubleDouble) -> DoubleDouble {
    quotient(x, atanh)
}

/// (1/(1 − x²) − atanhc x)/x².
pub(super) fn atanhc_slope(x: DoubleDouble) -> DoubleDouble {
    if x.hi.abs() < 0.5 {
        return series::sum(&ATANC_SLOPE, 29, x * x);
    }
    let pole = ONE / ((ONE - x) * (ONE + x));
    // At ±1 both terms are infinite.
    if pole.hi == f64::INFINITY {
        return pole;
    }
    (pole - atanhc(x)) / (x * x)
}
