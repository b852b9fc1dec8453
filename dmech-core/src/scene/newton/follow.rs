//! Where the guess is not good enough: lengthen the step gradually.

use super::{Equations, Part, Solver, Trial, Unknown};
use crate::newton::NotConverged;
use crate::newton::path::Path;
use crate::system::Effort;

impl<const D: usize> Solver<D> {
    /// Follows the root from a step of length 0 to the whole step, by progress in θ of no more than `longest`.
    #[cold]
    pub(super) fn lengthen<U: Unknown<D>>(
        &mut self,
        step: Part<'_, U, D>,
        astray: NotConverged,
        longest: f64,
    ) -> Result<Effort, NotConverged> {
        let Part { equation, .. } = step;
        let mut evaluations = astray.iterations as u32 + 1;
        self.delta.clear();
        self.take_gradient(step.of(0.0));
        self.first.clone_from(&self.gradient);
        self.slope.clear();
        let (mut path, mut ending) = (Path::by(longest), astray);
        while let Some(stretch) = path.next().filter(|_| evaluations < equation.newton.limit()) {
            let (theta, all) = (stretch.end, stretch.is_all());
            if all {
                self.delta.clear();
            } else {
                self.predict(equation, theta, stretch.ahead);
            }
            let settled = self.settle(step.of(theta), if all { Trial::AT_REST } else { Trial::FOLLOWED });
            let doubted =
                all && settled.is_ok() && (!self.matrix.is_positive() || self.passes_a_root(step, &mut evaluations));
            match if doubted { Err(NotConverged::NOT_CONTINUED) } else { settled } {
                Ok(iterations) => {
                    evaluations += iterations;
                    if stretch.is_last() {
                        return Ok(Effort { evaluations, iterations: evaluations });
                    }
                    for i in 0..self.delta.flat().len() {
                        self.slope.flat_mut()[i] = (self.gradient.flat()[i] - self.first.flat()[i]) / stretch.ahead;
                    }
                    self.first.clone_from(&self.gradient);
                    path.reaches(stretch);
                }
                Err(astray) => {
                    evaluations += u32::max(astray.iterations as u32, 1);
                    ending = astray;
                    path.shortens();
                }
            }
        }
        if [astray, ending].contains(&NotConverged::NOT_CONTINUED) {
            return Err(NotConverged::NOT_CONTINUED);
        }
        Err(NotConverged { iterations: evaluations.into(), residual: ending.residual })
    }

    /// Whether the root of the whole step, farther than h v goes, is another than that of a shorter one: the step begins on a hill, or half
    /// way to the root the residual drives back, so that there is one before it.
    fn passes_a_root<U: Unknown<D>>(&mut self, step: Part<'_, U, D>, evaluations: &mut u32) -> bool {
        let Equations { g, .. } = *step.equation;
        let [mut far, mut known] = [0.0; 2];
        for (i, delta) in self.delta.flat().iter().enumerate() {
            far += delta.abs();
            known += step.equation.drift(i).abs();
        }
        if far <= known {
            return false;
        }
        *evaluations += 2;
        let found = [&self.delta, &self.gradient, &self.rest].map(Clone::clone);
        self.delta.clear();
        self.take_gradient(step);
        let on_a_hill = !(self.take_jacobian(step) && self.matrix.is_positive());
        self.delta.flat_mut().iter_mut().zip(found[0].flat()).for_each(|(half, delta)| *half = 0.5 * delta);
        self.take_gradient(step);
        self.residual(step);
        let rests = self.place.flat().iter().zip(self.delta.flat()).zip(g.flat());
        // A pinned body has g = 0.
        let along: f64 = rests.filter(|(_, g)| **g > 0.0).map(|((rest, delta), g)| rest * delta / g).sum();
        [self.delta, self.gradient, self.rest] = found;
        on_a_hill || along < 0.0
    }

    /// Δ for a part θ of the step, with the force continued over the last `ahead` of it by its slope.
    fn predict(&mut self, equation: &Equations<'_, D>, theta: f64, ahead: f64) {
        for i in 0..self.delta.flat().len() {
            let known = equation.known.map_or(0.0, |known| known.flat()[i]);
            let force = known + ahead * self.slope.flat()[i] + self.first.flat()[i];
            self.delta.flat_mut()[i] = theta * equation.drift(i) - theta * theta * equation.g.flat()[i] * force;
        }
    }
}
