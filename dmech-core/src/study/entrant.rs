//! A scheme in a study.

use std::hint::black_box;
use std::time::{Duration, Instant};

use super::case::Case;
use crate::error::Error;
use crate::law::Law;
use crate::motion::Motion;
use crate::scheme::Scheme;
use crate::stepper::Stepper;
use crate::watch::Drifts;

/// States at which the invariants of a run are looked at.
const SAMPLES: u64 = 4096;

/// Schemes of different types in one list.
pub(super) trait Runner<L, const D: usize> {
    /// The name in tables.
    fn name(&self) -> &'static str;
    /// The order that the scheme declares.
    fn order(&self) -> u32;
    /// Runs and watches the invariants.
    fn watch(&self, case: &Case<L, D>, dt: f64, steps: u64) -> Result<Watched<D>, Error>;
    /// The time of a run, from as many in a row; `None` if the run fails.
    fn time(&self, case: &Case<L, D>, dt: f64, steps: u64, runs: u32) -> Option<Duration>;
}

/// Where a run ended, what it kept and what it cost.
pub(super) struct Watched<const D: usize> {
    pub(super) q: [f64; D],
    pub(super) drifts: Drifts,
    pub(super) evaluations: u64,
    pub(super) iterations: u64,
}

/// A scheme, with its options.
pub(super) struct Entrant<S>(pub(super) S);

impl<L: Law<D> + Clone, S: Scheme<L, D>, const D: usize> Runner<L, D> for Entrant<S> {
    fn name(&self) -> &'static str {
        S::NAME
    }

    fn order(&self) -> u32 {
        S::ORDER
    }

    fn watch(&self, case: &Case<L, D>, dt: f64, steps: u64) -> Result<Watched<D>, Error> {
        let mut stepper = Stepper::new(case.law.clone(), self.0, case.start, dt, case.mass)?;
        let mut watch = stepper.watch();
        let every = steps.div_ceil(SAMPLES);
        for step in 1..=steps {
            stepper.step_watched(&mut watch)?;
            if step % every == 0 || step == steps {
                let state = stepper.state();
                stepper.observe(&mut watch, &state);
            }
        }
        let (evaluations, iterations) = (stepper.evaluations(), stepper.iterations());
        Ok(Watched { q: stepper.q(), drifts: watch.drifts(), evaluations, iterations })
    }

    fn time(&self, case: &Case<L, D>, dt: f64, steps: u64, runs: u32) -> Option<Duration> {
        let clock = Instant::now();
        for _ in 0..runs {
            let mut stepper = Stepper::new(case.law.clone(), self.0, black_box(case.start), dt, case.mass).ok()?;
            stepper.advance(black_box(steps)).ok()?;
            black_box(stepper.q());
        }
        Some(clock.elapsed() / runs)
    }
}
