//! What can go wrong with a study.

use dmech_core::Error;
use thiserror::Error as Described;

/// Why a study could not be made.
#[derive(Clone, Copy, Debug, PartialEq, Described)]
#[non_exhaustive]
pub enum StudyError {
    /// It has no schemes.
    #[error("the study has no schemes: call .scheme(...)")]
    NoSchemes,
    /// Its ladder has no steps.
    #[error(
        "the ladder has no steps: .ladder([0.1, 0.05, 0.025]), or leave it out for halvings of a step that suits the motion"
    )]
    NoSteps,
    /// A scheme whose steps follow the motion has no tolerances.
    #[error("a scheme that follows the motion has no tolerances: .adaptive(scheme, [1e-4, 1e-6, 1e-8])")]
    NoTolerances,
    /// The exact solution is infinite or NaN.
    #[error("the exact solution has the component {value:e} at the end, t = {time}")]
    Exact {
        /// The refused component.
        value: f64,
        /// The time of the end.
        time: f64,
    },
    /// It does not have as many coordinates as the motion.
    #[error("the exact solution has {given} coordinates, the motion {needed}")]
    Coordinates {
        /// Those of the solution.
        given: usize,
        /// Those of the motion.
        needed: usize,
    },
    /// The motion itself is refused, or a step of the ladder, or no reference can be computed.
    #[error(transparent)]
    Motion(#[from] Error),
}
