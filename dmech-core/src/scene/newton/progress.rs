//! Whether corrections have become small enough.

use super::{Equations, Unknown};
use crate::newton::NotConverged;

/// Of the force, what may be neglected. Below rounding by a margin, as neglected terms keep their sign and add up.
const MARGIN: f64 = f64::EPSILON / 64.0;

/// What a force may be off by rounding alone, however small all numbers are: a few of the smallest number above 0. Bodies that are
/// damped come to rest.
const GRAINS: f64 = f64::from_bits(4);
/// No mass lets a correction be larger than this by rounding alone.
const SMALL: f64 = 1e-200;

/// The size of the correction before.
#[derive(Clone, Copy, Debug)]
pub(super) struct Progress {
    last: f64,
}

impl Default for Progress {
    fn default() -> Self {
        Progress { last: f64::NAN }
    }
}

/// What follows from a correction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// The force is known to rounding.
    Settled,
    /// Another correction will do better.
    GoesOn,
    /// Another correction with the same Jacobian will hardly do better.
    Slow,
}

impl Progress {
    /// After the correction δ of Δ, with the largest |δ|, |Δ| and |g G|.
    ///
    /// What must be right is the force: after the correction δₖ that of G + J δₖ is off by about r |δₖ|/g, where r is the
    /// rate at which corrections shrink. Of the first, r is |δ|/|Δ|: the force is taken to vary over lengths no shorter than
    /// the step. Where it may bend or jump on the way, r is 1. A linear force is known after one correction, or two.
    ///
    /// # Errors
    /// The corrections are not finite, or lead away from the guess.
    pub(super) fn judge<U: Unknown<D>, const D: usize>(
        &mut self,
        equation: &Equations<'_, D>,
        iteration: u32,
        [size, step, force]: [f64; 3],
    ) -> Result<Verdict, NotConverged> {
        let finite = size.is_finite() && step.is_finite();
        // Δ is known to g times what the force is.
        let grains = || if size < SMALL { GRAINS + equation.g.largest() * GRAINS } else { 0.0 };
        if !finite || (!U::LINEAR && iteration == 1 && size > step + grains()) {
            return Err(NotConverged { iterations: iteration.into(), residual: size });
        }
        if U::LINEAR {
            // Where the energy is to be exact, rounding of the first correction would be work of one sense at every step.
            let enough = iteration > 1 || U::AT_ONCE;
            return Ok(if enough { Verdict::Settled } else { Verdict::GoesOn });
        }
        let rate = if iteration == 1 { size / step } else { size / self.last };
        self.last = size;
        let neglected = if U::PIECEWISE { size } else { rate * size };
        let settled = neglected <= MARGIN * force || size <= grains();
        // Corrections that no longer shrink and that a position can no longer show: forces that cancel, as in an
        // equilibrium, are not known better.
        let at_rounding =
            || iteration > 2 && rate > 0.25 && size <= 4.0 * f64::EPSILON * equation.q.largest().max(step);
        Ok(if settled || at_rounding() {
            Verdict::Settled
        } else if iteration > 1 && rate > 0.5 {
            Verdict::Slow
        } else {
            Verdict::GoesOn
        })
    }

    /// That many corrections have not led to a root.
    pub(super) fn exhausted(&self, corrections: u32) -> NotConverged {
        NotConverged { iterations: corrections.into(), residual: self.last }
    }
}
