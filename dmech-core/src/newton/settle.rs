//! Newton from a guess, and when it may stop.

use dmech_scalar::{Count, Mask, Real};

use super::settled::Settled;
use super::{Correction, Equation, Increment, NotConverged};
use crate::vector::{by_component, largest};

/// Corrections before the loop gives up on a starting point; quadratic convergence needs 3 to 6.
const PATIENCE: u32 = 12;

/// So many roundings may be in a correction.
const ROUNDINGS: f64 = 64.0;

/// Newton's iteration has left the neighbourhood of the guess.
#[derive(Clone, Copy, Debug)]
pub(super) struct Astray {
    /// Evaluations that it took.
    pub(super) evaluations: u32,
    /// Largest component of the last correction.
    pub(super) residual: f64,
    /// It has found a root, which does not continue that of a shorter step.
    pub(super) elsewhere: bool,
}

impl From<Astray> for NotConverged {
    fn from(astray: Astray) -> Self {
        let Astray { evaluations, residual, elsewhere } = astray;
        if elsewhere {
            return NotConverged::NOT_CONTINUED;
        }
        NotConverged { iterations: evaluations.into(), residual }
    }
}

/// Newton from the equation's guess, given up as soon as it leaves the neighbourhood of the guess.
///
/// What must be right to round-off is the force: for a short step Δ is known to an ulp long before G = (known − Δ)/g is.
/// With |δₖ₊₁| ≈ K |δₖ|² the error that remains in Δ after δₖ is K |δₖ|², and that of G is the same over g. K comes from
/// the last two corrections. Before there are two, the force is taken to vary over lengths no shorter than the step, so
/// that G + J δ is off by |G| (|δ|/|Δ|)² at most.
///
/// A piecewise force may bend between one iterate and the next, so that neither estimate holds: there the last correction
/// itself must be below rounding.
///
/// In a steep wall G may be 10²⁰ times what it is at the root. Then G + J δ cancels, and the Δ that is formed of it is rounding;
/// what tells is that it is not the last one plus δ.
///
/// The guess is left behind when the first correction is larger than the whole step, or when corrections do not halve
/// (the affine-invariant monotonicity test; P. Deuflhard, Newton Methods for Nonlinear Problems, §3.2).
#[inline]
pub(super) fn settle<const ONCE_ROUNDED: bool, const D: usize, R: Real>(
    equation: &Equation<D, R>,
    correct: &mut impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Result<Increment<D, R>, Astray> {
    // Below rounding, and by a margin: an error of half an ulp that always has the same sign is a drift.
    let margin = R::from_f64(1.0 / 64.0) * R::EPSILON;
    // No squares of lengths below: in units in which the motion measures 10⁻¹⁵⁰ or 10¹⁵⁰ they are 0 or infinite, and
    // whatever is compared with them seems settled.
    let root_of_margin = R::from_f64(0.125 * R::EPSILON.to_f64().sqrt());
    let half = R::from_f64(0.5);
    // What a correction may be by rounding alone, however small all numbers are: a motion that dies away comes to rest.
    let grains = R::from_f64(ROUNDINGS) * grain::<R>();
    let roundings = R::from_f64(ROUNDINGS) * R::EPSILON;
    // Whether `x` is rounding of such numbers. A force that is below the smallest number is not known, and Δ is not by g times that.
    // As a quotient: a product with the smallest number would be made before every step, and takes longer than the step.
    let is_rounding =
        |x: R, numbers: R| ((x - roundings * numbers) / (R::ONE + equation.g.abs())).less_or_equal(grains);
    let mut delta = equation.guess;
    let mut last = R::ZERO;
    let mut all = Settled::<D, R>::none();
    let patience = if equation.piecewise { 3 * PATIENCE } else { PATIENCE }.min(equation.max_iterations);
    for iteration in 1..=patience {
        let Correction { delta: change, gradient, parts, continued, definite } =
            correct(equation, delta, equation.end(delta));
        let continued = if equation.definite { definite } else { continued };
        let before = delta;
        delta = if ONCE_ROUNDED { equation.increment_and_rest(gradient).0 } else { equation.increment(gradient) };
        let size = length(&change);
        let step = length(&delta);
        let mut settled;
        let astray;
        if iteration == 1 {
            let small = if equation.piecewise { margin } else { root_of_margin };
            settled = size.less_or_equal(small * step);
            let within = size.less_or_equal(equation.reach() + length(&equation.guess) + grains);
            // From Δ = 0 it is the whole step, of which h v is nothing where a stiff body is let go: what the force at the start drives.
            let by_force = || definite.and(size.less_or_equal(equation.g.abs() * length(&parts[0]) + grains));
            astray = if equation.definite { within.or(by_force()).not() } else { within.not() };
        } else {
            let pull = equation.g.abs() * length(&gradient);
            let halved = size.less_or_equal(half * last);
            let rate = if equation.piecewise { R::ONE } else { size / last };
            settled = (size * rate * rate).less_or_equal(margin * pull);
            if !all.or(settled).all() {
                // What no longer shrinks is the rounding of b and of the known side.
                let numbers = step + length(&equation.q) + length(&equation.drift);
                let at_rest = halved.not().and(is_rounding(size, numbers));
                settled = settled.or(size.equal(R::ZERO)).or(at_rest);
            }
            // Past a seam the slope is another, and a correction may be longer than the last for once.
            astray = if equation.piecewise { size.less_or_equal(last + last).not() } else { halved.not() };
        }
        let mut elsewhere = false;
        if settled.any() {
            let apart = length(&by_component!(|i| (delta[i] - before[i]) - change[i]));
            let mut agree = apart.less_or_equal(roundings * step);
            if !all.or(agree.and(continued)).all() {
                // Where the rounding of the force at the start is more than all that moves, nothing is known of Δ.
                let (frozen, moves) = (length(&equation.frozen), step + length(&equation.drift));
                agree = is_rounding(apart, moves + frozen).and((roundings * frozen).less_or_equal(moves));
                elsewhere = !all.or(settled.and(agree).not().or(continued)).all();
            }
            settled = settled.and(agree);
        }
        let settled = all.or(settled);
        let made = Count::of(iteration);
        let next = Increment { delta, gradient, parts, evaluations: made, iterations: made };
        if elsewhere || astray.and(settled.not()).any() {
            return Err(Astray { evaluations: iteration, residual: largest(&change), elsewhere });
        }
        if let Some(found) = all.add(settled, next) {
            return Ok(found);
        }
        last = size;
    }
    Err(Astray { evaluations: patience, residual: last.to_f64(), elsewhere: false })
}

/// The smallest number above 0, by which the smallest differ.
#[inline(always)]
fn grain<R: Real>() -> R {
    let (least, of_half_the_digits) = (R::from_f64(f64::from_bits(1)), R::from_f64(f32::from_bits(1).into()));
    R::either(least.equal(R::ZERO), of_half_the_digits, least)
}

/// Σ|xᵢ|: unlike a maximum it does not lose a NaN.
#[inline]
pub(super) fn length<const D: usize, R: Real>(x: &[R; D]) -> R {
    x.iter().fold(R::ZERO, |sum, x| sum + x.abs())
}
