//! How the equation of an implicit step is solved.

use crate::linear::{Asked, Corrections};
use crate::program::Program;

/// The solution of an implicit step.
#[derive(Clone, Debug)]
pub struct Step {
    /// How often the program runs, and what it gives.
    pub way: Way,
    /// How it gives the force.
    pub given: Given,
    /// What is asked of the numbers that follow, which are positive only where the solution
    /// [has grown](crate::linear::Solution::positive) from that of a step of no length.
    pub asked: Asked,
    /// What is computed each time.
    pub program: Program,
}

/// The way to the solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// The equation is linear: one correction from Δ = 0 is the solution. Outputs: as of Newton's method.
    Linear,
    /// Newton's method in all coordinates. Outputs of one correction: δ, the force, and what is asked.
    Newton,
    /// One scalar unknown. Outputs: the coefficient of the force and its first two derivatives.
    Central,
}

/// How the force after a correction is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// G and G + J δ: by the trapezoidal step.
    Rounded,
    /// G and J δ, which may be less than half an ulp of G: what conserves the energy must not lose it. By the energy-exact steps.
    InParts,
}

impl From<Corrections> for Way {
    fn from(corrections: Corrections) -> Self {
        if corrections == Corrections::Several { Self::Newton } else { Self::Linear }
    }
}

impl Given {
    /// How many vectors a correction has: δ, G, and J δ or the sum with it.
    pub const VECTORS: usize = 3;
}
