//! The functions of the language, written once for `f64` and for `Lanes`.
//!
//! A function takes any [`Number`]: one, or eight side by side. What it does most of the time has no branch on the numbers, only
//! selections; a rare case is a branch that all lanes take together, in a function of its own, where each lane gets the bits
//! that it would get alone. There is no table but that of `powf`, whose logarithm needs more digits than
//! a polynomial gives in good time.
//!
//! All are held to one ulp against 120 digits, at their edges first (`tests/functions.rs`). The largest errors seen, in
//! runs of one thousand to thirty thousand arguments each with and without a fused instruction:
//!
//! | | ulp | | ulp | | ulp | | ulp |
//! |---|---|---|---|---|---|---|---|
//! | exp | 0.75 | ln | 0.87 | sin | 0.77 | sinh | 0.74 |
//! | exp2 | 0.75 | ln_1p | 0.87 | cos | 0.75 | cosh | 0.67 |
//! | exp_m1 | 0.78 | log2 | 0.92 | tan | 0.90 | tanh | 0.79 |
//! | powf | 0.73 | log10 | 0.82 | asin | 0.60 | asinh | 0.81 |
//! | cbrt | 0.67 | atan | 0.58 | acos | 0.62 | acosh | 0.75 |
//! | | | atan2 | 0.61 | | | atanh | 0.72 |
//!
//! Fused and not, the same source gives different last bits. Without `mul_add` the results would be equal on all
//! targets, but a value of exp or sin that waits for the last takes a third longer then, and one of powf half as long again:
//! too much for a step that is held to a loop with the standard library's functions. So `mul_add` is used, and what must
//! be exact does not depend on it.
//!
//! Polynomials are evaluated by Estrin's scheme, and errors of sums are added last, because a step of a simulation waits for one value at a
//! time: the chain of operations from argument to result is what counts, not their number.

mod exponential;
mod hyperbolic;
mod inverse_hyperbolic;
mod inverse_trigonometric;
mod logarithmic;
mod number;
mod power;
mod quarter_turns;
mod trigonometric;

pub(crate) use crate::atanc::{atanc, atanc_slope};
pub(crate) use crate::atanhc::{atanhc, atanhc_slope};
pub(crate) use crate::sinc::{sinc, sinc_slope};
pub(crate) use crate::sinhc::{sinhc, sinhc_slope};
pub(crate) use exponential::{exp, exp_m1, exp2};
pub(crate) use hyperbolic::{cosh, sinh, tanh};
pub(crate) use inverse_hyperbolic::{acosh, asinh, atanh};
pub(crate) use inverse_trigonometric::{acos, asin, atan, atan2};
pub(crate) use logarithmic::{ln, ln_1p, log2, log10};
pub(crate) use number::{Bits, Number, b, by_range, c, fast_two_sum, split_error, two_product};
pub(crate) use power::{cbrt, powf};
pub(crate) use trigonometric::{cos, sin, tan};
