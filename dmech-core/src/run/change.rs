//! Events that change the motion.

use super::event::{Crossing, Event};
use super::passage::Passage;
use super::simulation::{Attended, Simulation};
use crate::error::Error;
use crate::setup::Setup;

impl<L, X: Setup<L>, S, O> Simulation<L, X, S, O> {
    /// As [`event`](Simulation::event), and the motion goes on from another state: a thruster that fires, a membrane, a jump. The function
    /// may change positions and velocities; the time stays. What a motion does not get behind is said by
    /// [`bounce_off`](Simulation::bounce_off).
    ///
    /// It is what runs do that [stop](Simulation::stop_when) there and go on from the changed state. The step in which it happens counts as
    /// made; from the event on the steps have their full length again, and the scheme begins anew.
    /// [`run_until`](Simulation::run_until) makes as many as it takes from there. The state of the [event](crate::Event::state) is that
    /// before the change. What happens at the same time is told too, and changed, in the order in which it was asked for; after it, only
    /// what happens from the new state on. Of a scene, driven bodies stay on their paths.
    ///
    /// What the change does to the energy is not counted in its drift, nor in that of any invariant: they say how the law and the
    /// scheme have kept them from one change to the next, added up. What is [watched](Simulation::watch) has what it has.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/spring.md")]
    /// // A swing that is pushed on whenever it passes the middle to the right: it gains 1/10 of a unit of speed each time.
    /// let swing = Simulation::new(Spring { k: 1.0 }, State::new([1.0], [0.0])).scheme(Nystrom::order8()).dt(0.1);
    /// let run = swing.change_when(|state| state.q[0], Crossing::Rising, |state| state.v[0] += 0.1).run_until(20.0)?;
    /// for (n, event) in run.events().iter().enumerate() {
    ///     assert!((event.state().v[0] - (1.0 + 0.1 * n as f64)).abs() < 1e-10);
    /// }
    /// assert_eq!(run.events().len(), 3);
    /// assert!(run.drift(Invariant::Energy).unwrap().max_abs() < 1e-8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When run: [`Error::ChangedTime`](crate::Error::ChangedTime), what [`Stepper::set_state`](crate::Stepper::set_state) refuses,
    /// and [`Error::ComesToRest`](crate::Error::ComesToRest) for an event that happens more than 64 times within a step.
    pub fn change_when<F: FnMut(&X::State) -> f64, C: FnMut(&mut X::State)>(
        self,
        function: F,
        crossing: Crossing,
        change: C,
    ) -> Attended<L, X, S, O, Passage<F, Changed<C>>> {
        self.attended(Passage::changing(function, crossing, change))
    }
}

/// What an event does to the state.
pub trait Change<X> {
    /// Whether it does anything.
    const CHANGES: bool = true;

    /// Changes it.
    fn change(&mut self, event: &Event<X>, state: &mut X);
}

impl<X> Change<X> for () {
    const CHANGES: bool = false;

    fn change(&mut self, _: &Event<X>, _: &mut X) {}
}

/// A function that changes the state.
#[derive(Clone, Copy)]
pub struct Changed<C>(pub(super) C);

impl<C> core::fmt::Debug for Changed<C> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Changed")
    }
}

impl<X, C: FnMut(&mut X)> Change<X> for Changed<C> {
    fn change(&mut self, _: &Event<X>, state: &mut X) {
        (self.0)(state);
    }
}

/// How often an event has changed the motion within the time of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Often {
    /// The length of the last step.
    pub(crate) dt: f64,
    /// The time of the last change, and of the first of those that are counted.
    last: f64,
    first: f64,
    times: u32,
}

impl Often {
    pub(crate) const NEVER: Self = Often { dt: 0.0, last: f64::NEG_INFINITY, first: f64::NEG_INFINITY, times: 0 };
    const MOST: u32 = 64;

    /// Counts a change; too many within a step are refused.
    pub(crate) fn count(&mut self, event: usize, time: f64) -> Result<(), Error> {
        if time - self.first > self.dt {
            (self.first, self.times) = (time, 0);
        }
        self.times += 1;
        let since = time - core::mem::replace(&mut self.last, time);
        if self.times > Self::MOST { Err(Error::ComesToRest { event, time, since }) } else { Ok(()) }
    }

    /// Whether changes at an earlier time are no longer counted.
    #[cfg(feature = "scene")]
    pub(crate) fn is_over(&self, time: f64) -> bool {
        time - self.first > self.dt
    }
}
