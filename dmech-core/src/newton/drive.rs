//! The Newton loop that all laws share.

use dmech_scalar::Real;

use super::settle::settle;
use super::settled::Settled;
use super::{Correction, Equation, Increment, NotConverged, continuation};

/// Solves the equation by Newton corrections δ = `correct`(equation, Δ, b) with b = q + Δ, to round-off on Δ.
///
/// `correct` must use the equation that it is given, and a of it for a force between two points: where the guess is not good enough, the
/// step is lengthened gradually and the equation passed in is that of a shorter step. The gradient returned is G + J δ of the last
/// correction, so the force is not evaluated again at the solution.
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
#[inline]
pub fn drive<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    solve::<false, D, R>(equation, correct)
}

/// As [`drive`] and [`drive_middle`].
#[inline(always)]
pub(super) fn solve<const ONCE_ROUNDED: bool, const D: usize, R: Real>(
    equation: &Equation<D, R>,
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    match settle::<ONCE_ROUNDED, D, R>(equation, &mut correct) {
        Ok(found) => Ok(found),
        Err(astray) if Settled::<D, R>::MANY => Err(astray.into()),
        Err(astray) => Increment::apart(continuation::follow::<ONCE_ROUNDED, D, R>(*equation, astray, correct)),
    }
}

/// As [`drive`], with the increment rounded once: for forces that do no work.
///
/// # Errors
/// [`NotConverged`] when no root that is continuous with a shorter step can be reached.
#[inline]
pub fn drive_middle<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    solve::<true, D, R>(equation, correct)
}
