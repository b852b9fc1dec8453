//! sinhc x = sinh(x)/x and its slope sinhc′(x)/x.
//!
//! With y = x²,
//!
//! - sinhc x = Σ yⁿ/(2n+1)! = 1 + y/6 + y²/120 + …
//! - sinhc′(x)/x = Σ (2n+2) yⁿ/(2n+3)! = 1/3 + y/30 + y²/840 + …
//!
//! For |x| < 5/4 each is a polynomial of degree 7 in y, made as those of `sinc` are: Y = 25/16, relative error
//! 9.7e−18 and 1.7e−18 before the coefficients are rounded. Beyond, with a = |x| and e = eᵃ,
//!
//! - sinhc x = (e − 1/e)/(2a)
//! - sinhc′(x)/x = ((a−1) e + (a+1)/e)/(2a³), a sum of two positive terms for a > 1, so that nothing cancels
//!   (cosh a − sinhc a would cost up to 3 ulp more, and a second exponential).
//!
//! eᵃ overflows at a = 709.8, the functions themselves only at 717.1 and 723.6: above 700 the
//! exponential is taken as e^(a−44) e⁴⁴.

use crate::cube::over_cube;
use crate::functions::{Number, by_range, c, fast_two_sum};
use crate::polynomial::septic;

const SINHC: [f64; 8] = [
    1.0,
    0.16666666666666669,
    0.008333333333332835,
    0.00019841269841778947,
    2.7557319028582024e-06,
    2.505214408660103e-08,
    1.6055697751085808e-10,
    7.802417351836048e-13,
];

const SINHC_SLOPE: [f64; 8] = [
    0.3333333333333333,
    0.03333333333333333,
    0.0011904761904761643,
    2.204585537945626e-05,
    2.505210828274656e-07,
    1.9270871368538213e-09,
    1.0704270286034659e-11,
    4.579968359034862e-14,
];

/// Here eᵃ is still finite, and e⁻ᵃ is long since negligible.
const LARGE: f64 = 700.0;
/// Both functions are infinite here, e^(a−44) is not.
const OVERFLOWN: f64 = 730.0;
/// e⁴⁴, which happens to lie within 1e−18 of it, relatively.
const E44: f64 = 1.2851600114359308e19;

/// sinh(x)/x.
#[inline]
pub(crate) fn sinhc<R: Number>(x: R) -> R {
    let far = || {
        let Power { a, e, factor } = Power::of(x);
        (e - e.recip()) / (a + a) * factor
    };
    by_range(x.abs().less(c(1.25)), || septic(x * x, SINHC), far)
}

/// (cosh x − sinhc x)/x².
#[inline]
pub(crate) fn sinhc_slope<R: Number>(x: R) -> R {
    let far = || {
        let Power { a, e, factor } = Power::of(x);
        let (sum, rest) = fast_two_sum((a - R::ONE) * e, (a + R::ONE) / e);
        over_cube(sum * c(0.5), rest * c(0.5), a) * factor
    };
    by_range(x.abs().less(c(1.25)), || septic(x * x, SINHC_SLOPE), far)
}

/// eᵃ = e · factor, with a = |x| or a number where the functions are infinite.
struct Power<R> {
    a: R,
    e: R,
    factor: R,
}

impl<R: Number> Power<R> {
    #[inline(always)]
    fn of(x: R) -> Self {
        let a = x.abs();
        let a = R::either(c::<R>(OVERFLOWN).less(a), c(OVERFLOWN), a);
        let large = c::<R>(LARGE).less(a);
        // The power of a large a is divided by e⁴⁴; its inverse is then wrong, but beyond all digits.
        Self { a, e: R::either(large, a - c(44.0), a).exp(), factor: R::either(large, c(E44), R::ONE) }
    }
}
