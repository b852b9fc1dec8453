//! Which states are recorded.

use core::fmt;

use crate::error::Error;
use crate::span::{UNCOUNTED, moves_on};

/// Which states are recorded.
#[derive(Clone, Debug)]
pub(crate) enum Due {
    /// The first, and that after every n-th step.
    Every(u64),
    /// Those at these times, in rising order.
    At(Vec<f64>),
    /// The first, and those at equal distances in time.
    Apart(f64),
}

impl fmt::Display for Due {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Due::Every(n) => write!(f, "after every {n} steps"),
            Due::Apart(dt) => write!(f, "every {dt:?} of time"),
            Due::At(times) => write!(f, "at t = {times:?}"),
        }
    }
}

impl Due {
    /// Refuses what cannot be recorded in a run from `start` on.
    pub(crate) fn check(&self, start: f64) -> Result<(), Error> {
        match *self {
            Due::Every(0) => Err(Error::RecordEvery),
            Due::Apart(dt) if !(dt > 0.0 && dt.is_finite() && moves_on(start, dt, f64::EPSILON).is_ok()) => {
                Err(Error::RecordDt { dt })
            }
            Due::At(ref times) => match times.iter().find(|t| !t.is_finite() || **t < start) {
                Some(&time) => Err(Error::RecordAt { time, start }),
                None => Ok(()),
            },
            _ => Ok(()),
        }
    }

    /// Refuses what can be recorded from no start.
    pub(crate) fn check_for_any(&self) -> Result<(), Error> {
        self.check(if matches!(self, Due::At(_)) { f64::NEG_INFINITY } else { 0.0 })
    }

    /// How many states so many steps, which take so much time, will give where that is known before.
    pub(crate) fn states(&self, steps: u64, time: f64) -> u64 {
        match self {
            Due::Every(_) if steps == UNCOUNTED => 0,
            Due::Every(n) => steps.checked_div(*n).map_or(0, |states| states.saturating_add(1)),
            Due::At(times) => times.len() as u64,
            Due::Apart(dt) if time.is_finite() => (time / dt) as u64,
            Due::Apart(_) => 0,
        }
    }

    /// The k-th time, if states are recorded by time.
    pub(crate) fn time(&self, start: f64, k: u64) -> Option<f64> {
        match self {
            Due::Every(_) => None,
            Due::At(times) => times.get(usize::try_from(k).ok()?).copied(),
            Due::Apart(dt) => Some(start + k as f64 * dt),
        }
    }
}
