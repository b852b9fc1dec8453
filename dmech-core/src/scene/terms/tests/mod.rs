//! Terms against matrices, differences and the motion of one body.

mod laws;
mod look;
mod turned;
mod ways;
