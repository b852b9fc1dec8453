//! Roots and powers.

use super::DoubleDouble;
use crate::functions::two_product;

const ONE: DoubleDouble = DoubleDouble::pair(1.0, 0.0);

/// √x: one step of Newton's from the root in `f64`.
pub(super) fn sqrt(x: DoubleDouble) -> DoubleDouble {
    if !(x.hi > 0.0 && x.hi.is_finite()) {
        return DoubleDouble::from(x.hi.sqrt());
    }
    // Squares of the smallest numbers have no low part.
    if x.hi < 1e-200 {
        return sqrt(x.scaled(400)).scaled(-200);
    }
    let root = x.hi.sqrt();
    let (square, error) = two_product(root, root);
    let rest = ((x.hi - square) - error) + x.lo;
    DoubleDouble::settled(root, rest / (2.0 * root), root)
}

/// ∛x: from the root y in `f64`, with d = (x − y³)/(3y²), y + d − d²/y.
pub(super) fn cbrt(x: DoubleDouble) -> DoubleDouble {
    if x.hi == 0.0 || !x.hi.is_finite() {
        return DoubleDouble::from(x.hi.cbrt());
    }
    if x.hi.abs() < 1e-200 {
        return cbrt(x.scaled(600)).scaled(-200);
    }
    let root = x.hi.cbrt();
    let (square, error) = two_product(root, root);
    let square = DoubleDouble::pair(square, error);
    let rest = (x - square.times(root)).hi;
    let change = rest / (3.0 * square.hi);
    DoubleDouble::settled(root, change - change * change / root, root)
}

/// xⁿ by squaring and multiplying.
pub(super) fn powi(x: DoubleDouble, n: i32) -> DoubleDouble {
    // Products do not keep the sign of a zero.
    if x.hi == 0.0 {
        return DoubleDouble::from(x.hi.powi(n));
    }
    let (mut power, mut square, mut left) = (ONE, x, n.unsigned_abs());
    while left > 0 {
        if left & 1 == 1 {
            power *= square;
        }
        left >>= 1;
        if left > 0 {
            square *= square;
        }
    }
    if n < 0 { ONE / power } else { power }
}

/// xᵖ: exp(p ln x), and xⁿ where p is an integer that fits.
pub(super) fn powf(x: DoubleDouble, p: DoubleDouble) -> DoubleDouble {
    let plain = || DoubleDouble::from(x.hi.powf(p.hi));
    if !(x.hi.is_finite() && p.hi.is_finite()) || x.hi == 0.0 {
        return plain();
    }
    let integer = p.lo == 0.0 && p.hi == p.hi.trunc();
    if integer && p.hi.abs() <= 1024.0 {
        return powi(x, p.hi as i32);
    }
    if x.hi > 0.0 {
        return super::exponential::exp(p * super::exponential::ln(x));
    }
    // A negative number has powers with integer exponents only, and large ones have no odd part to speak of.
    if !integer {
        return DoubleDouble::from(f64::NAN);
    }
    let power = powf(-x, p);
    if p.hi % 2.0 == 0.0 { power } else { -power }
}
