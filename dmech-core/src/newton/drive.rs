//! The Newton loop that all laws share.

use dmech_scalar::{Count, Real};

use super::doubt::{Ask, is_continued};
use super::settle::settle;
use super::settled::Settled;
use super::{Correction, Equation, Increment, NotConverged, continuation};

/// Solves the equation by Newton corrections δ = `correct`(equation, Δ, b) with b = q + Δ, to round-off on Δ.
///
/// `correct` must use the equation that it is given: where the guess is not good enough, the step is lengthened
/// gradually and the equation passed in is that of a shorter step. The gradient returned is G + J δ of the last
/// correction, so the force is not evaluated again at the solution.
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
#[inline]
pub fn drive<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    asked::<false, D, R>(equation, correct, ())
}

/// As [`drive`] and [`drive_middle`]; of the root that is found it is asked whether it continues that of a shorter step.
#[inline(always)]
pub(super) fn asked<const ONCE_ROUNDED: bool, const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
    ask: impl Ask,
) -> Result<Increment<D, R>, NotConverged> {
    match settle::<ONCE_ROUNDED, D, R>(equation, &mut correct) {
        Ok(increment) if is_continued(equation, increment.delta, &mut correct, ask) => Ok(increment),
        Ok(_) if Settled::<D, R>::MANY => Err(NotConverged::NOT_CONTINUED),
        Ok(found) => {
            let spent = found.iterations.to_u64() as u32;
            let found = continuation::follow::<ONCE_ROUNDED, D, R>(*equation, spent, correct, ask);
            Increment::apart(found.map_err(|_| NotConverged::NOT_CONTINUED))
        }
        Err(astray) if Settled::<D, R>::MANY => Err(astray),
        Err(astray) => {
            let spent = astray.iterations as u32;
            Increment::apart(continuation::follow::<ONCE_ROUNDED, D, R>(*equation, spent, correct, ask))
        }
    }
}

/// As [`drive`], for a force between two points; `correct` gets the equation, a, Δ and b.
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
#[inline]
pub fn drive_discrete<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    drive(equation, |equation, delta, b| correct(equation, equation.a, delta, b))
}

/// As [`drive_discrete`], with the increment rounded once: for forces that do no work.
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
#[inline]
pub fn drive_middle<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    asked::<true, D, R>(equation, |equation, delta, b| correct(equation, equation.a, delta, b), ())
}
