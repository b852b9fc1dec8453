//! Where forces cancel: a root is known as well as they are.

use dmech_scalar::{Count, Mask, Real};

use super::scatter::{Left, PATIENCE};
use super::settle::length;
use super::{Correction, Equation, Increment};
use crate::vector::by_component;

/// Corrections after which it matters whether a position shows them.
const SEEN: usize = 3;

/// Where a correction was made, and what was left there.
#[derive(Clone, Copy)]
struct Iterate<const D: usize, R: Real> {
    delta: [R; D],
    left: [R; D],
    made: Correction<D, R>,
}

/// The root, if corrections from the guess, so many at the most, lead to where nothing is left but [rounding](Left::is_rounding).
pub(super) fn root<const ONCE_ROUNDED: bool, const D: usize, R: Real>(
    equation: &Equation<D, R>,
    corrections: u32,
    correct: &mut impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Option<Increment<D, R>> {
    let mut evaluations = 0;
    let mut at = |delta: [R; D]| {
        evaluations += 1;
        let made = correct(equation, delta, equation.end(delta));
        Iterate { delta, left: equation.rest(delta, made.parts[0]), made }
    };
    let most = PATIENCE.min(corrections as usize);
    let (mut all, mut many) = ([at(equation.guess); PATIENCE], 1);
    while many < most {
        let last = all[many - 1];
        let next = at(by_component!(|i| last.delta[i] + last.made.delta[i]));
        if !length(&next.left).less(length(&last.left)).all() {
            break;
        }
        all[many] = next;
        many += 1;
    }
    let last = all[many - 1];
    // Both are zero at the root; of two forms of one formula the other may have hit upon next to nothing.
    let of_correction = length(&last.left).less(length(&last.made.delta)).all();
    let left = |there: &Iterate<D, R>| if of_correction { there.made.delta } else { there.left };
    let lengths = all.each_ref().map(|there| length(&left(there)).to_f64());
    let reach = (length(&equation.q) + length(&last.delta)).to_f64();
    let of_equation = Left { lengths: &lengths[..many], reach, epsilon: R::EPSILON.to_f64() };
    // Of a correction that no position shows the force tells nothing, and so they shrink slowly.
    let unseen = many > SEEN && length(&all[many - 2].made.delta).less_or_equal(R::EPSILON * length(&equation.q)).all();
    let is_root = unseen
        || of_equation.is_rounding(|k, s| {
            let was = left(&all[k]);
            let there = left(&at(by_component!(|i| R::from_f64(s).mul_add(was[i], last.delta[i]))));
            let along = |i: usize| if was[i].less(R::ZERO).all() { -there[i] } else { there[i] };
            (0..D).fold(R::ZERO, |sum, i| sum + along(i)).to_f64()
        });
    let Correction { gradient, parts, continued, definite, .. } = last.made;
    let continued = if equation.definite { definite } else { continued }.all();
    (is_root && continued).then(|| {
        let delta = if ONCE_ROUNDED { equation.increment_and_rest(gradient).0 } else { equation.increment(gradient) };
        let made = Count::of(evaluations);
        Increment { delta, gradient, parts, evaluations: made, iterations: made }
    })
}
