//! Numbers with 120 digits.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

/// A binary number with 400 bits.
pub(crate) type Big = FBig<HalfEven, 2>;

const BITS: usize = 400;

/// The very value of x, to be computed with at 400 bits.
pub(crate) fn big(x: f64) -> Big {
    Big::try_from(x).expect("a finite number").with_precision(BITS).value()
}
