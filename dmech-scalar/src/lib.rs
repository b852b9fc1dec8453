//! The scalar of dmech: the trait [`Real`] for `f64`, `f32` and [`DoubleDouble`] numbers of 31 digits, with the feature
//! `lanes` also for `Lanes`, eight `f64` side by side, and [`Compensated`] sums for steps that must not drift.
//!
//! ```
//! use dmech_scalar::Real;
//!
//! // The slope of ln between 1 − δ and 1 + δ is artanh(δ)/δ: no 0/0, however small δ is.
//! fn mean_slope_of_ln<R: Real>(delta: R) -> R {
//!     delta.atanhc()
//! }
//! assert_eq!(mean_slope_of_ln(0.0), 1.0);
//! assert_eq!(mean_slope_of_ln(1e-200), 1.0);
//! assert!((mean_slope_of_ln(0.5_f64) - 3.0_f64.ln()).abs() < 1e-15);
//! ```
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

mod atanc;
mod atanhc;
mod compensated;
mod cube;
mod double;
mod exact;
mod functions;
#[cfg(feature = "lanes")]
mod lanes;
#[cfg(feature = "lanes")]
mod operators;
mod polynomial;
mod primitive;
mod real;
#[cfg(feature = "lanes")]
mod rows;
mod sinc;
mod sinhc;

pub use compensated::{Compensated, CompensatedVector, two_sum};
pub use double::{DoubleDouble, ParseDoubleDoubleError};
pub use exact::Exact;
#[cfg(feature = "lanes")]
pub use lanes::{Lanes, LanesMask};
pub use primitive::FUSED;
pub use real::{Count, Mask, Real};
#[cfg(feature = "lanes")]
pub use rows::{Rows, RowsMask};
