//! Linear forces: one correction from Δ = 0 is the solution, if it continues that of a shorter step; a second one its last digits.
//!
//! 1 + g J grows from the unit matrix as the step does. Where it was singular on the way the root came in from infinity, on
//! the other side: down a hill Φ = −k q²/2 that of a step longer than 2√(m/k). What says so are numbers that come with the
//! correction and must all be positive: the pivots where J is symmetric, as 1 + g J is then positive definite, and of any
//! other J the determinant.

use dmech_scalar::{Count, Mask, Real};

use super::{Correction, Equation, Increment, NotConverged};
use crate::vector::{finite, largest};

/// Solves a linear step: `correct` is called once, with Δ = 0 and b = q. It returns, beside the correction, what is positive
/// only where the root continues that of a shorter step.
///
/// For Φ = k q²/2 this is Kanatani's explicit form (3.20)–(3.21).
///
/// # Errors
/// [`NotConverged::NOT_CONTINUED`] when the solution does not continue that of a shorter step, or 1 + g J is singular;
/// [`NotConverged`] when it is not finite.
pub fn once<const D: usize, const N: usize, R: Real>(
    equation: &Equation<D, R>,
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> (Correction<D, R>, [R; N]),
) -> Result<Increment<D, R>, NotConverged> {
    let (Correction { gradient, parts, .. }, positive) = correct(equation, [R::ZERO; D], equation.q);
    let delta = equation.increment(gradient);
    let increment = Increment { delta, gradient, parts, evaluations: Count::of(1), iterations: Count::of(0) };
    continued(increment, positive)
}

/// As [`once`], with a second correction on the residual of the first solution.
///
/// The elimination rounds the same matrix in the same way at every step. Where the energy is to be exact that error would add up,
/// the more the stiffer the law is: of an oscillator to 10⁻¹¹ in 10⁶ steps of a tenth of a period, to 10⁻⁴ in steps of 100 radians. After
/// the second correction it is of second order.
///
/// # Errors
/// As of [`once`].
#[inline(always)]
pub fn twice<const D: usize, const N: usize, R: Real>(
    equation: &Equation<D, R>,
    correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> (Correction<D, R>, [R; N]),
) -> Result<Increment<D, R>, NotConverged> {
    second(equation, Equation::increment, correct)
}

/// As [`twice`], with increments rounded once: for forces that do no work, which are to stand at right angles to Δ.
///
/// # Errors
/// As of [`once`].
#[inline(always)]
pub fn twice_middle<const D: usize, const N: usize, R: Real>(
    equation: &Equation<D, R>,
    correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> (Correction<D, R>, [R; N]),
) -> Result<Increment<D, R>, NotConverged> {
    second(equation, |equation, gradient| equation.increment_and_rest(gradient).0, correct)
}

#[inline(always)]
fn second<const D: usize, const N: usize, R: Real>(
    equation: &Equation<D, R>,
    increment: impl Fn(&Equation<D, R>, [R; D]) -> [R; D],
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> (Correction<D, R>, [R; N]),
) -> Result<Increment<D, R>, NotConverged> {
    let (first, _) = correct(equation, [R::ZERO; D], equation.q);
    let first = increment(equation, first.gradient);
    let (Correction { gradient, parts, .. }, positive) = correct(equation, first, equation.end(first));
    let delta = increment(equation, gradient);
    let increment = Increment { delta, gradient, parts, evaluations: Count::of(2), iterations: Count::of(0) };
    continued(increment, positive)
}

/// The solution, if it is one and continues that of a shorter step.
#[inline(always)]
fn continued<const D: usize, const N: usize, R: Real>(
    increment: Increment<D, R>,
    positive: [R; N],
) -> Result<Increment<D, R>, NotConverged> {
    // In this order: what is finite is seen of several components at once.
    if !finite(increment.delta) {
        return Err(lost(increment.delta, positive));
    }
    if !all_positive(positive) {
        return Err(NotConverged::NOT_CONTINUED);
    }
    Ok(increment)
}

#[inline(always)]
fn all_positive<const N: usize, R: Real>(x: [R; N]) -> bool {
    x.iter().all(|&x| R::ZERO.less(x).all())
}

/// Why a solution is not finite.
#[cold]
fn lost<const D: usize, const N: usize, R: Real>(delta: [R; D], positive: [R; N]) -> NotConverged {
    if all_positive(positive) {
        NotConverged { iterations: 1, residual: largest(&delta) }
    } else {
        NotConverged::NOT_CONTINUED
    }
}
