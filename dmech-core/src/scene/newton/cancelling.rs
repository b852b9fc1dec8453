//! Where forces cancel: a root is known as well as they are.

use super::{Part, Solver, Unknown};
use crate::newton::NotConverged;
use crate::newton::cancelling::{Lost, root};
use crate::scene::vectors::Vectors;
use crate::system::Effort;

impl<const D: usize> Solver<D> {
    /// Goes to the [`root`] of the whole step that is known as well as forces that cancel, and says what it took then, with what was
    /// lost before.
    #[cold]
    pub(super) fn cancels<U: Unknown<D>>(
        &mut self,
        step: Part<'_, U, D>,
        astray: NotConverged,
        lost: NotConverged,
    ) -> Option<Effort> {
        // From a guess far off the first correction is long whatever the force.
        let shortest = astray.residual.min(lost.residual);
        let corrections = step.equation.newton.limit().saturating_sub(astray.iterations as u32);
        self.guess::<U>(step.equation);
        let (guess, here) = (self.delta.clone(), self.gradient.clone());
        let mut ended = LostScene { solver: self, step, here, evaluations: 0 };
        let delta = root(&mut ended, guess, corrections, shortest)?;
        let LostScene { here, evaluations, .. } = ended;
        (self.delta, self.gradient) = (delta, here);
        self.rest.clear();
        let iterations =
            self.continued(step, u64::max(astray.iterations, lost.iterations) as u32 + evaluations).ok()?;
        Some(Effort { evaluations: iterations, iterations })
    }
}

/// The equation of a scene.
struct LostScene<'a, U, const D: usize> {
    solver: &'a mut Solver<D>,
    step: Part<'a, U, D>,
    /// G where it was last taken with its Jacobian.
    here: Vectors<D>,
    evaluations: u32,
}

impl<U: Unknown<D>, const D: usize> LostScene<'_, U, D> {
    fn take_gradient(&mut self, delta: &Vectors<D>) {
        self.evaluations += 1;
        self.solver.delta.clone_from(delta);
        self.solver.take_gradient(self.step);
    }
}

impl<U: Unknown<D>, const D: usize> Lost for LostScene<'_, U, D> {
    type Vector = Vectors<D>;

    fn left(&mut self, delta: &Vectors<D>) -> Option<Vectors<D>> {
        self.take_gradient(delta);
        self.here.clone_from(&self.solver.gradient);
        if !self.solver.take_jacobian(self.step) {
            return None;
        }
        self.solver.residual(self.step);
        Some(self.solver.place.clone())
    }

    fn solve(&mut self, left: &Vectors<D>) -> Vectors<D> {
        self.solver.place.clone_from(left);
        self.solver.solve_linear(self.step);
        self.solver.place.clone()
    }

    fn pull(&mut self, delta: &Vectors<D>) -> Vectors<D> {
        self.take_gradient(delta);
        let mut pull = self.solver.gradient.clone();
        let known = self.here.flat().iter().zip(self.step.equation.g.flat());
        pull.flat_mut().iter_mut().zip(known).for_each(|(pull, (here, g))| *pull = g * (*pull - here));
        pull
    }

    fn rounding(&self, delta: &Vectors<D>) -> f64 {
        f64::EPSILON * (Self::length(self.step.equation.q) + Self::length(delta))
    }

    fn length(x: &Vectors<D>) -> f64 {
        x.flat().iter().map(|x| x.abs()).sum()
    }

    fn sum(x: &Vectors<D>, c: f64, y: &Vectors<D>) -> Vectors<D> {
        let mut sum = x.clone();
        sum.flat_mut().iter_mut().zip(y.flat()).for_each(|(x, y)| *x += c * y);
        sum
    }
}
