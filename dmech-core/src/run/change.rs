//! Events that change the motion.

use super::attend::Within;
use super::between::{Blend, Weights};
use super::event::{Crossing, Event};
use super::passage::Passage;
use super::simulation::{Attended, Simulation};
use crate::error::Error;
use crate::setup::Setup;

impl<L, X: Setup<L>, S, O> Simulation<L, X, S, O> {
    /// As [`event`](Simulation::event), and the motion goes on from another state: a ball that bounces, a billiard, a thruster that
    /// fires. The function may change positions and velocities; the time stays.
    ///
    /// The step in which it happens counts as made. From the event on the steps have their full length again, and the scheme begins anew,
    /// as with [`Stepper::set_state`](crate::Stepper::set_state); [`run_until`](Simulation::run_until) makes as many as it takes from there.
    /// The state of the [event](crate::Event::state) is that before the change. What happens at the same time is told too, and what
    /// it changes is changed, in the order in which the events were asked for; after it, only what happens from the new state on.
    ///
    /// A function that is sent back is seen to return, however short the hop beside the step. What bounces with a loss comes to rest after
    /// hops ever shorter: no event holds it there, and the run ends with [`Error::ComesToRest`](crate::Error::ComesToRest) once there are
    /// more than 64 in a step, or none that its numbers tell. A change that lets the motion through, as a push does, is no return.
    ///
    /// What the change does to the energy is not counted in its drift, nor in that of any invariant: they say how the law and the
    /// scheme have kept them from one change to the next, added up. What is [watched](Simulation::watch) has what it has.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/fall.md")]
    /// // A ball that is dropped from a height of 1 and gives back 9/10 of its speed: hops of 2 √2 (9/10)ⁿ.
    /// let ball = Simulation::new(Weight { g: 1.0 }, State::new([1.0], [0.0])).scheme(Leapfrog).dt(0.01);
    /// let run = ball.change_when(|state| state.q[0], Crossing::Falling, |state| state.v[0] *= -0.9).run_until(12.0)?;
    /// let mut t = 2.0_f64.sqrt();
    /// for (n, event) in run.events().iter().enumerate() {
    ///     assert!((event.state().t - t).abs() < 1e-12);
    ///     t += 2.0 * 2.0_f64.sqrt() * 0.9_f64.powi(n as i32 + 1);
    /// }
    /// assert_eq!(run.events().len(), 6);
    /// assert!(run.drift(Invariant::Energy).unwrap().max_abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When run: [`Error::ComesToRest`](crate::Error::ComesToRest); [`Error::ChangedTime`](crate::Error::ChangedTime), and what
    /// [`Stepper::set_state`](crate::Stepper::set_state) refuses.
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

/// How often one event may change the motion within the time of a step.
const OFTEN: u32 = 64;

/// A function of the state that a change may have sent back to the side of zero from which it came.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turned {
    /// That side: 1 or −1.
    front: f64,
    /// It was sent there, and has not been seen there since.
    pub(crate) waits: bool,
    /// How far behind it was before it was sent there.
    sent_from: Option<f64>,
    /// The length of the step of the last change.
    dt: f64,
    /// The time of the last change, and of the first and their number in the time of a step.
    last: f64,
    first: f64,
    times: u32,
}

impl Turned {
    pub(crate) const NEVER: Self = {
        let never = f64::NEG_INFINITY;
        Turned { front: 0.0, waits: false, sent_from: None, dt: 0.0, last: never, first: never, times: 0 }
    };

    /// The direction of a passage from there.
    pub(crate) fn crossing(&self) -> Crossing {
        if self.front < 0.0 { Crossing::Rising } else { Crossing::Falling }
    }

    fn is_front(&self, value: f64) -> bool {
        value * self.front > 0.0
    }

    /// Counts a change; too many within a step are refused.
    pub(crate) fn count(&mut self, event: usize, time: f64, [start, end]: [f64; 2]) -> Result<(), Error> {
        self.dt = end - start;
        if time - self.first > self.dt {
            (self.first, self.times) = (time, 0);
        }
        self.times += 1;
        let since = time - core::mem::replace(&mut self.last, time);
        if self.times > OFTEN { Err(Error::ComesToRest { event, time, since }) } else { Ok(()) }
    }

    /// Changes the state at an event. What leads on in the same direction lets it through.
    pub(crate) fn change<X: Blend>(
        &mut self,
        event: &Event<X>,
        state: &mut X,
        change: &mut impl Change<X>,
        function: &mut impl FnMut(&X) -> f64,
    ) {
        self.front = if event.crossing() == Crossing::Rising { -1.0 } else { 1.0 };
        let before = function(state).abs();
        change.change(event, state);
        self.waits = false;
        self.sent_from = (!self.leads_on(state, function)).then_some(before);
    }

    /// The motion goes on from a state with this value. What was set farther behind does not wait to be seen in front.
    pub(crate) fn turn(&mut self, value: f64) {
        let is_behind = value * self.front <= 0.0;
        self.waits = is_behind && self.sent_from.take().map_or(self.waits, |from| value.abs() <= from);
    }

    /// Where a function that waits at the start of a step is back at zero within it.
    pub(crate) fn returns<X: Blend + Clone>(
        &mut self,
        event: usize,
        step: &mut Within<'_, X>,
        now: f64,
        function: &mut impl FnMut(&X) -> f64,
    ) -> Result<Option<X>, Error> {
        let [start, end] = step.times;
        if self.is_front(now) || now.is_nan() {
            self.waits = false;
            return Ok(None);
        }
        // Of a hop shorter than the step the second half has one of these times.
        for k in 1..=60 {
            let time = start + (end - start) * 0.5_f64.powi(k);
            if time <= start {
                break;
            }
            let value = match (step.at)(time) {
                Err(Error::NotConverged { .. } | Error::NotFinite { .. }) => continue,
                state => function(&state?),
            };
            if self.is_front(value) {
                return step.zero_from(time, [value, now], function).map(Some);
            }
        }
        let here = (step.at)(start)?;
        // Another change has sent it back again.
        if self.leads_on(&here, function) {
            return Ok(Some(here));
        }
        Err(Error::ComesToRest { event, time: start, since: 0.0 })
    }

    /// Whether the velocity of a state leads on behind zero. A function of the velocity itself is where it was set.
    fn leads_on<X: Blend>(&self, state: &X, function: &mut impl FnMut(&X) -> f64) -> bool {
        let mut value = |later: f64, velocity| {
            let weights = Weights { position: [1.0, later], velocity };
            function(&X::blend(state.time() + later, core::slice::from_ref(state), &[weights]))
        };
        let other_velocity = value(0.0, [1.0, 2.0]);
        if other_velocity != value(0.0, [0.0, 1.0]) {
            return true;
        }
        // So little of the step that it does not lead through and out again.
        let way = self.dt / 64.0;
        (value(way, [0.0, 1.0]) - value(-way, [0.0, 1.0])) * self.front < 0.0
    }
}
