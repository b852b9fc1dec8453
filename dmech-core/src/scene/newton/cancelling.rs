//! Where forces cancel: a root is known as well as they are.

use super::{Part, Solver, Unknown};
use crate::newton::NotConverged;
use crate::newton::scatter::{Left, PATIENCE};
use crate::scene::vectors::Vectors;

/// Where a correction was made, what was left there, and the correction.
struct Iterate<const D: usize> {
    delta: Vectors<D>,
    left: Vectors<D>,
    correction: Vectors<D>,
}

fn length<const D: usize>(x: &Vectors<D>) -> f64 {
    x.flat().iter().map(|x| x.abs()).sum()
}

impl<const D: usize> Solver<D> {
    /// Goes to the root of the whole step if corrections from the guess lead to where nothing is left but [rounding](Left::is_rounding); how many
    /// evaluations it took then.
    #[cold]
    pub(super) fn cancels<U: Unknown<D>>(&mut self, step: Part<'_, U, D>, astray: NotConverged) -> Option<u32> {
        let mut evaluations = astray.iterations as u32;
        let most = PATIENCE.min(step.equation.newton.limit().saturating_sub(evaluations) as usize);
        self.guess(step.equation);
        let (mut all, mut lengths): (Vec<Iterate<D>>, Vec<f64>) = Default::default();
        while all.len() < most {
            evaluations += 1;
            self.take_gradient(step);
            if !self.take_jacobian(step) {
                return None;
            }
            self.residual(step);
            let (delta, left) = (self.delta.clone(), self.place.clone());
            let shrinks = lengths.last().is_none_or(|&last| length(&left) < last);
            if !shrinks {
                break;
            }
            self.solve_linear(step);
            self.correct();
            lengths.push(length(&left));
            all.push(Iterate { delta, left, correction: self.place.clone() });
        }
        let last = all.last()?;
        let reach = length(step.equation.q) + length(&last.delta);
        let left = Left { lengths: &lengths, reach, epsilon: f64::EPSILON };
        let is_root = left.is_rounding(|k, s| {
            evaluations += 1;
            let left = &all[k].left;
            let starts = last.delta.flat().iter().zip(left.flat());
            self.delta.flat_mut().iter_mut().zip(starts).for_each(|(to, (delta, left))| *to = s * left + delta);
            self.take_gradient(step);
            self.residual(step);
            let pairs = self.place.flat().iter().zip(left.flat());
            pairs.map(|(there, left)| if *left < 0.0 { -there } else { *there }).sum()
        });
        if !is_root {
            return None;
        }
        self.delta.clone_from(&last.delta);
        self.take_gradient(step);
        self.take_jacobian(step);
        self.place.clone_from(&last.correction);
        self.turn::<U>();
        self.correct();
        self.continued(step, evaluations + 1).ok()
    }
}
