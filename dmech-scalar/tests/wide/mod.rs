//! Double-double numbers that look random, and their values.

use dmech_scalar::DoubleDouble;

use crate::exact::{Big, big};
use crate::uniform::Uniform;

/// x with a low part of its own.
pub(crate) fn filled(uniform: &mut Uniform, x: f64) -> DoubleDouble {
    DoubleDouble::new(x, x * uniform.between(-1.0, 1.0) * 2f64.powi(-54))
}

/// Of either sign, evenly in the logarithm.
pub(crate) fn magnitude(uniform: &mut Uniform, least: f64, most: f64) -> f64 {
    let sign = if uniform.next() < 0.5 { -1.0 } else { 1.0 };
    sign * 10f64.powf(uniform.between(least.log10(), most.log10()))
}

/// hi + lo with all digits.
pub(crate) fn exact_value(x: DoubleDouble) -> Big {
    big(x.hi()) + big(x.lo())
}
