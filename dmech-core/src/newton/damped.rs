//! Where the force bends so sharply that no whole correction leads to the root: corrections shortened until they pay.

use crate::vector::{by_component, largest};
use dmech_scalar::{Count, Real};

use super::settle::{length, settle};
use super::{Correction, Equation, Increment, NotConverged};

/// The shortest part of a correction that is tried.
const SHORTEST: f64 = 1e-12;
/// By how much of itself, at the least, the residual must shrink (L. Armijo, Pacific J. Math. 16 (1966) 1).
const SUFFICIENT: f64 = 1e-4;

/// Newton's method with each correction halved until the residual shrinks, for piecewise forces that the path from a shorter
/// step does not lead past: at a seam the path may turn more sharply than any prediction of it.
///
/// Near the root it is [`settle`] that brings it to rounding. Of several roots it is the one that the guess leads to.
///
/// # Errors
/// [`NotConverged`] where the residual cannot be made smaller.
#[cold]
#[inline(never)]
pub(super) fn descend<const ONCE_ROUNDED: bool, const D: usize, R: Real>(
    equation: Equation<D, R>,
    spent: u32,
    correct: &mut impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    // |drift − frozen − g G − Δ|, G where the correction was made.
    let rest = |delta: [R; D], made: &Correction<D, R>| length(&equation.rest(delta, made.parts[0])).to_f64();
    let mut delta = equation.guess;
    let mut made = correct(&equation, delta, equation.end(delta));
    let mut left = rest(delta, &made);
    let mut evaluations = spent + 1;
    let mut part = 1.0;
    while evaluations < equation.max_iterations && part >= SHORTEST && left.is_finite() {
        let share = R::from_f64(part);
        let shorter: [R; D] = by_component!(|i| share.mul_add(made.delta[i], delta[i]));
        let next = correct(&equation, shorter, equation.end(shorter));
        evaluations += 1;
        let remains = rest(shorter, &next);
        if remains < (1.0 - SUFFICIENT * part) * left {
            let near = part == 1.0 && remains < 0.1 * left;
            (delta, made, left) = (shorter, next, remains);
            if near {
                match settle::<ONCE_ROUNDED, D, R>(&Equation { guess: delta, ..equation }, correct) {
                    Ok(found) => {
                        evaluations += found.evaluations.to_u64() as u32;
                        return Ok(found.after(evaluations));
                    }
                    Err(astray) if astray.elsewhere => return Err(astray.into()),
                    Err(_) => {}
                }
            }
            part = f64::min(1.0, 2.0 * part);
        } else {
            part *= 0.5;
        }
    }
    Err(NotConverged { iterations: evaluations.into(), residual: largest(&made.delta) })
}
