//! Linear forces: one correction from Δ = 0 is the solution.

use dmech_scalar::{Count, Real};

use super::settle::largest;
use super::{Correction, Equation, Increment, NotConverged};
use crate::vector::finite;

/// Solves a linear step: `correct` is called once, with Δ = 0 and b = q.
///
/// For Φ = k q²/2 this is Kanatani's explicit form (3.20)–(3.21).
///
/// # Errors
/// [`NotConverged`] when the solution is not finite: 1 + g J is singular.
pub fn once<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    let Correction { gradient, parts, .. } = correct(equation, [R::ZERO; D], equation.q);
    let delta = equation.increment(gradient);
    if finite(delta) {
        Ok(Increment { delta, gradient, parts, evaluations: Count::of(1), iterations: Count::of(0) })
    } else {
        Err(NotConverged { iterations: 0, residual: largest(&delta) })
    }
}

/// As [`once`], for a force between two points; `correct` gets the equation, a, Δ and b.
///
/// # Errors
/// [`NotConverged`] when the solution is not finite: 1 + g J is singular.
pub fn once_discrete<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    once(equation, |equation, delta, b| correct(equation, equation.a, delta, b))
}

/// As [`once_discrete`], with a second correction on the residual of the first solution, and increments rounded once:
/// for forces that do no work.
///
/// The elimination rounds the same matrix in the same way at every step. Where Δ must be more than nearly right, for a
/// force that is to stand at right angles to it, that error would add up; after the second correction it is of second
/// order.
///
/// # Errors
/// [`NotConverged`] when the solution is not finite: 1 + g J is singular.
#[inline(always)]
pub fn once_middle<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    let first = correct(equation, equation.a, [R::ZERO; D], equation.q);
    let first = equation.increment_and_rest(first.gradient).0;
    let Correction { gradient, parts, .. } = correct(equation, equation.a, first, equation.end(first));
    let delta = equation.increment_and_rest(gradient).0;
    if finite(delta) {
        Ok(Increment { delta, gradient, parts, evaluations: Count::of(2), iterations: Count::of(0) })
    } else {
        Err(NotConverged { iterations: 0, residual: largest(&delta) })
    }
}
