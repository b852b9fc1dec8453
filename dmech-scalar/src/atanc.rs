//! atanc x = arctan(x)/x and its slope atanc′(x)/x.
//!
//! With y = x²,
//!
//! - atanc x = Σ (−1)ⁿ yⁿ/(2n+1) = 1 − y/3 + y²/5 − …
//! - atanc′(x)/x = Σ (−1)ⁿ⁺¹ (2n+2) yⁿ/(2n+3) = −2/3 + 4y/5 − 6y²/7 + …
//!
//! The series end at |x| = 1, where they no longer converge (branch point and pole at y = −1), and a polynomial
//! needs ten terms even at x = 1/4. A quotient has no such trouble. Near 0 the functions are g(0) + y P(y)/Q(y), where
//! P/Q is (g − g(0))/y at y = 0 and at the n + m Chebyshev points of 0 ≤ y ≤ Y (degrees n and m, solved with 60
//! digits, then rounded). The coefficients of P have one sign (but for a negligible last one) and so have those of
//! Q: nothing cancels, and g(0) beside the quotient leaves little of the quotient's rounding.
//!
//! | | degrees | Y | error of g, relative | with one degree less |
//! |---|---|---|---|---|
//! | atanc | 3/3 | 1/16 | 2.4e−18 | 5.1e−16 |
//! | slope | 5/5 | 1/2 | 1.2e−18 | 3.8e−17 |
//!
//! Beyond |x| = 1/4 atanc is arctan(x)/x. Beyond 7/10 the slope is −D/x³ with D = arctan x − x/(1+x²), a difference that
//! loses a factor 3 at x = 1 and 7 at x = 1/2. With z = (x−1)/(x+1), arctan x = π/4 + arctan z and
//! x/(1+x²) = (1 − z²)/(1 + z²)/2, so
//!
//! - D = (π/4 − 1/2) + arctan z + z²/(1+z²),
//!
//! where nothing cancels for x ≥ 1, and little from 7/10 on.

use crate::cube::over_cube;
use crate::functions::{Number, by_range, c, fast_two_sum};
use crate::polynomial::{cubic, quintic};
use core::f64::consts::FRAC_PI_2;

const ATANC_P: [f64; 4] = [-0.3333333333333333, -0.39641780056882464, -0.10353788098963236, -0.0010720178108166774];
const ATANC_Q: [f64; 4] = [1.0, 1.7892534017064716, 0.955594255424051, 0.14308305306545205];

const SLOPE_P: [f64; 6] =
    [0.8, 1.515017985621731, 0.9727305842463743, 0.24380667139181914, 0.019270796536125134, -3.265177660855645e-06];
const SLOPE_Q: [f64; 6] =
    [1.0, 2.965201053455735, 3.281803247899415, 1.6626719040379239, 0.37477512312572403, 0.02873017538829839];

/// π/4 − 1/2, rounded, and what the rounding leaves.
const AT_ONE: [f64; 2] = [0.28539816339744833, -2.4894981252573997e-17];

/// arctan(x)/x.
#[inline]
pub(crate) fn atanc<R: Number>(x: R) -> R {
    let near = || {
        let y = x * x;
        R::ONE + y * (cubic(y, ATANC_P) / cubic(y, ATANC_Q))
    };
    by_range(x.abs().less(c(0.25)), near, || x.atan() / x)
}

/// (1/(1 + x²) − atanc x)/x².
#[inline]
pub(crate) fn atanc_slope<R: Number>(x: R) -> R {
    let a = x.abs();
    let near = || {
        let y = x * x;
        c::<R>(-2.0 / 3.0) + y * (quintic(y, SLOPE_P) / quintic(y, SLOPE_Q))
    };
    let far = || {
        let z = (a - R::ONE) / (a + R::ONE);
        let z2 = z * z;
        let part = z.atan() + z2 / (R::ONE + z2);
        let (sum, rest) = fast_two_sum(part.max(c(AT_ONE[0])), part.min(c(AT_ONE[0])));
        over_cube(-sum, -(rest + c(AT_ONE[1])), a)
    };
    // D = π/2; one division at a time, because a³ overflows before the result vanishes.
    let farther = || c::<R>(-FRAC_PI_2) / a / a / a;
    by_range(a.less(c(0.7)), near, || by_range(a.less_or_equal(c(1e100)), far, farther))
}
