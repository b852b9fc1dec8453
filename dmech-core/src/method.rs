//! What is said of a scheme before it moves anything.

use crate::error::Error;
use crate::invariant::{Invariant, Kept};

/// What a scheme promises, whatever the law.
pub trait Method: Copy + core::fmt::Debug {
    /// The name in reports.
    const NAME: &'static str;
    /// The global error of the position is O(dt^ORDER).
    const ORDER: u32;
    /// A step back from the new state returns to the old one: the scheme can be composed to higher order.
    const SYMMETRIC: bool;

    /// How well the scheme keeps an invariant of the law.
    fn keeps(invariant: Invariant) -> Kept;

    /// The tolerance of an [`Adaptive`](crate::Adaptive) scheme; `None` where all steps are equal.
    fn tolerance(&self) -> Option<f64> {
        None
    }

    /// Refuses what is asked of the scheme where no step can follow.
    ///
    /// # Errors
    /// [`Error::Tolerance`] and [`Error::TurnVanished`] where the scheme chooses its steps.
    fn check(&self) -> Result<(), Error> {
        Ok(())
    }

    /// The same scheme with its last step ending at the time `end`, where it chooses its steps.
    fn until(self, _end: f64) -> Self {
        self
    }
}
