//! Events: where a function of the state passes through zero.

use super::attend::{After, Attend, Within};
use super::change::{Change, Changed, Often};
use super::event::{Crossing, Event};
use super::simulation::{Attended, Simulation};
use crate::error::Error;
use crate::setup::Setup;
use crate::snapshot::Snapshot;

impl<L, X: Setup<L>, S, O> Simulation<L, X, S, O> {
    /// Watches for passages of a function of the state through zero, which [`Run::events`](crate::Run::events) then has: a
    /// plane that is crossed, a turning point, an angle.
    ///
    /// The sign is looked at after each step. Where it has changed, the time is found to its rounding by shortened steps of the
    /// same scheme, so that the event has the order of the scheme and the steps do not move. Several events of one step come in
    /// the order of their times. A zero at the start is none; one that falls on the end of a step is counted
    /// once, when it is reached, also where the function turns back there. Where rounding leaves no time at which the function is zero, the
    /// state is the first behind the passage, so that a motion that goes on from there does not pass again; so it is where a force jumps at
    /// the passage and no shortened step of an implicit scheme ends there. A function that passes through
    /// zero twice within one step may be missed: take steps shorter than it lasts. A value that is NaN is on no side of zero, and a
    /// function that has no other is never an event; [watched](Simulation::watch), its drift is NaN.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/spring.md")]
    /// let spring = Simulation::new(Spring { k: 4.0 }, State::new([1.0], [0.0])).scheme(Nystrom::order8()).dt(0.1);
    /// let run = spring.event(|state| state.q[0], Crossing::Falling).record_every(100).run_until(10.0)?;
    /// let quarter = std::f64::consts::FRAC_PI_4;
    /// for (n, event) in run.events().iter().enumerate() {
    ///     assert!((event.state().t - quarter * (1.0 + 4.0 * n as f64)).abs() < 1e-10);
    /// }
    /// assert_eq!(run.events().len(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn event<F: FnMut(&X::State) -> f64>(
        self,
        function: F,
        crossing: Crossing,
    ) -> Attended<L, X, S, O, Passage<F>> {
        self.attended(Passage::new(function, crossing, After::Nothing))
    }

    /// As [`event`](Simulation::event), and the run ends there: [`Run::last`](crate::Run::last) is the state at the event,
    /// [`Run::stopped`](crate::Run::stopped) says so, and the step in which it happened counts as made. What else has happened by then
    /// is an event of this run, to the last rounding of the time; what has not, one of the run that goes on from there.
    pub fn stop_when<F: FnMut(&X::State) -> f64>(
        self,
        function: F,
        crossing: Crossing,
    ) -> Attended<L, X, S, O, Passage<F>> {
        self.attended(Passage::new(function, crossing, After::Stop))
    }
}

/// The direction in which a function passes through zero between two values, if it does and is asked for.
pub(crate) fn passes([before, now]: [f64; 2], crossing: Crossing) -> Option<Crossing> {
    let rising = before < 0.0 && now >= 0.0;
    let passes = (rising || before > 0.0 && now <= 0.0) && crossing.admits(rising);
    passes.then_some(if rising { Crossing::Rising } else { Crossing::Falling })
}

/// A function of the state whose passages through zero are events, and what they change.
#[derive(Clone)]
pub struct Passage<F, C = ()> {
    function: F,
    crossing: Crossing,
    then: After,
    /// Its last value: the side on which the motion is.
    last: f64,
    change: C,
    often: Often,
}

impl<F> Passage<F> {
    pub(crate) fn new(function: F, crossing: Crossing, then: After) -> Self {
        Passage::with(function, crossing, then, ())
    }
}

impl<F, C> Passage<F, Changed<C>> {
    pub(crate) fn changing(function: F, crossing: Crossing, change: C) -> Self {
        Passage::with(function, crossing, After::Change, Changed(change))
    }
}

impl<F, C> Passage<F, C> {
    fn with(function: F, crossing: Crossing, then: After, change: C) -> Self {
        Passage { function, crossing, then, last: 0.0, change, often: Often::NEVER }
    }
}

impl<F, C> core::fmt::Debug for Passage<F, C> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Passage { crossing, then, last, .. } = self;
        f.debug_struct("Passage").field("crossing", crossing).field("then", then).field("last", last).finish()
    }
}

impl<X: Snapshot, F: FnMut(&X) -> f64, C: Change<X>> Attend<X> for Passage<F, C> {
    const EVENTS: usize = 1;
    const CHANGES: bool = C::CHANGES;

    fn begin(&mut self, start: &X) -> Result<(), Error> {
        self.last = (self.function)(start);
        Ok(())
    }

    fn meet(&mut self, which: usize, step: &mut Within<'_, X>) -> Result<(), Error> {
        let Passage { function, crossing, then, last, often, .. } = self;
        let now = function(step.end);
        let values = [core::mem::replace(last, now), now];
        let Some(crossing) = passes(values, *crossing) else { return Ok(()) };
        let state = step.zero(values, function)?;
        often.dt = step.times[1] - step.times[0];
        step.happened(*then, Event::new(which, state, crossing, None));
        Ok(())
    }

    fn is_behind(&mut self, _: usize, event: &Event<X>, state: &X) -> bool {
        let value = (self.function)(state);
        if event.crossing() == Crossing::Rising { value >= 0.0 } else { value <= 0.0 }
    }

    fn change(&mut self, which: usize, event: &Event<X>, state: &mut X) -> Result<(), Error> {
        self.often.count(which, event.state().time())?;
        self.change.change(event, state);
        Ok(())
    }

    fn turn(&mut self, state: &X) {
        self.last = (self.function)(state);
    }
}
