//! What corrections have led to: a root to rounding, and one that continues that of a shorter step.

use super::{Part, Solver, Unknown};
use crate::newton::NotConverged;

/// A residual of so many units in the last place of the parts of the equation is rounding.
const ROUNDINGS: f64 = 4.0;

/// A last correction that is this part of the position, or less, may be rounding.
const NEAR: f64 = 1e-6;

impl<const D: usize> Solver<D> {
    /// Where corrections no longer shrink: one more, with a Jacobian of its own. It is the last if what it corrects is
    /// nothing but rounding; if not, they lead nowhere, as `astray` says.
    #[cold]
    pub(super) fn finish<U: Unknown<D>>(
        &mut self,
        part: Part<'_, U, D>,
        astray: NotConverged,
    ) -> Result<u32, NotConverged> {
        let Part { equation, .. } = part;
        let near = astray.residual <= NEAR * (equation.q.largest() + self.delta.largest());
        if !near {
            return Err(astray);
        }
        self.take_gradient(part);
        if !self.take_jacobian(part) {
            return Err(astray);
        }
        self.residual(part);
        let rounding = self.residual_is_rounding(part);
        self.solve_linear(part);
        self.turn::<U>();
        let [size, _] = self.correct();
        if rounding && size.is_finite() { self.continued(part, astray.iterations as u32 + 1) } else { Err(astray) }
    }

    /// The root found after so many corrections, if 1 + g J there may be that of a root which continues that of a shorter step.
    ///
    /// The factors in use are of a place before the last corrections. Those have shrunk, so that they are factors of a matrix with
    /// a determinant of the same sign; but J may jump in between, and before a root is refused J is taken where it is.
    pub(super) fn continued<U: Unknown<D>>(
        &mut self,
        part: Part<'_, U, D>,
        iterations: u32,
    ) -> Result<u32, NotConverged> {
        if U::LINEAR || self.matrix.is_positive() || self.matrix_continues(part) {
            return Ok(iterations);
        }
        self.continued_from_here(part).then_some(iterations).ok_or(NotConverged::NOT_CONTINUED)
    }

    /// The same, with J at the root.
    #[cold]
    pub(super) fn continued_from_here<U: Unknown<D>>(&mut self, part: Part<'_, U, D>) -> bool {
        self.place::<U>(part.equation);
        self.take_jacobian(part) && self.matrix_continues(part)
    }

    fn matrix_continues<U>(&mut self, Part { equation, theta, .. }: Part<'_, U, D>) -> bool {
        let g = if theta == 1.0 { equation.g } else { &self.scaled };
        self.matrix.continues(g)
    }

    /// Whether the residual is what rounding makes of the equation, for every coordinate: of h v, of the forces, of Δ, and,
    /// as forces are those of rounded positions and cancel one another, of J times the positions.
    fn residual_is_rounding<U>(&mut self, Part { equation, theta, .. }: Part<'_, U, D>) -> bool {
        let reach = equation.q.largest() + self.delta.largest() + equation.h.abs() * equation.v.largest();
        // Until the correction is made it is of no use.
        let stiffness = &mut self.rest;
        stiffness.clear();
        self.matrix.add_row_sums(stiffness);
        self.place.flat().iter().enumerate().all(|(i, residual)| {
            let known = equation.known.map_or(0.0, |known| known.flat()[i].abs());
            let force = self.gradient.flat()[i].abs() + known + stiffness.flat()[i] * reach;
            let parts = theta * equation.drift(i).abs() + self.delta.flat()[i].abs();
            residual.abs() <= ROUNDINGS * f64::EPSILON * (theta * theta * equation.g.flat()[i].abs() * force + parts)
        })
    }
}
