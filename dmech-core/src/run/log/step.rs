//! The step that was made last: what happened in it, where it is broken off, and what is due in it.

use dmech_scalar::Real;

use super::Log;
use crate::error::Error;
use crate::run::attend::{After, Attend, Happened, Within, in_order};
use crate::run::motion::Motion;
use crate::span::{Span, is_rounding};

impl<X: Clone, R: Real, O: Attend<X>> Log<X, R, O> {
    /// Events, and states that are due, in the step that was made; where the run was stopped in it. The state before it is asked
    /// for where something has happened.
    #[inline]
    pub(crate) fn look_into_the_step(
        &mut self,
        motion: &dyn Motion<X, R>,
        start: f64,
        before: &dyn Fn() -> X,
        after: &X,
    ) -> Result<Option<X>, Error> {
        let Log { attend, between, happened, next, time, .. } = self;
        let mut at = |t| between.state(motion, &before(), t);
        if O::EVENTS > 0 {
            let met = attend.meet(0, &mut Within { end: after, times: [start, time(after)], at: &mut at, happened });
            if let Err(cause) = met {
                self.failed_at = O::CHANGES.then(before);
                return Err(cause);
            }
        }
        if happened.is_empty() && next.is_none_or(|next| next > time(after)) {
            return Ok(None);
        }
        self.take_what_happened(motion, start, before, after)
    }

    fn take_what_happened(
        &mut self,
        motion: &dyn Motion<X, R>,
        start: f64,
        before: &dyn Fn() -> X,
        after: &X,
    ) -> Result<Option<X>, Error> {
        let broken = match self.broken_off(motion, start, before) {
            Ok(broken) => broken,
            Err(cause) => {
                self.failed_at = Some(before());
                return Err(cause);
            }
        };
        let end = (self.time)(broken.as_ref().unwrap_or(after));
        let any = self.next.is_some_and(|t| t <= end);
        let told = self.tell(broken.as_ref());
        let told = told.and_then(|told| self.record_until(end, motion, before, after).map(|()| told));
        match (told, broken) {
            (Err(cause), broken) => {
                self.failed_at = broken;
                return Err(cause);
            }
            (Ok(GoesOn::FromAnother(after)), Some(before)) => self.changed = Some([before, after]),
            (Ok(GoesOn::No(state)), _) => return Ok(Some(state)),
            _ if any => self.look_at(motion, after),
            _ => {}
        }
        Ok(None)
    }

    /// Where the first of the events is from which the motion does not go on as it is.
    fn broken_off(
        &mut self,
        motion: &dyn Motion<X, R>,
        start: f64,
        before: &dyn Fn() -> X,
    ) -> Result<Option<X>, Error> {
        let Log { attend, between, happened, time, .. } = self;
        let time = *time;
        let first = |happened: &[Happened<X>]| {
            happened.iter().find(|event| event.breaks()).map(|event| event.event.state().clone())
        };
        in_order(happened, time);
        let mut broken = first(happened);
        // A wall that the whole step comes to the front of again may be behind where it is broken off.
        while O::CHANGES
            && let Some(end) = &broken
        {
            let (known, times) = (happened.len(), [start, time(end)]);
            let mut at = |t| between.state(motion, &before(), t);
            attend.meet_before(0, &mut Within { end, times, at: &mut at, happened })?;
            let earlier: Vec<_> =
                happened.drain(known..).filter(|event| time(event.event.state()) < times[1]).collect();
            if earlier.is_empty() {
                break;
            }
            happened.extend(earlier);
            in_order(happened, time);
            broken = first(happened);
        }
        Ok(broken)
    }

    /// Tells of what happened in the step until it was broken off, and changes the state there.
    fn tell(&mut self, broken: Option<&X>) -> Result<GoesOn<X>, Error> {
        let Log { run, attend, happened, time, .. } = self;
        let time = *time;
        let (mut state, mut passed, mut stops) = (broken.cloned(), false, false);
        for Happened { then, event } in happened.drain(..) {
            let told = match broken {
                // Found later by a rounding; a motion that goes on from the break would not pass it.
                Some(there) if passed => attend.is_behind(0, &event, there).then(|| event.at(there.clone())),
                // Found earlier by a rounding, but the break is before it: a motion that goes on from there will pass it.
                Some(there)
                    if then == After::Nothing
                        && is_rounding(time(event.state()), time(there))
                        && !attend.is_behind(0, &event, there) =>
                {
                    None
                }
                _ => Some(event),
            };
            let Some(mut event) = told else { continue };
            passed |= then != After::Nothing;
            stops |= then == After::Stop;
            if let (After::Change, Some(state)) = (then, &mut state) {
                if let Err(cause) = attend.change(0, &event, state) {
                    run.forget_repeats(&event, time);
                    return Err(cause);
                }
                event = event.changed_to(state.clone());
            }
            run.happened(event);
        }
        Ok(match state {
            None => GoesOn::AsItIs,
            Some(state) if stops => GoesOn::No(state),
            Some(state) => GoesOn::FromAnother(state),
        })
    }

    /// Records the states of the step that are due by then.
    fn record_until(
        &mut self,
        end: f64,
        motion: &dyn Motion<X, R>,
        before: &dyn Fn() -> X,
        after: &X,
    ) -> Result<(), Error> {
        while let Some(t) = self.next.filter(|&t| t <= end) {
            let at_end = t == (self.time)(after);
            let state = if at_end { after.clone() } else { self.between.state(motion, &before(), t)? };
            self.record_due(state)?;
        }
        Ok(())
    }

    /// Whether an event has changed the motion, which is to go on from there.
    pub(crate) fn is_changed(&self) -> bool {
        self.changed.is_some()
    }

    /// Goes on from where an event has changed the motion, if one has.
    pub(crate) fn change(&mut self, motion: &mut dyn Motion<X, R>) -> Result<bool, Error> {
        let Some([before, after]) = self.changed.take() else { return Ok(false) };
        let [from, to] = [&before, &after].map(self.time);
        let so_far = self.watch.deviations(motion, &before);
        let set =
            if from == to { motion.set_state(after) } else { Err(Error::ChangedTime { time: from, changed: to }) };
        if let Err(cause) = set {
            self.failed_at = Some(before);
            return Err(cause);
        }
        let state = motion.state();
        self.watch.go_on(motion, &state, so_far);
        self.attend.turn(&state);
        if let Some(end) = self.until {
            let span = Span::Until(end.max(from));
            self.ends_at = motion.steps() + span.steps(from, motion.dt(), motion.resolution())?;
        }
        Ok(true)
    }
}

/// How a motion goes on after a step.
enum GoesOn<X> {
    AsItIs,
    /// From where the step is broken off, by another state.
    FromAnother(X),
    /// It was stopped in this state, changed or not.
    No(X),
}
