//! Hyperbolic functions and their inverses.

use super::DoubleDouble;
use super::exponential::{LN_2, exp, exp_m1, ln, ln_1p};
use super::power::sqrt;

const ONE: DoubleDouble = DoubleDouble::pair(1.0, 0.0);

/// Here e⁻ˣ is long since negligible beside eˣ, and eˣ still finite.
const LARGE: f64 = 700.0;

/// f(|x|) with the sign of x, for odd functions.
pub(super) fn odd(x: DoubleDouble, f: impl FnOnce(DoubleDouble) -> DoubleDouble) -> DoubleDouble {
    if x.hi.is_sign_negative() { -f(-x) } else { f(x) }
}

/// |x|.
pub(super) fn abs(x: DoubleDouble) -> DoubleDouble {
    if x.hi.is_sign_negative() { -x } else { x }
}

/// sinh x = (m + m/(1 + m))/2 with m = eˣ − 1.
pub(super) fn sinh(x: DoubleDouble) -> DoubleDouble {
    odd(x, |x| {
        if x.hi > LARGE {
            return half_exp(x);
        }
        let m = exp_m1(x);
        (m + m / m.plus(1.0)).scaled(-1)
    })
}

/// cosh x.
pub(super) fn cosh(x: DoubleDouble) -> DoubleDouble {
    let x = abs(x);
    if x.hi > LARGE {
        return half_exp(x);
    }
    let e = exp(x);
    (e + ONE / e).scaled(-1)
}

/// eˣ/2, which is finite for a while after eˣ is not.
fn half_exp(x: DoubleDouble) -> DoubleDouble {
    let root = exp(x.scaled(-1));
    root.scaled(-1) * root
}

/// tanh x = m/(m + 2) with m = e²ˣ − 1.
pub(super) fn tanh(x: DoubleDouble) -> DoubleDouble {
    odd(x, |x| {
        if x.hi > 40.0 {
            return ONE;
        }
        let m = exp_m1(x.scaled(1));
        m / m.plus(2.0)
    })
}

/// arsinh x = ln (1 + x + x²/(1 + √(1 + x²))).
pub(super) fn asinh(x: DoubleDouble) -> DoubleDouble {
    odd(x, |x| {
        if x.hi > 1e20 {
            return ln(x) + LN_2;
        }
        let square = x * x;
        ln_1p(x + square / sqrt(square.plus(1.0)).plus(1.0))
    })
}

/// arcosh x = ln (1 + t + √t √(t + 2)) with t = x − 1.
pub(super) fn acosh(x: DoubleDouble) -> DoubleDouble {
    if x.hi > 1e20 {
        return ln(x) + LN_2;
    }
    let t = x.plus(-1.0);
    ln_1p(t + sqrt(t) * sqrt(t.plus(2.0)))
}

/// artanh x = ln (1 + 2x/(1 − x))/2.
pub(super) fn atanh(x: DoubleDouble) -> DoubleDouble {
    odd(x, |x| ln_1p(x.scaled(1) / (ONE - x)).scaled(-1))
}
