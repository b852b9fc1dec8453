//! The instructions of implicit steps.

use core::fmt::Debug;

use super::{Effort, Step, System};
use crate::newton::NotConverged;

/// A system whose steps can be solved for: a scheme finds Δq by one of three equations, and settles what was found.
pub trait ImplicitSteps: System {
    /// Where a step works: for many bodies its Newton matrix.
    type Solver: Clone + Debug;
    /// The solution, or what is to be said of it beside the solver.
    type Found;

    /// What they work in.
    fn solver(&self) -> Self::Solver;
    /// Finds Δq = h v − (h²/4m)(S + S′) with the slopes S = `known` now and S′ at the end: mean force.
    ///
    /// # Errors
    /// [`NotConverged`]
    fn solve_mean(
        &self,
        solver: &mut Self::Solver,
        step: &Step<'_, Self>,
        known: &Self::Vector,
    ) -> Result<Self::Found, NotConverged>;
    /// Finds Δq = h v − (h²/2m)(∇̄Φ(q, q + Δq) − (F + F′)/2).
    ///
    /// # Errors
    /// [`NotConverged`]
    fn solve_exact(&self, solver: &mut Self::Solver, step: &Step<'_, Self>) -> Result<Self::Found, NotConverged>;
    /// Finds Δq = h z − (h²/m)(∇̄Φ(q₋, q + Δq) − F) with the position q₋ `before`.
    ///
    /// # Errors
    /// [`NotConverged`]
    fn solve_across(
        &self,
        solver: &mut Self::Solver,
        step: &Step<'_, Self>,
        before: &Self::Vector,
    ) -> Result<Self::Found, NotConverged>;
    /// v −= (h/m) S with the slope S that was found, and q += h (v + share·change) with v as it was: ½ for the mean velocity, 1 for that
    /// after. What rounding keeps from S is carried on.
    fn settle(
        &self,
        solver: &mut Self::Solver,
        stride: &Self::Stride,
        share: f64,
        found: &mut Self::Found,
        moves: [&mut Self::Sum; 2],
    );
    /// The same with S = (`known` + what was found)/2 and the mean velocity.
    fn settle_mean(
        &self,
        solver: &mut Self::Solver,
        stride: &Self::Stride,
        known: &Self::Vector,
        found: &mut Self::Found,
        moves: [&mut Self::Sum; 2],
    );
    /// The slope that was found.
    fn found<'a>(solver: &'a Self::Solver, found: &'a Self::Found) -> &'a Self::Vector;
    /// Δq.
    fn moved<'a>(solver: &'a Self::Solver, found: &'a Self::Found) -> &'a Self::Vector;
    /// Puts the slope that was found in the place of another; what the solver has of it is then of no use.
    fn keep(solver: &mut Self::Solver, found: &Self::Found, place: &mut Self::Vector);
    /// What it cost.
    fn effort(found: &Self::Found) -> Effort<Self::Scalar>;
}
