//! Solving the implicit steps: Newton to round-off on the increment.
//!
//! Hand-written laws use [`dense`], [`dense_discrete`], [`dense_forced`] and [`dense_middle`], or [`linear`] and
//! [`linear_discrete`]; generated ones bring
//! their own correction in a straight line and use [`drive`] and [`drive_middle`], or [`once`],
//! [`twice`] and [`twice_middle`] where the Hessian is constant; a law that depends on |q| alone has one scalar
//! unknown and uses [`central`].

pub(crate) mod cancelling;
mod continuation;
mod damped;
mod dense;
mod doubt;
mod drive;
pub(crate) mod elimination;
mod equation;
mod once;
pub(crate) mod options;
pub(crate) mod path;
pub(crate) mod resolution;
mod settle;
mod settled;

pub mod central;

pub(crate) use dense::free;
pub use dense::{dense, dense_discrete, dense_forced, dense_middle, linear, linear_discrete};
pub use drive::{drive, drive_middle};
pub use equation::{Correction, Counts, Equation, Increment, NotConverged};
pub use once::{once, twice, twice_middle};
