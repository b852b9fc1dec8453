//! Where forces cancel: a root is known as well as they are.

use dmech_scalar::Real;

use super::resolution::{Last, PATIENCE, shorter};
use super::settle::length;
use super::{Correction, Equation};
use crate::vector::{add_scaled, by_component, difference};

/// An equation Δ + g G(q + Δ) = drift − frozen, of one body or of many, whose corrections end before it is solved.
pub(crate) trait Lost {
    /// A number for each coordinate.
    type Vector: Clone;

    /// Takes G and its Jacobian J at Δ, and says what is left of the equation there; nothing where no correction can be made.
    fn left(&mut self, delta: &Self::Vector) -> Option<Self::Vector>;
    /// δ with (1 + g J) δ = `left`.
    fn solve(&mut self, left: &Self::Vector) -> Self::Vector;
    /// The same with what is left itself.
    fn correction(&mut self, left: &Self::Vector) -> Self::Vector {
        self.solve(left)
    }
    /// g (G(q + Δ) − G), with G where it was last taken with its Jacobian.
    fn pull(&mut self, delta: &Self::Vector) -> Self::Vector;
    /// That of q + Δ.
    fn rounding(&self, delta: &Self::Vector) -> f64;

    /// Σ |xᵢ|.
    fn length(x: &Self::Vector) -> f64;
    /// x + c y.
    fn sum(x: &Self::Vector, c: f64, y: &Self::Vector) -> Self::Vector;
}

/// Where so many corrections of Δ lead, if nothing is left there but [rounding](Last::is_rounding); G is last taken with its Jacobian there.
///
/// `astray` is the length of a correction that led no nearer.
pub(crate) fn root<E: Lost>(
    equation: &mut E,
    mut delta: E::Vector,
    corrections: u32,
    astray: f64,
) -> Option<E::Vector> {
    if corrections == 0 {
        return None;
    }
    let mut left = equation.left(&delta)?;
    let mut size = E::length(&left);
    for _ in 1..PATIENCE.min(corrections as usize) {
        let next = E::sum(&delta, 1.0, &equation.correction(&left));
        let there = equation.left(&next)?;
        let shrinks = E::length(&there) < size;
        if !shrinks {
            break;
        }
        (delta, size) = (next, E::length(&there));
        // Of two forms of what is left one may have hit upon nothing: then what was left before tells how G changes.
        if size == 0.0 {
            break;
        }
        left = there;
    }
    equation.left(&delta)?;
    let change = equation.solve(&left);
    let foreseen = E::sum(&left, -1.0, &change);
    let part = if size == 0.0 { shorter(E::length(&change), astray) } else { 1.0 };
    let last = Last { length: part * E::length(&change), astray, rounding: equation.rounding(&delta) };
    let is_root = E::length(&left) == 0.0
        || last.is_rounding(|s| {
            let s = part * s;
            let pull = equation.pull(&E::sum(&delta, s, &change));
            E::length(&E::sum(&foreseen, -s.recip(), &pull)) / E::length(&foreseen)
        });
    is_root.then_some(delta)
}

/// So much more of what is left shows its correction alone.
const MORE: f64 = 1e30;

/// The equation of a law.
pub(super) struct LostBody<'a, C, const D: usize, R: Real> {
    equation: &'a Equation<D, R>,
    correct: C,
    /// Where the last correction was made.
    delta: [R; D],
    /// The same, with G there.
    pub(super) made: Correction<D, R>,
    pub(super) evaluations: u32,
}

impl<'a, C, const D: usize, R: Real> LostBody<'a, C, D, R>
where
    C: FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
{
    pub(super) fn new(equation: &'a Equation<D, R>, correct: C) -> Self {
        let zero = [R::ZERO; D];
        LostBody { equation, correct, delta: zero, made: Correction::rounded(zero, zero, zero), evaluations: 0 }
    }

    fn correct(&mut self, equation: &Equation<D, R>, delta: [R; D]) -> Correction<D, R> {
        self.evaluations += 1;
        (self.correct)(equation, delta, equation.end(delta))
    }
}

impl<C, const D: usize, R: Real> Lost for LostBody<'_, C, D, R>
where
    C: FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
{
    type Vector = [R; D];

    fn left(&mut self, &delta: &[R; D]) -> Option<[R; D]> {
        self.made = self.correct(self.equation, delta);
        self.delta = delta;
        Some(self.equation.rest(delta, self.made.parts[0]))
    }

    /// With much more of what is left: the correction made of that is what there is more.
    fn solve(&mut self, left: &[R; D]) -> [R; D] {
        let times = R::from_f64(MORE).max(length(left).recip());
        let more = left.map(|x| times * x);
        let asked = Equation { frozen: difference(self.equation.frozen, more), ..*self.equation };
        let solved = self.correct(&asked, self.delta).delta;
        by_component!(|i| (solved[i] - self.made.delta[i]) / times)
    }

    fn correction(&mut self, _: &[R; D]) -> [R; D] {
        self.made.delta
    }

    fn pull(&mut self, &delta: &[R; D]) -> [R; D] {
        let there = self.correct(self.equation, delta).parts[0];
        by_component!(|i| self.equation.g * (there[i] - self.made.parts[0][i]))
    }

    fn rounding(&self, &delta: &[R; D]) -> f64 {
        (R::EPSILON * (length(&self.equation.q) + length(&delta))).to_f64()
    }

    fn length(x: &[R; D]) -> f64 {
        length(x).to_f64()
    }

    fn sum(&x: &[R; D], c: f64, &y: &[R; D]) -> [R; D] {
        add_scaled(x, R::from_f64(c), y)
    }
}
