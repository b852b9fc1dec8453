//! The loop that records a motion.

use std::time::Instant;

#[cfg(feature = "progress")]
use super::progress::Bar;
use super::progress::{Follow, Shown, Unseen};
use super::report::Work;
use super::{Interrupted, Run, Watch};
use crate::scheme::Scheme;
use crate::span::UNCOUNTED;
use crate::stepper::Stepper;
use crate::system::System;

/// Makes `steps` steps, or fewer if the motion arrives before, and records the state after every n-th.
pub(crate) fn record<Y: System, S: Scheme<Y>>(
    stepper: Stepper<Y, S>,
    run: Run<Y::State>,
    steps: u64,
    record_every: u64,
    shown: Shown,
) -> Result<Run<Y::State>, Interrupted<Y::State>> {
    #[cfg(feature = "progress")]
    if let Some(bar) = shown.bar {
        return record_seen(stepper, run, steps, record_every, Bar::new(bar, steps));
    }
    let Shown { .. } = shown;
    record_seen(stepper, run, steps, record_every, Unseen)
}

/// The loop, once for runs that are shown and once for those that are not.
fn record_seen<Y: System, S: Scheme<Y>, F: Follow>(
    mut stepper: Stepper<Y, S>,
    mut run: Run<Y::State>,
    steps: u64,
    record_every: u64,
    mut follow: F,
) -> Result<Run<Y::State>, Interrupted<Y::State>> {
    let clock = Instant::now();
    let mut watch = Watch::begin(&stepper);
    run.expect(if steps == UNCOUNTED { 0 } else { steps / record_every });
    run.record(stepper.state());
    let mut until_record = record_every;
    let mut failure = None;
    for _ in 0..steps {
        if stepper.arrived() {
            break;
        }
        if let Err(error) = watch.step(&mut stepper) {
            failure = Some(error);
            break;
        }
        follow.step();
        until_record -= 1;
        if until_record == 0 {
            until_record = record_every;
            let state = stepper.state();
            watch.observe(&stepper, &state);
            run.record(state);
        }
    }
    follow.end(failure.is_none());
    let last = stepper.state();
    if until_record != record_every {
        watch.observe(&stepper, &last);
    }
    let (steps, evaluations, iterations) = (stepper.steps(), stepper.evaluations(), stepper.iterations());
    let range = stepper.scheme.range(&stepper.memory);
    let work = Work { steps, evaluations, iterations, elapsed: clock.elapsed(), range };
    run.finish(last, watch.drifts(), watch.own_drifts(), work);
    match failure {
        None => Ok(run),
        Some(cause) => Err(Interrupted::new(run, cause)),
    }
}
