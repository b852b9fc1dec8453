//! The loop that records a motion, for one body and for many.

use std::time::Instant;

use crate::error::{Error, Interrupted};
#[cfg(feature = "progress")]
use crate::progress::Bar;
use crate::progress::{Follow, Shown, Unseen};
use crate::run::{Run, Work};
use crate::watch::Drifts;

/// Something that steps and can be watched.
pub(crate) trait Motion {
    /// What is recorded.
    type State: Clone;
    /// What follows the invariants.
    type Watch;

    /// Position and velocity now.
    fn state(&self) -> Self::State;
    /// Starts to follow the invariants from the first state.
    fn watch(&self) -> Self::Watch;
    /// Makes one step and notes its work.
    fn step_watched(&mut self, watch: &mut Self::Watch) -> Result<(), Error>;
    /// Looks at a recorded state.
    fn observe(&self, watch: &mut Self::Watch, state: &Self::State);
    /// How the invariants moved.
    fn drifts(watch: &Self::Watch) -> Drifts;
    /// Steps, evaluations of the force, Newton corrections.
    fn effort(&self) -> [u64; 3];
    /// Whether the end is reached, where the steps are not counted.
    #[inline(always)]
    fn arrived(&self) -> bool {
        false
    }
    /// The shortest and the longest step, where they differ.
    fn range(&self) -> Option<[f64; 2]> {
        None
    }
}

/// Makes `steps` steps, or fewer if the motion arrives before, and records the state after every n-th.
pub(crate) fn record<M: Motion>(
    motion: M,
    run: Run<M::State>,
    steps: u64,
    record_every: u64,
    shown: Shown,
) -> Result<Run<M::State>, Interrupted<M::State>> {
    #[cfg(feature = "progress")]
    if let Some(bar) = shown.bar {
        return record_seen(motion, run, steps, record_every, Bar::new(bar, steps));
    }
    let Shown { .. } = shown;
    record_seen(motion, run, steps, record_every, Unseen)
}

/// The loop, once for runs that are shown and once for those that are not.
fn record_seen<M: Motion, F: Follow>(
    mut motion: M,
    mut run: Run<M::State>,
    steps: u64,
    record_every: u64,
    mut follow: F,
) -> Result<Run<M::State>, Interrupted<M::State>> {
    let clock = Instant::now();
    let mut watch = motion.watch();
    run.expect(if steps == UNCOUNTED { 0 } else { steps / record_every });
    run.record(motion.state());
    let mut until_record = record_every;
    let mut failure = None;
    for _ in 0..steps {
        if motion.arrived() {
            break;
        }
        if let Err(error) = motion.step_watched(&mut watch) {
            failure = Some(error);
            break;
        }
        follow.step();
        until_record -= 1;
        if until_record == 0 {
            until_record = record_every;
            let state = motion.state();
            motion.observe(&mut watch, &state);
            run.record(state);
        }
    }
    follow.end(failure.is_none());
    let last = motion.state();
    if until_record != record_every {
        motion.observe(&mut watch, &last);
    }
    let [steps, evaluations, iterations] = motion.effort();
    let work = Work { steps, evaluations, iterations, elapsed: clock.elapsed(), range: motion.range() };
    run.finish(last, M::drifts(&watch), work);
    match failure {
        None => Ok(run),
        Some(cause) => Err(Interrupted::new(run, cause)),
    }
}

/// As many steps as it takes to arrive.
pub(crate) const UNCOUNTED: u64 = u64::MAX;

/// The steps from `start` to `end`: ⌈n − 10⁻⁹ n⌉ with n = (end − start)/dt.
pub(crate) fn steps_until(start: f64, end: f64, dt: f64) -> Result<u64, Error> {
    let n = (end - start) / dt;
    // Beyond 2⁵³ the time t₀ + k h no longer distinguishes steps.
    if !n.is_finite() || n > 9_007_199_254_740_992.0 {
        return Err(Error::EndTime { end, dt });
    }
    Ok((n - 1e-9 * n).ceil().max(0.0) as u64)
}
