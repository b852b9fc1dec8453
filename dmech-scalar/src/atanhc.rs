//! atanhc x = artanh(x)/x and its slope atanhc′(x)/x for |x| ≤ 1 (infinite at ±1, NaN beyond).
//!
//! With y = x²,
//!
//! - atanhc x = Σ yⁿ/(2n+1) = 1 + y/3 + y²/5 + …
//! - atanhc′(x)/x = Σ (2n+2) yⁿ/(2n+3) = 2/3 + 4y/5 + 6y²/7 + …
//!
//! Near 0, atanhc is 1 + y P(y)/Q(y), made as that of `atanc` is (and for its reasons). The slope needs more: its
//! quotient must reach to 4/5, and it has a pole at |x| = 1. Taking out the pole, 1/(1−y),
//!
//! - atanhc′(x)/x = 2/3 + y (1/(1−y) − M), M = Σ yⁿ/(2n+5),
//!
//! where M counts for a ninth of the sum at most. In y the coefficients for M alternate and cancel. In w = y/(1−y)
//! = x²/(1−x²) they are positive, because w sends the branch point at y = 1 to infinity and leaves one at w = −1 (as
//! y = −1 for atanc; Pfaff's transformation does the same, Abramowitz and Stegun 15.3.4). M = P(w)/Q(w) again by its
//! value at 0 and at the Chebyshev points.
//!
//! | | degrees | range | error of g, relative | with one degree less |
//! |---|---|---|---|---|
//! | atanhc | 3/3 | 0 ≤ y ≤ 1/16 | 4.7e−18 | 9.1e−16 |
//! | slope | 7/7 | 0 ≤ w ≤ 16/9 | 6.6e−19 | 1.0e−17 |
//!
//! Beyond |x| = 1/4 and 4/5 the closed forms hold, with a = |x| and artanh a = ln(1 + 2a/(1−a))/2, where 2a is exact,
//! and 1 − a too for a ≥ 1/2. That of the slope, (1/(1−a²) − artanh(a)/a)/a², would round the large term three times;
//! the same is 1/(1−a²) − (artanh a − a)/a³. There 1 − a² is formed as d + a d, d = 1 − a.

use crate::cube::over_cube;
use crate::functions::{Number, by_range, c};
use crate::polynomial::{cubic, septic};

const ATANHC_P: [f64; 4] = [0.3333333333333333, -0.40375372644563406, 0.10847423985320365, -0.0012077040007790673];
const ATANHC_Q: [f64; 4] = [1.0, -1.8112611793368993, 0.9836079985870592, -0.15086645274082652];

const M_P: [f64; 8] = [
    0.2,
    0.6419062132580104,
    0.7988806934737991,
    0.4868518608761338,
    0.15105260700755507,
    0.022500963196133497,
    0.0013479593131139177,
    2.029053067196457e-05,
];
const M_Q: [f64; 8] = [
    1.0,
    2.495245352004338,
    2.3708155175245835,
    1.0791702820819429,
    0.24336136355073873,
    0.025393920932133992,
    0.0010040596536441443,
    8.64806802714123e-06,
];

/// artanh a for 1/4 ≤ a ≤ 1.
#[inline(always)]
fn atanh<R: Number>(a: R) -> R {
    ((a + a) / (R::ONE - a)).ln_1p() * c(0.5)
}

/// artanh(x)/x.
#[inline]
pub(crate) fn atanhc<R: Number>(x: R) -> R {
    let a = x.abs();
    let near = || {
        let y = x * x;
        R::ONE + y * (cubic(y, ATANHC_P) / cubic(y, ATANHC_Q))
    };
    by_range(a.less(c(0.25)), near, || atanh(a) / a)
}

/// (1/(1 − x²) − atanhc x)/x².
#[inline]
pub(crate) fn atanhc_slope<R: Number>(x: R) -> R {
    let a = x.abs();
    let d = R::ONE - a;
    let pole = R::ONE / a.mul_add(d, d);
    let near = || {
        let y = x * x;
        let w = y * pole;
        c::<R>(2.0 / 3.0) + y * (pole - septic(w, M_P) / septic(w, M_Q))
    };
    let far = || pole - over_cube(atanh(a) - a, R::ZERO, a);
    let value = by_range(a.less(c(0.8)), near, far);
    R::either(a.equal(R::ONE), c(f64::INFINITY), value)
}
