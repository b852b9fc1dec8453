//! arsinh, arcosh and artanh, each as the logarithm of an unrounded sum.
//!
//! - arsinh a = ln (a + √(a² + 1)),
//! - arcosh x = ln (1 + t + √(t (t + 2))), t = x − 1, which is exact,
//! - artanh a = ln ((1 + a)/(1 − a))/2,
//!
//! where squares, roots and quotients keep what their rounding leaves. Beyond 2⁵⁰⁰ the first two are ln 2a.

use super::logarithmic::ln_of_sum;
use super::number::{Number, c, fast_two_sum, quotient_terms, root_terms, sign, turned, two_product};
use crate::{Mask, two_sum};

/// 2⁵⁰⁰; 1 is long since negligible.
const LARGE: f64 = f64::from_bits((1023 + 500) << 52);
const LN_2: [f64; 2] = [core::f64::consts::LN_2, 2.3190468138462996e-17];

/// ln 2a for large a.
#[inline(always)]
fn ln_of_double<R: Number>(a: R) -> R {
    let (sum, small) = ln_of_sum(a, R::ZERO);
    let (sum, error) = fast_two_sum(sum, c(LN_2[0]));
    sum + (small + (error + c(LN_2[1])))
}

#[inline]
pub(crate) fn asinh<R: Number>(x: R) -> R {
    let a = x.abs();
    let moderate = a.less(c(LARGE));
    let inner = R::either(moderate, a, R::ONE);
    let (square, square_rest) = two_product(inner, inner);
    let (s, error) = two_sum(square, R::ONE);
    let (root, root_rest) = root_terms((s, error + square_rest));
    let (sum, error) = two_sum(inner, root);
    let (u, v) = fast_two_sum(sum, error + root_rest);
    let (sum, small) = ln_of_sum(u, v);
    let value = sum + small;
    let value = if moderate.all() { value } else { far(a, value) };
    turned(value, sign(x))
}

/// Where a is large.
#[cold]
#[inline(never)]
fn far<R: Number>(a: R, value: R) -> R {
    let finite = R::either(a.finite(), a, R::ONE);
    let value = R::either(a.less(c(LARGE)), value, ln_of_double(finite));
    R::either(a.finite(), value, a)
}

#[inline]
pub(crate) fn acosh<R: Number>(x: R) -> R {
    let moderate = x.less(c(LARGE)).and(R::ONE.less_or_equal(x));
    let t = R::either(moderate, x, R::ONE) - R::ONE;
    let (square, square_rest) = two_product(t, t);
    let (s, error) = two_sum(t + t, square);
    let root = R::either(t.equal(R::ZERO), R::ONE, s);
    let (root, root_rest) = root_terms((root, error + square_rest));
    let nothing = t.equal(R::ZERO);
    let (root, root_rest) = (R::either(nothing, R::ZERO, root), R::either(nothing, R::ZERO, root_rest));
    // 1 + t is x.
    let (sum, error) = two_sum(R::ONE + t, root);
    let (u, v) = fast_two_sum(sum, error + root_rest);
    let (sum, small) = ln_of_sum(u, v);
    let value = sum + small;
    if moderate.all() { value } else { R::either(x.less(R::ONE), c(f64::NAN), far(x, value)) }
}

#[inline]
pub(crate) fn atanh<R: Number>(x: R) -> R {
    let a = x.abs();
    let inside = a.less(R::ONE);
    let (quotient, rest) = quotient_terms(fast_two_sum(R::ONE, a), fast_two_sum(R::ONE, -a));
    let (u, v) = fast_two_sum(quotient, rest);
    let (sum, small) = ln_of_sum(u, v);
    // Close to 0 the quotient of two sums that are both nearly 1 has not digits enough.
    let square = a * a;
    let series = a + a * square * square.mul_add(c(0.2), c(1.0 / 3.0));
    let value = R::either(a.less(c(1e-4)), series, (sum + small) * c(0.5));
    let value = if inside.all() {
        value
    } else {
        R::either(inside, value, R::either(a.equal(R::ONE), c(f64::INFINITY), c(f64::NAN)))
    };
    turned(value, sign(x))
}
