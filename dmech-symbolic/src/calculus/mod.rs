//! Derivatives and their discrete counterparts.

mod centre;
mod derivative;
mod discrete_gradient;
mod divided_difference;
mod gateways;
mod piecewise;
mod quotient;
mod slopes;
mod two_arguments;
mod wholes;

pub use derivative::{derivative, gradient, hessian, jacobian, tangent};
pub use discrete_gradient::{TwoPoints, discrete_gradient};
pub use divided_difference::divided_difference;
pub use wholes::with_whole_choices;
