//! Exponentials and logarithms.

use core::f64::consts::LOG2_E;

use super::DoubleDouble;
use super::series::{self, EXP_M1};

const ONE: DoubleDouble = DoubleDouble::pair(1.0, 0.0);
pub(super) const LN_2: DoubleDouble = DoubleDouble::pair(core::f64::consts::LN_2, 2.3190468138462996e-17);
const LN_10: DoubleDouble = DoubleDouble::pair(core::f64::consts::LN_10, -2.1707562233822494e-16);

/// ln 2 in 42, 42 and 53 bits: integers of 11 bits times the first two are exact.
const LN_2_PARTS: [f64; 3] = [0.6931471805598903, 5.49792301870721e-14, 1.1612227229362532e-26];

/// Here eˣ overflows, and for −x it is 0.
const OVERFLOW: f64 = 746.0;

/// eʳ − 1 for |r| ≤ ln(2)/2 and a little more.
fn near_zero(r: DoubleDouble) -> DoubleDouble {
    r * series::sum(&EXP_M1, 14, r)
}

/// k and r with x = k ln 2 + r, |r| ≤ ln(2)/2.
fn reduced(x: DoubleDouble) -> (i32, DoubleDouble) {
    let k = (x.hi * LOG2_E).round();
    let [a, b, c] = LN_2_PARTS;
    (k as i32, x.plus(-k * a).plus(-k * b).plus(-k * c))
}

/// eˣ = 2ᵏ (1 + (eʳ − 1)).
pub(super) fn exp(x: DoubleDouble) -> DoubleDouble {
    if x.hi.is_nan() || x.hi.abs() > OVERFLOW {
        return DoubleDouble::from(x.hi.exp());
    }
    let (k, r) = reduced(x);
    near_zero(r).plus(1.0).scaled(k)
}

/// 2ˣ.
pub(super) fn exp2(x: DoubleDouble) -> DoubleDouble {
    if x.hi.is_nan() || x.hi.abs() > 1100.0 {
        return DoubleDouble::from(x.hi.exp2());
    }
    let k = x.hi.round();
    near_zero(x.plus(-k) * LN_2).plus(1.0).scaled(k as i32)
}

/// eˣ − 1 = 2ᵏ (eʳ − 1) + (2ᵏ − 1): for k = ±1, where the terms have different signs, they are far from equal.
pub(super) fn exp_m1(x: DoubleDouble) -> DoubleDouble {
    if x.hi.abs() < 0.34 {
        return if x.hi == 0.0 { x } else { near_zero(x) };
    }
    if x.hi.is_nan() || x.hi.abs() > 80.0 {
        return exp(x).plus(-1.0);
    }
    let (k, r) = reduced(x);
    near_zero(r).scaled(k) + ONE.scaled(k).plus(-1.0)
}

/// ln (1 + t) for −0.3 < t < 0.42: from the logarithm y in `f64`, with r = (1 + t)/eʸ − 1, y + r − r²/2.
fn near_one(t: DoubleDouble) -> DoubleDouble {
    let y = t.hi.ln_1p();
    if y == 0.0 {
        return t;
    }
    let e = near_zero(DoubleDouble::from(y));
    let r = (t - e) / e.plus(1.0);
    r.plus(-0.5 * r.hi * r.hi).plus(y)
}

/// k and ln m with x = 2ᵏ m, √½ ≤ m ≤ √2; only for positive finite numbers.
fn parts(x: DoubleDouble) -> (f64, DoubleDouble) {
    if x.hi < f64::MIN_POSITIVE {
        let (k, ln) = parts(x.scaled(200));
        return (k - 200.0, ln);
    }
    let mut k = (x.hi.to_bits() >> 52) as i32 - 1023;
    if x.scaled(-k).hi > core::f64::consts::SQRT_2 {
        k += 1;
    }
    (k.into(), near_one(x.scaled(-k).plus(-1.0)))
}

fn positive_finite(x: DoubleDouble) -> bool {
    x.hi > 0.0 && x.hi.is_finite()
}

/// ln x = k ln 2 + ln m.
pub(super) fn ln(x: DoubleDouble) -> DoubleDouble {
    if !positive_finite(x) {
        return DoubleDouble::from(x.hi.ln());
    }
    let (k, ln) = parts(x);
    if k == 0.0 { ln } else { LN_2.times(k) + ln }
}

/// ln (1 + x).
pub(super) fn ln_1p(x: DoubleDouble) -> DoubleDouble {
    if x.hi > -0.29 && x.hi < 0.41 { near_one(x) } else { ln(x.plus(1.0)) }
}

/// log₂ x; exact for powers of 2.
pub(super) fn log2(x: DoubleDouble) -> DoubleDouble {
    if !positive_finite(x) {
        return DoubleDouble::from(x.hi.log2());
    }
    let (k, ln) = parts(x);
    (ln / LN_2).plus(k)
}

/// log₁₀ x.
pub(super) fn log10(x: DoubleDouble) -> DoubleDouble {
    ln(x) / LN_10
}
