//! What is measured of a motion over a seam.

use dmech::Kept;
use dmech::extend::VelocityIndependent;
use dmech::prelude::*;

use crate::laws::crossings;

/// A law of the table: the power of its sharpest seam, and on which side of one a point is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seam<L, const D: usize> {
    pub(crate) law: L,
    pub(crate) power: f64,
    pub(crate) side: fn([f64; D]) -> bool,
}

impl<L: Law<D> + VelocityIndependent + Copy, const D: usize> Seam<L, D> {
    pub(crate) fn crossed(&self, run: &Run<State<D>>) -> usize {
        crossings(run.states(), |state| (self.side)(state.q))
    }

    /// Kinetic and potential energy of the start, as they may cancel.
    pub(crate) fn scale(&self, start: &State<D>) -> f64 {
        self.law.field(1.0, 0.0).potential(start.q).abs() + start.v.iter().map(|v| 0.5 * v * v).sum::<f64>()
    }

    /// What is exact is exact.
    pub(crate) fn keeps<S: Method>(&self, run: &Run<State<D>>, what: &str) {
        let scale = self.scale(&run.states()[0]);
        for invariant in Invariant::ALL {
            let Some(drift) = run.drift(invariant) else { continue };
            let moved = drift.max_abs() / scale;
            // An explicit orbit gains energy without end, and its rounding with it.
            if S::keeps(invariant) == Kept::Exact && S::ORDER > 1 {
                let most = if invariant == Invariant::WorkEnergy { 1e-13 } else { 2e-14 };
                assert!(moved < most, "{}, {what}: {invariant} {moved:e}", S::NAME);
            }
        }
    }
}

/// Whether the run reached its end, or why it need not: the trapezoid takes its force at the end of the step, and where that
/// jumps against the motion, the end that is asked for with the one force lies beyond the seam, and with the other before it.
pub(crate) fn reached<S: Method, const D: usize>(
    outcome: Result<Run<State<D>>, Interrupted<State<D>>>,
    power: f64,
) -> Option<Run<State<D>>> {
    let interrupted = match outcome {
        Ok(run) => {
            assert!(run.states().iter().all(|s| s.q.iter().chain(&s.v).all(|x| x.is_finite())), "{}", S::NAME);
            return Some(run);
        }
        Err(interrupted) => interrupted,
    };
    assert!(power == 1.0 && S::NAME.contains("Implicit"), "{}: {interrupted}", S::NAME);
    let (next, told) = (interrupted.run().steps() + 1, interrupted.cause());
    assert!(matches!(told, Error::NotConverged { step, .. } if step == next), "{}: {told}", S::NAME);
    None
}

/// The slope of log error over log h, by least squares.
pub(crate) fn order<const N: usize>(steps: [f64; N], errors: [f64; N]) -> f64 {
    let x = steps.map(f64::ln);
    let mean = x.iter().sum::<f64>() / N as f64;
    let along: f64 = x.iter().zip(errors).map(|(x, error)| (x - mean) * error.ln()).sum();
    along / x.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>()
}
