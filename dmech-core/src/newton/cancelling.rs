//! Where forces cancel: a root is known as well as they are.

use dmech_scalar::{Count, Mask, Real};

use super::resolution::{Last, PATIENCE, shorter};
use super::settle::{Astray, length};
use super::{Correction, Equation, Increment};
use crate::vector::{by_component, difference};

/// So much more of what is left shows its correction alone.
const MORE: f64 = 1e30;

/// Where a correction was made, and what was left there.
#[derive(Clone, Copy)]
struct Iterate<const D: usize, R: Real> {
    delta: [R; D],
    left: [R; D],
    made: Correction<D, R>,
}

/// The root, if corrections from the guess lead to where nothing is left but [rounding](Last::is_rounding).
pub(super) fn root<const ONCE_ROUNDED: bool, const D: usize, R: Real>(
    equation: &Equation<D, R>,
    astray: Astray,
    correct: &mut impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
) -> Option<Increment<D, R>> {
    let corrections = equation.max_iterations.saturating_sub(astray.evaluations);
    if corrections == 0 {
        return None;
    }
    let mut evaluations = 0;
    let mut ask = |equation: &Equation<D, R>, delta: [R; D]| {
        evaluations += 1;
        let made = correct(equation, delta, equation.end(delta));
        Iterate { delta, left: equation.rest(delta, made.parts[0]), made }
    };
    let mut last = ask(equation, equation.guess);
    let mut before = last.left;
    for _ in 1..PATIENCE.min(corrections as usize) {
        let next = ask(equation, by_component!(|i| last.delta[i] + last.made.delta[i]));
        if !length(&next.left).less(length(&last.left)).all() {
            break;
        }
        (before, last) = (last.left, next);
    }
    // Of two forms of what is left one may have hit upon nothing: with much more of it, and (1 + g J) δ is what there is more.
    let Iterate { delta, left, made } = last;
    let nothing = length(&left).equal(R::ZERO).all();
    let left = if nothing { before } else { left };
    let times = R::from_f64(MORE).max(length(&left).recip());
    let more = left.map(|x| times * x);
    let asked = Equation { frozen: difference(equation.frozen, more), ..*equation };
    let solved = ask(&asked, delta).made.delta;
    let change = by_component!(|i| (solved[i] - made.delta[i]) / times);
    let shorter = if nothing { R::from_f64(shorter(length(&change).to_f64(), astray.residual)) } else { R::ONE };
    let [left, change] = [left, change].map(|x| x.map(|x| shorter * x));
    let (slope, foreseen) = (made.parts[0], difference(left, change));
    let reach = length(&equation.q) + length(&delta);
    let last =
        Last { length: length(&change).to_f64(), astray: astray.residual, rounding: (R::EPSILON * reach).to_f64() };
    let is_root = length(&left).equal(R::ZERO).all()
        || last.is_rounding(|s| {
            let s = R::from_f64(s);
            let there = ask(equation, by_component!(|i| s.mul_add(change[i], delta[i]))).made.parts[0];
            let off = by_component!(|i| equation.g * (there[i] - slope[i]) / s - foreseen[i]);
            (length(&off) / length(&foreseen)).to_f64()
        });
    let continued = if equation.definite { made.definite } else { made.continued }.all();
    (is_root && continued).then(|| {
        let delta = if ONCE_ROUNDED { equation.increment_and_rest(slope).0 } else { equation.increment(slope) };
        let made = Count::of(evaluations);
        Increment { delta, gradient: slope, parts: [slope, [R::ZERO; D]], evaluations: made, iterations: made }
    })
}
