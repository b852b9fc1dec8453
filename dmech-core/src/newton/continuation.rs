//! Where the guess is not good enough: lengthen the step gradually.

use crate::vector::by_component;
use dmech_scalar::{Count, Real};

use super::damped;
use super::settle::{Astray, largest, settle};
use super::{Correction, Equation, Increment, NotConverged};

/// The shortest progress in θ before the path counts as ended (a fold: beyond it no continuous root exists). Near a singularity the
/// first may have to be as short.
const SHORTEST: f64 = 1.0 / 16_777_216.0;
/// Corrections in which the whole step is solved from where it starts: so fast only the root of a motion that goes on is near.
pub(crate) const SWIFT: u32 = 4;

/// Follows the root of the equation from a step of length 0, where Δ = 0, to the whole step.
///
/// θ, the part of the step, advances by as much as Newton accepts and leads to roots that continue the last. Each Δ(θ) is predicted
/// with the force extrapolated linearly in θ, so that the powers θ and θ² of the known parts are exact.
///
/// First the whole step is tried from Δ = 0: a stiff force is nothing to predict by, and there only the curvature of the rest is to be
/// corrected. On top of a hill that leads to where the motion has turned round, which an unsymmetric J may not tell: its pivots do.
///
/// The equation comes by value: were it borrowed, every step that does not come here would still lay it out in memory.
#[cold]
#[inline(never)]
pub(super) fn follow<const ONCE_ROUNDED: bool, const D: usize, R: Real>(
    equation: Equation<D, R>,
    astray: Astray,
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    let mut evaluations = astray.evaluations;
    let start = Equation { guess: [R::ZERO; D], ..equation.shortened(R::ZERO) };
    let mut gradient = correct(&start, start.guess, equation.q).gradient;
    evaluations += 1;
    let mut slope = [R::ZERO; D];
    let mut theta = 0.0;
    let mut advance = 1.0;
    let mut last = Astray { residual: largest(&equation.guess), ..astray };
    while evaluations < equation.max_iterations {
        let next = f64::min(theta + advance, 1.0);
        // At the end the equation itself: a is then exact.
        let mut part = if next < 1.0 { equation.shortened(R::from_f64(next)) } else { equation };
        let ahead = next - theta;
        if ahead == 1.0 {
            let max_iterations = SWIFT.min(part.max_iterations);
            part = Equation { guess: start.guess, max_iterations, definite: true, ..part };
        } else {
            let ahead = R::from_f64(ahead);
            part.guess = part.increment(by_component!(|i| ahead.mul_add(slope[i], gradient[i])));
        }
        match settle::<ONCE_ROUNDED, D, R>(&part, &mut correct) {
            Ok(found) => {
                evaluations += found.evaluations.to_u64() as u32;
                if next >= 1.0 {
                    return Ok(found.after(evaluations));
                }
                slope = by_component!(|i| (found.gradient[i] - gradient[i]) / R::from_f64(ahead));
                gradient = found.gradient;
                theta = next;
                advance *= 2.0;
            }
            Err(astray) => {
                evaluations += astray.evaluations;
                last = astray;
                advance *= 0.25;
                if advance < SHORTEST {
                    break;
                }
            }
        }
    }
    if equation.piecewise {
        let spent = evaluations.min(equation.max_iterations / 2);
        return damped::descend::<ONCE_ROUNDED, D, R>(equation, spent, &mut correct);
    }
    Err(Astray { evaluations, elsewhere: astray.elsewhere || last.elsewhere, ..last }.into())
}
