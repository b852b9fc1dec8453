//! What errors are measured against where no exact solution is known.

use dmech_core::extend::Method;
use dmech_core::{Composed, DiscreteGradient, Error};

use super::case::{Case, distance, rounding};
use super::entrant::{Entrant, Runner};
use super::ladder::halvings;
use crate::motion::Repeatable;

/// No halving follows a run with this many forces.
const MOST_FORCES: u64 = 1 << 22;

/// A solution computed by the study.
///
/// By default it is that of `Composed::order8(DiscreteGradient)`, which fits every law, with its step halved until the
/// final position does not settle any further. [`Study::precise`](super::Study::precise) computes one in double-double numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Reference {
    pub(super) scheme: &'static str,
    pub(super) dt: f64,
    pub(super) error: f64,
    pub(super) precise: bool,
}

impl Reference {
    /// The scheme.
    pub fn scheme(&self) -> &'static str {
        self.scheme
    }

    /// Its time step; the mean of them where they follow the motion.
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// |q_h − q_2h| at the end, and the rounding of q. Where the order shows, the error of q_h is 255 times less; at
    /// the level of rounding it is about this. Of a [precise](Reference::is_precise) one it is what a tolerance a thousand
    /// times smaller has changed, so the error is about a thousand times less.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Whether it was computed in double-double numbers, by [`Study::precise`](super::Study::precise).
    pub fn is_precise(&self) -> bool {
        self.precise
    }
}

/// The final position that halving the step changes least.
pub(super) fn compute<L: Clone, X: Repeatable<L>>(case: &Case<L, X>) -> Result<(Vec<f64>, Reference), Error> {
    let runner = Entrant(Composed::order8(DiscreteGradient));
    let scales = case.scales()?;
    let mut best: Option<(Vec<f64>, Reference)> = None;
    let mut before: Option<Vec<f64>> = None;
    let mut failure = None;
    for dt in halvings(scales.time.min(case.end - case.t())) {
        // Steps so short that the time no longer tells them apart end the search, not the study.
        let (steps, dt) = match case.whole_steps(dt) {
            Ok(whole) => whole,
            Err(error) => {
                failure = failure.or(Some(error));
                break;
            }
        };
        let (q, evaluations) = match runner.watch(case, dt, steps) {
            Ok(run) => (run.q, run.evaluations),
            Err(error) => {
                failure = Some(error);
                if steps > MOST_FORCES {
                    break;
                }
                continue;
            }
        };
        let change = before.replace(q.clone()).and_then(|before| distance(&q, &before));
        // Two runs may end at the same numbers, which are rounded all the same.
        let change = change.map(|change| change + rounding(&q));
        if let Some(error) = change {
            let least = best.as_ref().map_or(f64::INFINITY, |best| best.1.error);
            if error < least {
                best = Some((q, Reference { scheme: name(&runner), dt, error, precise: false }));
            }
            if least < 1e-9 * scales.length && error > 0.5 * least {
                break;
            }
        }
        if best.is_some() && evaluations > MOST_FORCES {
            break;
        }
    }
    best.ok_or_else(|| failure.unwrap_or(Error::EndTime { end: case.end, dt: scales.time }))
}

fn name<S: Method>(_: &Entrant<S>) -> &'static str {
    S::NAME
}
