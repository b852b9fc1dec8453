//! What accompanies a run.

use core::ops::ControlFlow;

use super::event::Event;
use super::zero::zero;
use crate::drift::Drift;
use crate::error::Error;

/// What accompanies a run beside its record: events, observers, streams, watched quantities. They stand in a list in the type
/// of the simulation, so that nothing is left of them in a run that has none.
pub trait Attend<X> {
    /// How many events it looks for.
    const EVENTS: usize = 0;
    /// Whether it looks at states at the end of steps.
    const OBSERVES: bool = false;
    /// Whether it takes the recorded states.
    const STREAMS: bool = false;
    /// Whether its events may change the state.
    const CHANGES: bool = false;

    /// How many quantities it watches.
    const QUANTITIES: usize = 0;

    /// Looks at the first state.
    ///
    /// # Errors
    /// [`Error`] for what cannot be looked for.
    fn begin(&mut self, _start: &X) -> Result<(), Error> {
        Ok(())
    }

    /// Finds what happened within a step; the number of its first event is `which`.
    ///
    /// # Errors
    /// [`Error`] of the shortened steps.
    fn meet(&mut self, _which: usize, _step: &mut Within<'_, X>) -> Result<(), Error> {
        Ok(())
    }

    /// Finds what must have happened before the end of a step, at which the motion does not go on: walls that it is behind of there.
    ///
    /// # Errors
    /// As [`meet`](Attend::meet).
    fn meet_before(&mut self, _which: usize, _step: &mut Within<'_, X>) -> Result<(), Error> {
        Ok(())
    }

    /// Whether an event that was found in a step is behind a state of that step, too; the number of its first event is `which`.
    fn is_behind(&mut self, _which: usize, _event: &Event<X>, _state: &X) -> bool {
        false
    }

    /// Changes the state at one of its events; the number of its first is `which`.
    ///
    /// # Errors
    /// [`Error::ComesToRest`]
    fn change(&mut self, _which: usize, _event: &Event<X>, _state: &mut X) -> Result<(), Error> {
        Ok(())
    }

    /// The motion goes on from a state that was changed.
    fn turn(&mut self, _state: &X) {}

    /// After so many steps, may look at the state, and stop the run.
    fn observe(&mut self, _steps: u64, _now: &mut dyn FnMut() -> X) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Looks at a state as the invariants are looked at: the first, the recorded and the last; tells how far each watched quantity is
    /// from its value at the start.
    fn look(&mut self, _t: f64, _state: &X, _see: &mut dyn FnMut(f64)) {}

    /// How the watched quantities moved.
    fn drifts(&self, _see: &mut dyn FnMut(&'static str, Drift)) {}

    /// Takes a recorded state, which the run then does not keep.
    ///
    /// # Errors
    /// [`Error::Stream`]
    fn take(&mut self, _state: &X) -> Result<bool, Error> {
        Ok(false)
    }

    /// The run has ended.
    ///
    /// # Errors
    /// [`Error::Stream`]
    fn end(&mut self) -> Result<(), Error> {
        Ok(())
    }
}

impl<X> Attend<X> for () {}

impl<X, A: Attend<X>, B: Attend<X>> Attend<X> for (A, B) {
    const EVENTS: usize = A::EVENTS + B::EVENTS;
    const OBSERVES: bool = A::OBSERVES || B::OBSERVES;
    const STREAMS: bool = A::STREAMS || B::STREAMS;
    const CHANGES: bool = A::CHANGES || B::CHANGES;
    const QUANTITIES: usize = A::QUANTITIES + B::QUANTITIES;

    fn begin(&mut self, start: &X) -> Result<(), Error> {
        self.0.begin(start)?;
        self.1.begin(start)
    }

    fn meet(&mut self, which: usize, step: &mut Within<'_, X>) -> Result<(), Error> {
        self.0.meet(which, step)?;
        self.1.meet(which + A::EVENTS, step)
    }

    fn meet_before(&mut self, which: usize, step: &mut Within<'_, X>) -> Result<(), Error> {
        self.0.meet_before(which, step)?;
        self.1.meet_before(which + A::EVENTS, step)
    }

    fn is_behind(&mut self, which: usize, event: &Event<X>, state: &X) -> bool {
        let others = which + A::EVENTS;
        if event.which() < others {
            self.0.is_behind(which, event, state)
        } else {
            self.1.is_behind(others, event, state)
        }
    }

    fn change(&mut self, which: usize, event: &Event<X>, state: &mut X) -> Result<(), Error> {
        let others = which + A::EVENTS;
        if event.which() < others { self.0.change(which, event, state) } else { self.1.change(others, event, state) }
    }

    fn turn(&mut self, state: &X) {
        self.0.turn(state);
        self.1.turn(state);
    }

    fn observe(&mut self, steps: u64, now: &mut dyn FnMut() -> X) -> ControlFlow<()> {
        // Both look, also where one stops the run.
        match [self.0.observe(steps, now), self.1.observe(steps, now)] {
            [ControlFlow::Continue(()), ControlFlow::Continue(())] => ControlFlow::Continue(()),
            _ => ControlFlow::Break(()),
        }
    }

    fn look(&mut self, t: f64, state: &X, see: &mut dyn FnMut(f64)) {
        self.0.look(t, state, see);
        self.1.look(t, state, see);
    }

    fn drifts(&self, see: &mut dyn FnMut(&'static str, Drift)) {
        self.0.drifts(see);
        self.1.drifts(see);
    }

    fn take(&mut self, state: &X) -> Result<bool, Error> {
        Ok(self.0.take(state)? | self.1.take(state)?)
    }

    fn end(&mut self) -> Result<(), Error> {
        self.0.end().and(self.1.end())
    }
}

/// A step, and the states within it.
pub struct Within<'a, X> {
    /// The state at its end.
    pub end: &'a X,
    /// The times of its ends.
    pub times: [f64; 2],
    pub(super) at: &'a mut dyn FnMut(f64) -> Result<X, Error>,
    pub(super) happened: &'a mut Vec<Happened<X>>,
}

/// What comes after an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum After {
    /// The motion goes on as it is.
    Nothing,
    /// A change of the state, from which it goes on.
    Change,
    /// The end of the run.
    Stop,
}

/// An event, and what comes after it.
pub(super) struct Happened<X> {
    pub(super) then: After,
    pub(super) event: Event<X>,
}

impl<X> Happened<X> {
    /// Whether the motion does not go on through it.
    pub(super) fn breaks(&self) -> bool {
        self.then != After::Nothing
    }
}

/// Puts what happened in a step in the order of its times; compiled once for all schemes.
pub(super) fn in_order<X>(happened: &mut [Happened<X>], time: fn(&X) -> f64) {
    happened.sort_by(|a, b| time(a.event.state()).total_cmp(&time(b.event.state())));
}

impl<X: Clone> Within<'_, X> {
    /// The state where a function is zero that has these values, of different signs, at the ends of the step. Where a force jumps a
    /// shortened step may have no end on the seam: then it is the first state behind it that one has.
    ///
    /// # Errors
    /// [`Error`] of the shortened steps.
    pub fn zero(&mut self, values: [f64; 2], function: &mut impl FnMut(&X) -> f64) -> Result<X, Error> {
        self.zero_from(self.times[0], values, false, function)
    }

    /// The same between a time and the end of the step, or the state nearest to the zero, whichever side it is on.
    pub(crate) fn zero_from(
        &mut self,
        start: f64,
        values: [f64; 2],
        nearest: bool,
        function: &mut impl FnMut(&X) -> f64,
    ) -> Result<X, Error> {
        let end = self.times[1];
        if values[1] == 0.0 {
            return Ok(self.end.clone());
        }
        let mut value = |time| self.value(time, function).map(|value| value.unwrap_or(values[0]));
        let time = zero(&mut value, [start, end], values, nearest)?;
        if time == end { Ok(self.end.clone()) } else { (self.at)(time) }
    }

    /// The value of a function at a time in the step; nothing where no shortened step ends, or on a pole.
    pub(crate) fn value(&mut self, time: f64, function: &mut impl FnMut(&X) -> f64) -> Result<Option<f64>, Error> {
        match (self.at)(time) {
            Err(Error::NotConverged { .. } | Error::NotFinite { .. }) => Ok(None),
            state => state.map(|state| Some(function(&state))),
        }
    }

    /// Tells of an event, and what comes after it.
    pub fn happened(&mut self, then: After, event: Event<X>) {
        self.happened.push(Happened { then, event });
    }
}

impl<X: core::fmt::Debug> core::fmt::Debug for Within<'_, X> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Within").field("end", self.end).field("times", &self.times).finish_non_exhaustive()
    }
}
