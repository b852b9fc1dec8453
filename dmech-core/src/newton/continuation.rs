//! Where the guess is not good enough: lengthen the step gradually.

use crate::vector::{by_component, largest};
use dmech_scalar::{Count, Mask, Real};

use super::cancelling::{self, LostBody};
use super::damped;
use super::path::{Path, SWIFT};
use super::settle::{Astray, length, settle};
use super::{Correction, Equation, Increment, NotConverged};

/// Where the guess has not led to the root: the one that lengthening the step leads to, or that of forces that cancel as far as they are known.
///
/// The equation comes by value: were it borrowed, every step that does not come here would still lay it out in memory.
#[cold]
#[inline(never)]
pub(super) fn follow<const ONCE_ROUNDED: bool, const D: usize, R: Real>(
    equation: Equation<D, R>,
    astray: Astray,
    mut correct: impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    let lost = match lengthen::<ONCE_ROUNDED, D, R>(equation, astray, &mut correct) {
        Ok(found) => return Ok(found),
        Err(lost) => lost,
    };
    // From a guess far off the first correction is long whatever the force.
    let shortest = astray.residual.min(lost.residual);
    let corrections = equation.max_iterations.saturating_sub(astray.evaluations);
    let mut ended = LostBody::new(&equation, correct);
    cancelling::root(&mut ended, equation.guess, corrections, shortest).ok_or(lost)?;
    let LostBody { made, evaluations, .. } = ended;
    let continued = if equation.definite { made.definite } else { made.continued };
    if !continued.all() {
        return Err(lost);
    }
    let (slope, rest) = (made.parts[0], [R::ZERO; D]);
    let delta = if ONCE_ROUNDED { equation.increment_and_rest(slope).0 } else { equation.increment(slope) };
    let made = Count::of(u32::max(astray.evaluations, lost.iterations as u32) + evaluations);
    Ok(Increment { delta, gradient: slope, parts: [slope, rest], evaluations: made, iterations: made })
}

/// Follows the root of the equation from a step of length 0, where Δ = 0, to the whole step.
///
/// Each Δ(θ) is predicted with the force extrapolated linearly in θ, so that the powers θ and θ² of the known parts are exact.
fn lengthen<const ONCE_ROUNDED: bool, const D: usize, R: Real>(
    equation: Equation<D, R>,
    astray: Astray,
    correct: &mut impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, NotConverged> {
    let mut evaluations = astray.evaluations;
    let start = Equation { guess: [R::ZERO; D], ..equation.shortened(R::ZERO) };
    let mut gradient = correct(&start, start.guess, equation.q).gradient;
    evaluations += 1;
    let mut slope = [R::ZERO; D];
    let mut path = Path::by(1.0);
    let mut last = Astray { residual: largest(&equation.guess), ..astray };
    while let Some(stretch) = path.next().filter(|_| evaluations < equation.max_iterations) {
        // At the end the equation itself: a is then exact.
        let mut part = if stretch.is_last() { equation } else { equation.shortened(R::from_f64(stretch.end)) };
        let ahead = R::from_f64(stretch.ahead);
        if stretch.is_all() {
            let max_iterations = SWIFT.min(part.max_iterations);
            part = Equation { guess: start.guess, max_iterations, definite: true, ..part };
        } else {
            part.guess = part.increment(by_component!(|i| ahead.mul_add(slope[i], gradient[i])));
        }
        let mut settled = settle::<ONCE_ROUNDED, D, R>(&part, correct);
        if let Ok(found) = &settled
            && stretch.is_all()
            && passes_a_root(&part, found.delta, correct, &mut evaluations)
        {
            let evaluations = found.evaluations.to_u64() as u32;
            settled = Err(Astray { evaluations, residual: largest(&found.delta), elsewhere: true });
        }
        match settled {
            Ok(found) => {
                evaluations += found.evaluations.to_u64() as u32;
                if stretch.is_last() {
                    return Ok(found.after(evaluations));
                }
                slope = by_component!(|i| (found.gradient[i] - gradient[i]) / ahead);
                gradient = found.gradient;
                path.reaches(stretch);
            }
            Err(astray) => {
                evaluations += astray.evaluations;
                last = astray;
                path.shortens();
            }
        }
    }
    if equation.piecewise {
        let spent = evaluations.min(equation.max_iterations / 2);
        return damped::descend::<ONCE_ROUNDED, D, R>(equation, spent, correct);
    }
    Err(Astray { evaluations, elsewhere: astray.elsewhere || last.elsewhere, ..last }.into())
}

/// Whether a root, where the first correction is farther than the known side [reaches](Equation::reach), is another than that of a shorter
/// step: half way to it the residual drives back, so that there is one before it.
fn passes_a_root<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    delta: [R; D],
    correct: &mut impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
    evaluations: &mut u32,
) -> bool {
    *evaluations += 1;
    let far = equation.reach().less(length(&correct(equation, [R::ZERO; D], equation.q).delta));
    if !far.any() {
        return false;
    }
    *evaluations += 1;
    let half: [R; D] = by_component!(|i| R::from_f64(0.5) * delta[i]);
    let rest = equation.rest(half, correct(equation, half, equation.end(half)).parts[0]);
    let along = (0..D).fold(R::ZERO, |sum, i| rest[i].mul_add(delta[i], sum));
    far.and(along.less(R::ZERO)).any()
}
