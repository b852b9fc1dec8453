//! What errors are measured against where no exact solution is known.

use dmech_core::extend::Method;
use dmech_core::{Composed, DiscreteGradient, Error};

use super::case::{Case, distance, rounding};
use super::entrant::{Entrant, Runner};
use super::ladder::halvings;
use crate::motion::Repeatable;

/// No halving follows a run with this many forces.
const MOST_FORCES: u64 = 1 << 22;

/// How many changes tell the error where the order does not show.
const LAST: usize = 2;

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

    /// How far q_h may be off at the end, the rounding of q included. Where the order shows it is |q_h − q_2h|, and the error of
    /// q_h is 255 times less. Where it does not, at the level of rounding and in motions that cross seams of their law, it
    /// is the larger of the changes by the last two halvings, and the error is about this. Of a
    /// [precise](Reference::is_precise) one it is what a tolerance a thousand times smaller has changed, so the error is about
    /// a thousand times less.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Whether it was computed in double-double numbers, by [`Study::precise`](super::Study::precise).
    pub fn is_precise(&self) -> bool {
        self.precise
    }
}

/// A fall of the change by this, twice in a row, shows the order: 2⁸ where it is the scheme's own. Chance does not fall so twice.
const SHOWS: f64 = 64.0;

/// The final position that is known best, of those that halving the step leads to.
pub(super) fn compute<L: Clone, X: Repeatable<L>>(case: &Case<L, X>) -> Result<(Vec<f64>, Reference), Error> {
    let runner = Entrant(Composed::order8(DiscreteGradient));
    let scales = case.scales()?;
    let (mut settling, mut best) = (Settling::default(), None);
    let mut before: Option<Vec<f64>> = None;
    let mut failure = None;
    for dt in halvings(scales.time.min(case.longest_of_reference())) {
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
        if let Some(change) = change {
            let least = settling.least();
            if let Some(error) = settling.nearer(change) {
                best = Some((q, Reference { scheme: name(&runner), dt, error, precise: false }));
            }
            if least < 1e-9 * scales.length && change > 0.5 * least {
                break;
            }
        }
        if best.is_some() && evaluations > MOST_FORCES {
            break;
        }
    }
    best.ok_or_else(|| failure.unwrap_or(Error::EndTime { end: case.end, dt: scales.time }))
}

/// What each halving has changed, and the error of the best of them.
#[derive(Debug, Default)]
pub(super) struct Settling {
    changes: Vec<f64>,
    best: Option<f64>,
}

impl Settling {
    /// The smallest change.
    fn least(&self) -> f64 {
        self.changes.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The error after another halving, if it is no larger than all before.
    ///
    /// It is the change where the order shows. At the level of rounding, and where a kink or a jump of the force leaves h² or h at each
    /// crossing, a small change may be chance: there it is the largest of the last few.
    pub(super) fn nearer(&mut self, change: f64) -> Option<f64> {
        self.changes.push(change);
        let error = match self.changes[..] {
            [.., a, b, c] if a >= SHOWS * b && b >= SHOWS * c => c,
            _ => self.changes.iter().rev().take(LAST).copied().fold(0.0, f64::max),
        };
        if self.best.is_some_and(|best| error > best) {
            return None;
        }
        self.best = Some(error);
        self.best
    }
}

fn name<S: Method>(_: &Entrant<S>) -> &'static str {
    S::NAME
}
