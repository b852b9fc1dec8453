//! The loop that records a motion.

use core::borrow::Borrow;
use std::time::{Duration, Instant};

use dmech_scalar::Count;

use super::attend::{Attend, Happened, Within, in_order};
use super::due::Due;
use super::progress::{Follow, Shown};
use super::report::Work;
use super::{Interrupted, Run, Watch};
use crate::error::Error;
use crate::invariant::{Invariant, MAX_OWN};
use crate::scheme::Scheme;
use crate::span::UNCOUNTED;
use crate::stepper::Stepper;
use crate::system::System;

/// Makes `steps` steps, or fewer if the motion arrives or is stopped before, and records the states that are due.
pub(crate) fn record<Y: System, S: Scheme<Y>, O: Attend<Y::State>>(
    stepper: Stepper<Y, S>,
    run: Run<Y::State>,
    steps: u64,
    (due, attend): (Due, O),
    shown: Shown,
) -> Result<Run<Y::State>, Interrupted<Y::State>> {
    let mut log = Log::new(&stepper, run, due, attend);
    #[cfg(feature = "plot")]
    log.watch.keep_courses(stepper.t());
    // A stream keeps none.
    let states = if steps == UNCOUNTED || O::STREAMS { 0 } else { log.due.states(steps, stepper.dt) };
    if let Err(cause) = log.run.expect(states, Y::size(&stepper.start)) {
        return Err(Interrupted::new(log.run, cause));
    }
    log.write(stepper, steps, Follow::new(shown, steps))
}

/// What is written down of a motion.
pub(crate) struct Log<Y: System, O> {
    run: Run<Y::State>,
    pub(crate) watch: Watch<Y>,
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
    attend: O,
    happened: Vec<Happened<Y::State>>,
    /// What states between steps have cost.
    between: Spent,
}

#[derive(Clone, Copy, Default)]
struct Spent {
    evaluations: u64,
    iterations: u64,
}

impl Spent {
    /// The state at a time by a shortened step from a state, which is counted.
    fn state<Y: System, S: Scheme<Y>>(
        &mut self,
        stepper: &Stepper<Y, S>,
        from: &Y::State,
        t: f64,
    ) -> Result<Y::State, Error> {
        let (state, effort) = stepper.between(stepper.steps(), from, t)?;
        self.evaluations += effort.evaluations.to_u64();
        self.iterations += effort.iterations.to_u64();
        Ok(state)
    }
}

impl<Y: System, O: Attend<Y::State>> Log<Y, O> {
    pub(crate) fn new<S: Scheme<Y>>(stepper: &Stepper<Y, S>, mut run: Run<Y::State>, due: Due, attend: O) -> Self {
        run.report.keep(Invariant::ALL.map(|invariant| S::kept(&stepper.system, invariant)));
        let t = stepper.t();
        let until_record = if let Due::Every(n) = due { n } else { u64::MAX };
        let (next, watch) = (due.time(t, 0), Watch::begin(stepper));
        let (happened, between) = (Vec::new(), Spent::default());
        Log { run, watch, due, start: t, next, recorded: 0, until_record, looked_at: 0, attend, happened, between }
    }

    /// The whole run.
    fn write<S: Scheme<Y>>(
        mut self,
        mut stepper: Stepper<Y, S>,
        steps: u64,
        mut follow: Follow,
    ) -> Result<Run<Y::State>, Interrupted<Y::State>> {
        stepper.scheme.watch(true, &mut stepper.workspace);
        let clock = Instant::now();
        let outcome = self.begin(&stepper).and_then(|()| self.go(&mut stepper, steps, &mut follow));
        let outcome = outcome.and_then(|stopped| {
            if stopped.is_none() {
                self.record_at_the_end(&stepper)?;
            }
            Ok(stopped)
        });
        follow.end(stepper.steps(), outcome.is_ok());
        self.close(&stepper, outcome, clock.elapsed())
    }

    /// What a run gives back: where it was stopped, if it was, or why it failed.
    pub(crate) fn close<S: Scheme<Y>>(
        mut self,
        stepper: &Stepper<Y, S>,
        outcome: Result<Option<Y::State>, Error>,
        elapsed: Duration,
    ) -> Result<Run<Y::State>, Interrupted<Y::State>> {
        let ended = self.attend.end();
        let outcome = outcome.and_then(|stopped| ended.map(|()| stopped));
        if self.looked_at != stepper.steps() {
            let last = outcome.as_ref().ok().and_then(Clone::clone).unwrap_or_else(|| stepper.state());
            self.look_at(stepper, &last);
        }
        #[cfg(feature = "plot")]
        {
            let (mut courses, mut k) = (self.watch.take_courses(), self.watch.own_drifts().iter().count());
            self.attend.courses(&mut |course| {
                courses.add(k, course.clone());
                k += 1;
            });
            self.run.courses = courses;
        }
        let Log { mut run, watch, attend, between: Spent { evaluations, iterations }, .. } = self;
        let (evaluations, iterations) = (evaluations + stepper.evaluations(), iterations + stepper.iterations());
        let (steps, range) = (stepper.steps(), stepper.scheme.range(&stepper.memory));
        let rough = stepper.scheme.rough(&stepper.memory);
        let work = Work { steps, evaluations, iterations, rough, elapsed, range };
        let (stopped, failure) = match outcome {
            Ok(stopped) => (stopped, None),
            Err(cause) => (None, Some(cause)),
        };
        let mut own = watch.own_drifts();
        attend.drifts(&mut |name, drift| own.add(name, drift));
        run.finish(stopped, || stepper.state(), (watch.drifts(), own), work);
        match failure {
            None => Ok(run),
            Some(cause) => Err(Interrupted::new(run, cause)),
        }
    }

    /// Looks at the first state and records it.
    pub(crate) fn begin<S: Scheme<Y>>(&mut self, stepper: &Stepper<Y, S>) -> Result<(), Error> {
        let state = stepper.state();
        const { assert!(O::QUANTITIES <= MAX_OWN, "a run watches eight quantities at most") };
        self.attend.begin(&state)?;
        self.attend.look(Y::time(&state), &state);
        if matches!(self.due, Due::Every(_)) { self.keep(state) } else { self.record_due(state) }
    }

    /// Makes the steps; where the run was stopped, if it was.
    fn go<S: Scheme<Y>>(
        &mut self,
        stepper: &mut Stepper<Y, S>,
        steps: u64,
        follow: &mut Follow,
    ) -> Result<Option<Y::State>, Error> {
        // Steps until a state is recorded or the bar is looked at, and how many there were.
        let mut row = follow.look(0).min(self.until_record);
        let mut left = row;
        for _ in 0..steps {
            if stepper.arrived() {
                break;
            }
            let before = (O::EVENTS > 0 || self.is_due_before(stepper)).then(|| stepper.state());
            self.watch.step(stepper)?;
            if let Some(before) = before
                && let Some(stopped) =
                    self.look_into_the_step(stepper, Y::time(&before), || &before, &stepper.state())?
            {
                return Ok(Some(stopped));
            }
            left -= 1;
            if left == 0 {
                self.count(stepper, row)?;
                row = follow.look(stepper.steps()).min(self.until_record);
                left = row;
            }
            if let Some(stopped) = self.observe(stepper, &mut || stepper.state()) {
                return Ok(Some(stopped));
            }
        }
        Ok(None)
    }

    /// Shows the state to those who observe it; where they have stopped the run.
    #[inline(always)]
    pub(crate) fn observe<S: Scheme<Y>>(
        &mut self,
        stepper: &Stepper<Y, S>,
        now: &mut dyn FnMut() -> Y::State,
    ) -> Option<Y::State> {
        let stops = O::OBSERVES && self.attend.observe(stepper.steps(), now).is_break();
        stops.then(now)
    }

    /// Counts a row of steps, and records the state if it is due.
    pub(crate) fn count<S: Scheme<Y>>(&mut self, stepper: &Stepper<Y, S>, steps: u64) -> Result<(), Error> {
        self.until_record -= steps;
        let (0, &Due::Every(n)) = (self.until_record, &self.due) else { return Ok(()) };
        self.until_record = n;
        let state = stepper.state();
        self.look_at(stepper, &state);
        self.keep(state)
    }

    /// What is left of a look where the invariants of all laws were seen elsewhere.
    pub(crate) fn look_beside<S: Scheme<Y>>(&mut self, stepper: &Stepper<Y, S>, state: Y::State) -> Result<(), Error> {
        self.watch.observe_own(stepper, &state);
        self.attend.look(Y::time(&state), &state);
        self.keep(state)
    }

    /// Whether a state is to be recorded that the next step may reach.
    pub(crate) fn is_due_before<S: Scheme<Y>>(&self, stepper: &Stepper<Y, S>) -> bool {
        // A step may come out longer by rounding.
        self.next.is_some_and(|next| next <= stepper.t() + 1.01 * stepper.next_dt())
    }

    /// Events, and states that are due, in the step that was made; where the run was stopped in it. The state before it is asked
    /// for where something has happened.
    #[inline]
    pub(crate) fn look_into_the_step<S: Scheme<Y>, B: Borrow<Y::State>>(
        &mut self,
        stepper: &Stepper<Y, S>,
        start: f64,
        before: impl Fn() -> B,
        after: &Y::State,
    ) -> Result<Option<Y::State>, Error> {
        let Log { attend, between, happened, next, .. } = self;
        let mut at = |t| between.state(stepper, before().borrow(), t);
        if O::EVENTS > 0 {
            attend.meet(0, &mut Within { end: after, times: [start, Y::time(after)], at: &mut at, happened })?;
        }
        if happened.is_empty() && next.is_none_or(|next| next > Y::time(after)) {
            return Ok(None);
        }
        self.take_what_happened(stepper, before, after)
    }

    fn take_what_happened<S: Scheme<Y>, B: Borrow<Y::State>>(
        &mut self,
        stepper: &Stepper<Y, S>,
        before: impl Fn() -> B,
        after: &Y::State,
    ) -> Result<Option<Y::State>, Error> {
        let Log { happened, .. } = self;
        in_order(happened, Y::time);
        let mut stopped = None;
        for Happened { stops, event } in happened.drain(..) {
            let state = stops.then(|| event.state().clone());
            self.run.happened(event);
            if state.is_some() {
                stopped = state;
                break;
            }
        }
        let end = Y::time(stopped.as_ref().unwrap_or(after));
        let mut any = false;
        while let Some(t) = self.next.filter(|&t| t <= end) {
            let state =
                if t == Y::time(after) { after.clone() } else { self.between.state(stepper, before().borrow(), t)? };
            self.record_due(state)?;
            any = true;
        }
        if any && stopped.is_none() {
            self.look_at(stepper, after);
        }
        Ok(stopped)
    }

    pub(crate) fn look_at<S: Scheme<Y>>(&mut self, stepper: &Stepper<Y, S>, state: &Y::State) {
        self.watch.observe(stepper, state);
        self.attend.look(Y::time(state), state);
        self.looked_at = stepper.steps();
    }

    /// A state that is due by its time is recorded, and the next one follows.
    fn record_due(&mut self, state: Y::State) -> Result<(), Error> {
        if self.next != Some(Y::time(&state)) {
            return Ok(());
        }
        self.recorded += 1;
        self.next = self.due.time(self.start, self.recorded);
        if let (Due::Apart(dt), true) = (&self.due, self.next == Some(Y::time(&state))) {
            return Err(Error::RecordDt { dt: *dt });
        }
        self.keep(state)
    }

    /// Times that only rounding keeps from having been reached.
    pub(crate) fn record_at_the_end<S: Scheme<Y>>(&mut self, stepper: &Stepper<Y, S>) -> Result<(), Error> {
        let last = stepper.state();
        let reached = Y::time(&last);
        let rounding = 4.0 * f64::EPSILON * reached.abs().max(self.start.abs());
        while let Some(t) = self.next.filter(|&t| t <= reached + rounding) {
            let state = self.between.state(stepper, &last, t)?;
            self.record_due(state)?;
        }
        Ok(())
    }

    /// Records a state, or hands it to a stream.
    fn keep(&mut self, state: Y::State) -> Result<(), Error> {
        if !self.attend.take(&state)? {
            self.run.record(state);
        }
        Ok(())
    }
}
