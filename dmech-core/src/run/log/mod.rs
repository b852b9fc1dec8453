//! What is written down of a motion, from its first state to the last.

mod step;

use std::time::{Duration, Instant};

use dmech_scalar::Real;

use super::attend::{Attend, Happened};
use super::due::Due;
use super::motion::Motion;
use super::progress::Follow;
use super::report::{Cost, shown};
use super::simulation::{Extent, Settings};
use super::{Interrupted, Run, Watch};
use crate::drift::MAX_OWN;
use crate::error::Error;
use crate::invariant::Invariant;
use crate::stepper::in_parts;

/// Makes the steps, and records the states that are due.
pub(crate) fn record<X: Clone, R: Real, O: Attend<X>>(
    motion: &mut dyn Motion<X, R>,
    run: Run<X>,
    Extent { steps, until, states, settings: Settings { due, shown, .. } }: Extent,
    (attend, histories): (O, bool),
) -> Result<Run<X>, Interrupted<X>> {
    let mut log = Log::new(motion, run, due, attend);
    (log.until, log.ends_at) = (until, steps);
    if histories {
        log.watch.keep_histories(log.start);
    }
    // A stream keeps none.
    if !O::STREAMS {
        log = log.with_room(motion, states)?;
    }
    log.write(motion, Follow::new(shown, steps))
}

/// What is written down of a motion.
pub(crate) struct Log<X, R: Real, O> {
    run: Run<X>,
    pub(crate) watch: Watch<X, R>,
    time: fn(&X) -> f64,
    due: Due,
    /// The time of the start, and of the next state that is recorded by time.
    start: f64,
    pub(crate) next: Option<f64>,
    /// States recorded by time so far.
    recorded: u64,
    /// Steps until a state is recorded by number.
    pub(crate) until_record: u64,
    /// The steps after which the invariants were looked at last.
    pub(crate) looked_at: u64,
    /// The time to which the steps were counted, if they were, and the steps with which the run ends.
    pub(crate) until: Option<f64>,
    pub(crate) ends_at: u64,
    attend: O,
    happened: Vec<Happened<X>>,
    /// Where an event has changed the motion: the state before and after.
    changed: Option<[X; 2]>,
    /// Where what it has changed could not go on.
    failed_at: Option<X>,
    /// What states between steps have cost.
    between: Spent,
}

/// Evaluations and corrections.
#[derive(Clone, Copy, Default)]
struct Spent([u64; 2]);

impl Spent {
    /// The state at a time by a shortened step from a state, which is counted.
    fn state<X, R: Real>(&mut self, motion: &dyn Motion<X, R>, from: &X, t: f64) -> Result<X, Error> {
        let (state, cost) = in_parts(&|from, t| motion.between(from, t), motion.clock(), from, t)?;
        self.0.iter_mut().zip(cost).for_each(|(spent, cost)| *spent += cost);
        Ok(state)
    }
}

impl<X: Clone, R: Real, O: Attend<X>> Log<X, R, O> {
    pub(crate) fn new(motion: &dyn Motion<X, R>, mut run: Run<X>, due: Due, attend: O) -> Self {
        run.report.keep(motion.kept());
        let time = motion.clock();
        let t = time(&motion.state());
        let until_record = if let Due::Every(n) = due { n } else { u64::MAX };
        let (next, watch) = (due.time(t, 0), Watch::of(motion));
        let (happened, between, start) = (Vec::new(), Spent::default(), t);
        let (recorded, looked_at) = (0, 0);
        Log {
            run,
            watch,
            time,
            due,
            start,
            next,
            recorded,
            until_record,
            looked_at,
            until: None,
            ends_at: u64::MAX,
            attend,
            happened,
            changed: None,
            failed_at: None,
            between,
        }
    }

    /// With room for so many states: more than there is memory for are refused.
    pub(crate) fn with_room(mut self, motion: &dyn Motion<X, R>, states: u64) -> Result<Self, Interrupted<X>> {
        match self.run.expect(states, motion.size()) {
            Ok(()) => Ok(self),
            Err(cause) => Err(Interrupted::new(self.run, cause)),
        }
    }

    /// The whole run.
    fn write(mut self, motion: &mut dyn Motion<X, R>, mut follow: Follow) -> Result<Run<X>, Interrupted<X>> {
        let clock = Instant::now();
        let outcome = self.begin(motion).and_then(|()| self.go(motion, u64::MAX, &mut follow));
        let outcome = outcome.and_then(|stopped| {
            if stopped.is_none() {
                self.record_at_the_end(motion)?;
            }
            Ok(stopped)
        });
        follow.end(motion.steps(), outcome.is_ok());
        self.close(motion, outcome, clock.elapsed())
    }

    /// What a run gives back: where it was stopped, if it was, or why it failed.
    pub(crate) fn close(
        mut self,
        motion: &dyn Motion<X, R>,
        outcome: Result<Option<X>, Error>,
        elapsed: Duration,
    ) -> Result<Run<X>, Interrupted<X>> {
        let ended = self.attend.end();
        let outcome = outcome.and_then(|stopped| ended.map(|()| stopped));
        if self.looked_at != motion.steps() {
            let stopped = outcome.as_ref().ok().and_then(Clone::clone);
            let last = stopped.or_else(|| self.failed_at.clone()).unwrap_or_else(|| motion.state());
            self.look_at(motion, &last);
        }
        let Log { mut run, mut watch, time, attend, failed_at, between: Spent([evaluations, iterations]), .. } = self;
        run.histories = watch.histories.take();
        let work = motion.work();
        let (evaluations, iterations) = (evaluations + work.evaluations, iterations + work.iterations);
        let work = Cost { evaluations, iterations, elapsed, ..work };
        let (stopped, failure) = match outcome {
            Ok(stopped) => (stopped, None),
            Err(cause) => (None, Some(cause)),
        };
        let mut own = watch.own_drifts();
        attend.drifts(&mut |name, drift| own.add(name, drift));
        run.finish(stopped, || failed_at.unwrap_or_else(|| motion.state()), (watch.drifts(), own), work);
        match failure.or_else(|| watch.in_domain(time(&run.last)).err()) {
            None => Ok(run),
            Some(cause) => Err(Interrupted::new(run, cause)),
        }
    }

    /// Looks at the first state and records it.
    pub(crate) fn begin(&mut self, motion: &dyn Motion<X, R>) -> Result<(), Error> {
        let state = motion.state();
        const { assert!(O::QUANTITIES <= MAX_OWN, "a run watches eight quantities at most") };
        self.attend.begin(&state)?;
        self.look_as_well(&state);
        if O::QUANTITIES > 0 {
            self.check_names()?;
        }
        if matches!(self.due, Due::Every(_)) { self.keep(state) } else { self.record_due(state) }
    }

    /// Refuses a name that two quantities have: the second could not be asked for, or told from an invariant in a report.
    fn check_names(&self) -> Result<(), Error> {
        let (mut named, mut twice) = (self.watch.own_drifts(), None);
        let watched = self.watch.drifts();
        let is_of_report = |name: &str| {
            let mut known = Invariant::ALL.iter().filter(|&&invariant| watched[invariant as usize].is_some());
            known.any(|known| known.to_string() == shown(name))
        };
        self.attend.drifts(&mut |name, drift| {
            let taken = named.of(name).is_some() || is_of_report(name);
            twice = twice.or(taken.then_some(name));
            named.add(name, drift);
        });
        twice.map_or(Ok(()), |name| Err(Error::WatchedTwice { name }))
    }

    /// Makes so many steps, or fewer if the motion arrives or the run ends; where it was stopped, if it was.
    pub(crate) fn go(
        &mut self,
        motion: &mut dyn Motion<X, R>,
        steps: u64,
        follow: &mut Follow,
    ) -> Result<Option<X>, Error> {
        let last = motion.steps().saturating_add(steps);
        let mut all = self.steps_to(last, motion);
        // Steps until a state is recorded or the bar is looked at, and how many of them are left.
        let mut row = follow.look(0).min(self.until_record).min(all);
        let mut left = row;
        while all > 0 && !motion.arrived() {
            let is_due = self.is_due_before(motion);
            let before = (O::EVENTS > 0 || is_due).then(|| motion.state());
            let most = if before.is_some() || O::OBSERVES { 1 } else { left.min(all) };
            let made = motion.go(most, self.next.filter(|_| !is_due), &mut self.watch)?;
            if let Some(before) = before {
                let (start, after) = ((self.time)(&before), motion.state());
                if let Some(stopped) = self.look_into_the_step(motion, start, &|| before.clone(), &after)? {
                    return Ok(Some(stopped));
                }
            }
            (left, all) = (left - made, all - made);
            if O::CHANGES && self.change(motion)? {
                // The steps begin anew where the change was.
                self.count(motion, row - left)?;
                all = self.steps_to(last, motion);
                (row, left) = (0, 0);
            }
            if left == 0 {
                self.count(motion, row)?;
                row = follow.look(motion.steps()).min(self.until_record).min(all);
                left = row;
            }
            if let Some(stopped) = self.observe(motion.steps(), &mut || motion.state()) {
                return Ok(Some(stopped));
            }
        }
        Ok(None)
    }

    /// How many steps are to be made until there are `last`, or until the run ends.
    fn steps_to(&self, last: u64, motion: &dyn Motion<X, R>) -> u64 {
        last.min(self.ends_at).saturating_sub(motion.steps())
    }

    /// Shows the state to those who observe it; where they have stopped the run.
    #[inline(always)]
    pub(crate) fn observe(&mut self, steps: u64, now: &mut dyn FnMut() -> X) -> Option<X> {
        let stops = O::OBSERVES && self.attend.observe(steps, now).is_break();
        stops.then(now)
    }

    /// Counts a row of steps, and records the state if it is due.
    pub(crate) fn count(&mut self, motion: &dyn Motion<X, R>, steps: u64) -> Result<(), Error> {
        self.until_record -= steps;
        let (0, &Due::Every(n)) = (self.until_record, &self.due) else { return Ok(()) };
        self.until_record = n;
        let state = motion.state();
        self.look_at(motion, &state);
        self.keep(state)
    }

    /// What is left of a look where the invariants of all laws were seen elsewhere.
    pub(crate) fn look_beside(&mut self, motion: &dyn Motion<X, R>, state: X) -> Result<(), Error> {
        self.watch.see_own(motion, &state);
        self.look_as_well(&state);
        self.keep(state)
    }

    /// Whether a state is to be recorded that the next step may reach.
    pub(crate) fn is_due_before(&self, motion: &dyn Motion<X, R>) -> bool {
        self.next.is_some_and(|next| motion.reaches(next))
    }

    pub(crate) fn look_at(&mut self, motion: &dyn Motion<X, R>, state: &X) {
        self.watch.see(motion, state);
        self.look_as_well(state);
        self.looked_at = motion.steps();
    }

    /// The quantities of the run, beside the invariants.
    fn look_as_well(&mut self, state: &X) {
        let t = (self.time)(state);
        self.attend.look(t, state, &mut self.watch.beside(t));
    }

    /// A state that is due by its time is recorded, and the next one follows.
    fn record_due(&mut self, state: X) -> Result<(), Error> {
        let t = (self.time)(&state);
        if self.next != Some(t) {
            return Ok(());
        }
        self.recorded += 1;
        self.next = self.due.time(self.start, self.recorded);
        if let (Due::Apart(dt), true) = (&self.due, self.next == Some(t)) {
            return Err(Error::RecordDt { dt: *dt });
        }
        self.keep(state)
    }

    /// Times that only rounding keeps from having been reached.
    pub(crate) fn record_at_the_end(&mut self, motion: &dyn Motion<X, R>) -> Result<(), Error> {
        let last = motion.state();
        let reached = (self.time)(&last);
        // Of the time, not a step.
        let rounding = (4.0 * f64::EPSILON * reached.abs().max(self.start.abs())).min(0.25 * motion.dt());
        while let Some(t) = self.next.filter(|&t| t <= reached + rounding) {
            let state = self.between.state(motion, &last, t)?;
            self.record_due(state)?;
        }
        Ok(())
    }

    /// Records a state, or hands it to a stream.
    fn keep(&mut self, state: X) -> Result<(), Error> {
        if !self.attend.take(&state)? {
            self.run.record(state);
        }
        Ok(())
    }
}
