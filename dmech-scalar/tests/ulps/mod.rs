//! Distances in units of the last place.

use crate::exact::{Big, big};

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
