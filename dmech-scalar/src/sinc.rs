//! sinc x = sin(x)/x and its slope sinc′(x)/x.
//!
//! With y = x²,
//!
//! - sinc x = Σ (−1)ⁿ yⁿ/(2n+1)! = 1 − y/6 + y²/120 − …
//! - sinc′(x)/x = Σ (−1)ⁿ⁺¹ (2n+2) yⁿ/(2n+3)! = −1/3 + y/30 − y²/840 + …
//!
//! Near 0 each is a polynomial of degree 7 in y with the exact value at y = 0, passing through the function
//! at the seven Chebyshev points of 0 ≤ y ≤ Y (solved with 60 digits, then rounded). The eighth power is the
//! first one missing; interpolation at these points leaves about y |c₈| Y⁷/2¹³, c₈ its coefficient in the series:
//!
//! | | Y | left out | measured, relative |
//! |---|---|---|---|
//! | sinc | 25/16 | Y⁸/(17! 2¹³) = 1.2e−17 | 1.6e−17 |
//! | slope | 9/4 | 18 Y⁸/(19! 2¹³) = 1.2e−17 | 4.4e−17 |
//!
//! One coefficient less would leave about a hundred ulp. Beyond √Y the closed forms hold. The difference sinc x − cos x
//! loses a factor sinc x/(sinc x − cos x) of 1.1 at x = 3/2, but 2.8 at x = 1 and 33 at x = 0.3, which is why the
//! polynomial of the slope reaches to 3/2.
//!
//! The slope has a zero wherever tan x = x, first at |x| = 4.493. There the two terms cancel, as in any difference: for
//! |x| > 4 the error is a few ulp of the larger term, not of the result.

use crate::functions::{Number, by_range, c};
use crate::polynomial::septic;

const SINC: [f64; 8] = [
    1.0,
    -0.16666666666666666,
    0.008333333333332851,
    -0.00019841269840776478,
    2.755731903444393e-06,
    -2.505207369721675e-08,
    1.6055782815851143e-10,
    -7.494895594805586e-13,
];

const SINC_SLOPE: [f64; 8] = [
    -0.3333333333333333,
    0.033333333333333326,
    -0.0011904761904759655,
    2.2045855377588564e-05,
    -2.505210795846943e-07,
    1.9270798326078095e-09,
    -1.070248407780714e-11,
    4.3832660218676694e-14,
];

/// sin(x)/x.
#[inline]
pub(crate) fn sinc<R: Number>(x: R) -> R {
    by_range(x.abs().less(c(1.25)), || septic(x * x, SINC), || x.sin() / x)
}

/// (cos x − sinc x)/x².
#[inline]
pub(crate) fn sinc_slope<R: Number>(x: R) -> R {
    let far = || {
        // Divided twice, because x² overflows before the result vanishes.
        (x.cos() - x.sin() / x) / x / x
    };
    by_range(x.abs().less(c(1.5)), || septic(x * x, SINC_SLOPE), far)
}
