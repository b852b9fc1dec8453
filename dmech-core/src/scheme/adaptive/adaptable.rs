//! Which schemes may change their step.

use crate::scheme::composed::Coefficients;
use crate::scheme::{Composed, DiscreteGradient, Implicit, Method};

/// A scheme that loses nothing when its steps differ: [`Simulation::adaptive`](crate::Simulation::adaptive) takes it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot follow the time scale of the motion",
    label = "needs equal steps",
    note = "give the step with `.dt(h)`, or use `DiscreteGradient`, `Implicit` or a composition of them"
)]
pub trait Adaptable: Method {
    /// ε, the angle in radians by which the linearised motion turns in a step, for a tolerance.
    fn angle(&self, tolerance: f64) -> f64;
}

impl Adaptable for DiscreteGradient {
    fn angle(&self, tolerance: f64) -> f64 {
        (12.0 * tolerance).sqrt()
    }
}

impl Adaptable for Implicit {
    fn angle(&self, tolerance: f64) -> f64 {
        (12.0 * tolerance).sqrt()
    }
}

impl<C: Coefficients<N>, const N: usize> Adaptable for Composed<DiscreteGradient, C, N> {
    fn angle(&self, tolerance: f64) -> f64 {
        tolerance.powf(1.0 / f64::from(C::ORDER))
    }
}

impl<C: Coefficients<N>, const N: usize> Adaptable for Composed<Implicit, C, N> {
    fn angle(&self, tolerance: f64) -> f64 {
        tolerance.powf(1.0 / f64::from(C::ORDER))
    }
}
