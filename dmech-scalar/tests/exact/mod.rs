//! Numbers with 120 digits, and distances from them in units of the last place.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

/// A binary number with 400 bits.
pub(crate) type Big = FBig<HalfEven, 2>;

const BITS: usize = 400;

/// The very value of x, to be computed with at 400 bits.
pub(crate) fn big(x: f64) -> Big {
    Big::try_from(x).expect("a finite number").with_precision(BITS).value()
}

/// The distance from |x| to the next larger number.
fn ulp(x: f64) -> f64 {
    x.abs().next_up() - x.abs()
}

/// |computed − exact| in units of the last place of `scale`. Where the exact value overflows, ∞ is right.
pub(crate) fn error_in_ulps(computed: f64, exact: &Big, scale: f64) -> f64 {
    if exact.to_f64().value().is_infinite() {
        return if computed == exact.to_f64().value() { 0.0 } else { f64::INFINITY };
    }
    if !computed.is_finite() {
        return f64::INFINITY;
    }
    ((big(computed) - exact) / big(ulp(scale))).to_f64().value().abs()
}
