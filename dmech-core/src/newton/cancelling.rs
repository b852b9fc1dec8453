//! Where forces cancel: a root is known as well as they are.

use dmech_scalar::{Count, Mask, Real};

use super::scatter::{SPACINGS, is_rounding};
use super::settle::length;
use super::{Correction, Equation, Increment};
use crate::vector::by_component;

/// Corrections to where they no longer shrink.
const PATIENCE: usize = 8;

/// Where a correction was made, and what was left there.
#[derive(Clone, Copy)]
struct Iterate<const D: usize, R: Real> {
    delta: [R; D],
    left: [R; D],
    made: Correction<D, R>,
}

/// The root, if corrections from the guess lead to where nothing is left but [rounding](is_rounding); how many evaluations it took in any
/// case.
pub(super) fn root<const ONCE_ROUNDED: bool, const D: usize, R: Real>(
    equation: &Equation<D, R>,
    correct: &mut impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> (Option<Increment<D, R>>, u32) {
    let mut evaluations = 0;
    let mut at = |delta: [R; D]| {
        evaluations += 1;
        let made = correct(equation, delta, equation.end(delta));
        Iterate { delta, left: equation.rest(delta, made.parts[0]), made }
    };
    let (mut all, mut many) = ([at(equation.guess); PATIENCE], 1);
    while many < PATIENCE {
        let last = all[many - 1];
        let next = at(by_component!(|i| last.delta[i] + last.made.delta[i]));
        if !length(&next.left).less(length(&last.left)).all() {
            break;
        }
        all[many] = next;
        many += 1;
    }
    let last = all[many - 1];
    let left = all.map(|Iterate { left, .. }| length(&left).to_f64());
    let is_root = is_rounding(&left[..many], &SPACINGS, R::EPSILON.to_f64(), |k, s| {
        let left = all[k].left;
        let there = at(by_component!(|i| R::from_f64(s).mul_add(left[i], last.delta[i]))).left;
        let along = |i: usize| if left[i].less(R::ZERO).all() { -there[i] } else { there[i] };
        (0..D).fold(R::ZERO, |sum, i| sum + along(i)).to_f64()
    });
    let Correction { gradient, parts, continued, definite, .. } = last.made;
    let continued = if equation.definite { definite } else { continued }.all();
    let found = (is_root && continued).then(|| {
        let delta = if ONCE_ROUNDED { equation.increment_and_rest(gradient).0 } else { equation.increment(gradient) };
        let made = Count::of(evaluations);
        Increment { delta, gradient, parts, evaluations: made, iterations: made }
    });
    (found, evaluations)
}
