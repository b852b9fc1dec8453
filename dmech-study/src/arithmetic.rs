//! Arithmetic of arrays.

pub(crate) use dmech_core::extend::vector::{add_scaled, difference, dot, finite, scaled, sum};
