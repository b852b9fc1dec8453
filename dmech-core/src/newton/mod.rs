//! Solving the implicit steps: Newton to round-off on the increment.
//!
//! Hand-written laws use [`dense`] and [`dense_discrete`]; generated ones bring their own correction in a straight
//! line and use [`drive`] and [`drive_discrete`], or [`once`], [`once_discrete`] and
//! [`once_middle`] where the Hessian is constant; a
//! law that depends on |q| alone has one scalar unknown and uses [`central`].

mod continuation;
mod dense;
mod drive;
mod elimination;
mod equation;
mod once;

pub mod central;

pub use dense::{dense, dense_discrete, linear};
pub use drive::{drive, drive_discrete, drive_middle};
pub use equation::{Correction, Equation, Increment, NotConverged};
pub use once::{once, once_discrete, once_middle};
