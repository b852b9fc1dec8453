//! Where forces cancel: a root is known as well as they are.

use super::{Part, Solver, Unknown};
use crate::newton::NotConverged;
use crate::newton::resolution::{Last, PATIENCE, shorter};
use crate::scene::vectors::Vectors;
use crate::system::Effort;

/// Where corrections no longer shrink.
struct Ended<const D: usize> {
    delta: Vectors<D>,
    /// What is left there, or where that is nothing, before.
    left: Vectors<D>,
    nothing: bool,
}

fn length<const D: usize>(x: &Vectors<D>) -> f64 {
    x.flat().iter().map(|x| x.abs()).sum()
}

impl<const D: usize> Solver<D> {
    /// Goes to the root of the whole step if corrections from the guess lead to where nothing is left but [rounding](Last::is_rounding), and
    /// says what it took then, with what was lost before.
    #[cold]
    pub(super) fn cancels<U: Unknown<D>>(
        &mut self,
        step: Part<'_, U, D>,
        astray: NotConverged,
        lost: NotConverged,
    ) -> Option<Effort> {
        let mut evaluations = u64::max(astray.iterations, lost.iterations) as u32;
        let corrections = step.equation.newton.limit().saturating_sub(astray.iterations as u32);
        let Ended { delta, mut left, nothing } = self.ends(step, corrections, &mut evaluations)?;
        // From a guess far off the first correction is long whatever the force.
        let astray = astray.residual.min(lost.residual);
        self.delta.clone_from(&delta);
        self.take_gradient(step);
        if !self.take_jacobian(step) {
            return None;
        }
        let here = self.gradient.clone();
        // (1 + g J) δ is what is left.
        self.place.clone_from(&left);
        self.solve_linear(step);
        let mut change = self.place.clone();
        if nothing {
            let shorter = shorter(length(&change), astray);
            left.flat_mut().iter_mut().chain(change.flat_mut()).for_each(|x| *x *= shorter);
        }
        let foreseen: Vec<f64> = left.flat().iter().zip(change.flat()).map(|(left, change)| left - change).collect();
        let reach = length(step.equation.q) + length(&delta);
        let last = Last { length: length(&change), astray, rounding: f64::EPSILON * reach };
        let is_root = length(&left) == 0.0
            || last.is_rounding(|s| {
                evaluations += 1;
                let starts = delta.flat().iter().zip(change.flat());
                self.delta.flat_mut().iter_mut().zip(starts).for_each(|(to, (delta, change))| *to = s * change + delta);
                self.take_gradient(step);
                let pairs = self.gradient.flat().iter().zip(here.flat()).zip(step.equation.g.flat());
                let changes = pairs.map(|((there, here), g)| g * (there - here) / s);
                let off: f64 = changes.zip(&foreseen).map(|(change, foreseen)| (change - foreseen).abs()).sum();
                off / foreseen.iter().map(|x| x.abs()).sum::<f64>()
            });
        if !is_root {
            return None;
        }
        self.delta = delta;
        self.gradient = here;
        self.rest.clear();
        let iterations = self.continued(step, evaluations).ok()?;
        Some(Effort { evaluations: iterations, iterations })
    }

    /// So many corrections from the guess at the most; each is counted.
    fn ends<U: Unknown<D>>(
        &mut self,
        step: Part<'_, U, D>,
        corrections: u32,
        evaluations: &mut u32,
    ) -> Option<Ended<D>> {
        self.guess(step.equation);
        let mut last: Option<Ended<D>> = None;
        for _ in 0..PATIENCE.min(corrections as usize) {
            *evaluations += 1;
            self.take_gradient(step);
            if !self.take_jacobian(step) {
                return None;
            }
            self.residual(step);
            let mut left = self.place.clone();
            let shrinks = last.as_ref().is_none_or(|last| length(&left) < length(&last.left));
            if !shrinks {
                break;
            }
            let nothing = length(&left) == 0.0;
            if let Some(before) = last.filter(|_| nothing) {
                left = before.left;
            }
            last = Some(Ended { delta: self.delta.clone(), left, nothing });
            if nothing {
                break;
            }
            self.solve_linear(step);
            self.correct();
        }
        last
    }
}
