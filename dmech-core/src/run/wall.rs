//! Walls: events that keep the motion on their front.

use dmech_scalar::Real;

use super::attend::{After, Attend, Within};
use super::between::{Weights, blend};
use super::change::{Change, Changed, Often};
use super::event::{Crossing, Event};
use super::simulation::{Attended, Simulation};
use crate::error::Error;
use crate::setup::Setup;
use crate::snapshot::Snapshot;
use crate::span::is_rounding;

impl<L, X: Setup<L>, S, O> Simulation<L, X, S, O> {
    /// Keeps the motion where a function of the state is positive: where it falls to zero is an event, at which the motion goes on from
    /// another state, as with [`change_when`](Simulation::change_when). A floor, a billiard, a moving piston.
    ///
    /// The function that changes the state turns the motion back. A hop is seen however short it is beside the step; if what is behind the
    /// wall at the end of a step has not left it, it is changed once more where it was: three balls that meet at once, a change of something
    /// else, a start on the wall. What bounces with a loss comes to rest after hops ever shorter: nothing holds it there, and the run
    /// ends with [`Error::ComesToRest`](crate::Error::ComesToRest) once there are more than 64 in a step, or none that its numbers tell.
    /// What is behind the wall by more than rounding, at the start or where something else has put it, may come to the front, and is held from
    /// there on; if it goes further behind it is refused. A wall that is passed and left again within one step may be missed. The function
    /// is continuous at the wall and negative behind it; what is no number is behind, too.
    ///
    /// The state of the event is the nearest to the zero of the function that the rounding of the time leaves.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/fall.md")]
    /// // A ball that is dropped from a height of 1 and gives back 9/10 of its speed: hops of 2 √2 (9/10)ⁿ.
    /// let ball = Simulation::new(Weight { g: 1.0 }, State::new([1.0], [0.0])).scheme(Leapfrog).dt(0.01);
    /// let run = ball.bounce_off(|state| state.q[0], |state| state.v[0] *= -0.9).run_until(12.0)?;
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
    /// [`Error::BehindWall`](crate::Error::BehindWall), and as [`change_when`](Simulation::change_when).
    pub fn bounce_off<F: FnMut(&X::State) -> f64, C: FnMut(&mut X::State)>(
        self,
        function: F,
        change: C,
    ) -> Attended<L, X, S, O, Bounce<F, C>> {
        self.attended(Bounce::new(function, change))
    }
}

/// What a motion may be behind a wall by rounding alone, beside what its time moves it: it may have come there many times as fast as it leaves.
const ROUNDING: f64 = 4096.0 * f64::EPSILON;

/// Whether a motion that is behind a wall at the start of a step is further behind at its end. What is no number is behind.
pub(crate) fn is_further_behind([start, end]: [f64; 2]) -> bool {
    let comes = end > 0.0 || end >= start;
    !(start >= 0.0 || comes)
}

/// What is known of a motion and a wall.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wall {
    /// The motion is on it, to rounding, and not behind: it has begun there, or was changed there.
    pub(crate) on: bool,
    /// How far from zero it was then.
    off: f64,
    /// The step has left it, if nothing happens in it.
    leaves: bool,
    /// So far behind it may be where the step is broken off: that is rounding.
    rounding: f64,
    pub(crate) often: Often,
}

impl Wall {
    pub(crate) const FAR: Self = Wall { on: false, off: 0.0, leaves: false, rounding: 0.0, often: Often::NEVER };

    /// The motion goes on from a state with this value, by its own change, before which its rounding was this, or otherwise. What was put
    /// in front begins there.
    pub(crate) fn go_on(&mut self, value: f64, changed: Option<f64>, rounding: impl FnOnce() -> f64) {
        let (off, own) = (value.abs(), changed.is_some());
        let least = rounding().max(changed.unwrap_or(0.0)).max(core::mem::take(&mut self.rounding));
        let stays = self.on && off <= self.off;
        self.on = off <= least || own && value < 0.0 || stays;
        self.off = if stays { self.off } else { off.min(least) };
        self.leaves = false;
    }

    /// Where the function falls to zero in a step, from its values at the ends; refused where the motion is behind and goes further.
    pub(crate) fn meet<X: Clone>(
        &mut self,
        step: &mut Within<'_, X>,
        values: [f64; 2],
        function: &mut impl FnMut(&X) -> f64,
        rounding: impl Fn(&X, &mut dyn FnMut(&X) -> f64) -> f64,
        behind: impl FnOnce() -> Error,
    ) -> Result<Option<X>, Error> {
        self.often.dt = step.times[1] - step.times[0];
        self.on &= !self.leaves;
        self.leaves = false;
        if !self.on && is_further_behind(values) {
            let [start, end] = step.times;
            // What the rounding of the time moves it, as fast as it is in this step.
            let in_time = (1.0 + start.abs().max(end.abs()) / (end - start)) * (values[1] - values[0]).abs();
            let depth = -values[0];
            self.on = depth <= rounding(step.end, function).max(ROUNDING * in_time);
            if !self.on {
                return Err(behind());
            }
            self.off = depth;
        }
        if self.on {
            let (now, least) = (values[1], self.off.max(rounding(step.end, function)));
            self.leaves = now > least;
            if now >= -least {
                return Ok(None);
            }
        }
        self.falls(step, values[0], function, rounding)
    }

    /// Where it has fallen to zero before a state in which something else has happened, and which is clearly behind it.
    pub(crate) fn meet_before<X: Clone>(
        &mut self,
        step: &mut Within<'_, X>,
        [before, now]: [f64; 2],
        function: &mut impl FnMut(&X) -> f64,
        rounding: impl Fn(&X, &mut dyn FnMut(&X) -> f64) -> f64,
    ) -> Result<Option<X>, Error> {
        let least = rounding(step.end, function).max(if self.on { self.off } else { 0.0 });
        if now >= -least {
            self.rounding = least;
            return Ok(None);
        }
        self.falls(step, before, function, rounding)
    }

    fn falls<X: Clone>(
        &self,
        step: &mut Within<'_, X>,
        before: f64,
        function: &mut impl FnMut(&X) -> f64,
        rounding: impl Fn(&X, &mut dyn FnMut(&X) -> f64) -> f64,
    ) -> Result<Option<X>, Error> {
        let [start, end] = step.times;
        // What is 0 or no number is behind.
        let mut value = |state: &X| match function(state) {
            x if x > 0.0 => x,
            x if x <= 0.0 => x.min(-f64::MIN_POSITIVE),
            _ => f64::NEG_INFINITY,
        };
        let end_value = value(step.end);
        if !self.on {
            let falls = before > 0.0 && end_value < 0.0;
            let values = [before, end_value];
            return if falls { step.zero_from(start, values, true, &mut value).map(Some) } else { Ok(None) };
        }
        // Of a hop shorter than the step the second half has one of these times. Near its start the sign is one of roundings.
        let mut top = (start, 0.0);
        for k in 1..=60 {
            let time = start + (end - start) * 0.5_f64.powi(k);
            if is_rounding(start, time) {
                break;
            }
            if let Some(value) = step.value(time, &mut value)?
                && value > top.1
            {
                top = (time, value);
            } else if top.1 > 0.0 {
                break;
            }
        }
        let here = (step.at)(top.0)?;
        if top.1 > rounding(&here, &mut value) {
            return step.zero_from(top.0, [top.1, end_value], true, &mut value).map(Some);
        }
        if top.0 == start { Ok(Some(here)) } else { (step.at)(start).map(Some) }
    }
}

/// What a few roundings of the state, and of the time that it takes to get there, change in a function of it.
pub(crate) fn rounding<X: Snapshot>(state: &X, function: &mut dyn FnMut(&X) -> f64) -> f64 {
    let (value, time, half) = (function(state), state.time(), X::DIMENSION * state.bodies());
    let mut off = |other: &X| (function(other) - value).abs();
    // Any two of the numbers go different ways at least once.
    let ways = (0..usize::BITS).map(|bit| 1_usize << bit).take_while(|&bit| bit < 2 * (1 + 2 * half));
    let nudged = ways.map(|bit| off(&nudged(state, half, |k| (k + 1) & bit != 0))).fold(0.0, f64::max);
    let later = 4.0 * f64::EPSILON * time.abs();
    let weights = Weights { position: [1.0, later], velocity: [0.0, 1.0] };
    nudged.max(off(&blend(time + later, core::slice::from_ref(state), &[weights])))
}

/// The same but for roundings: eight up or eight down in its time and each of its numbers, of each list so many, as their places say.
fn nudged<X: Snapshot>(state: &X, half: usize, up: impl Fn(usize) -> bool) -> X {
    X::from_numbers(nudge(state.time(), up(0)), state.bodies(), |list, i| {
        nudge(state.number(list, i), up(1 + list * half + i))
    })
}

/// A number eight roundings up or down, in the scalar of its motion but not finer than in `f64`.
fn nudge<R: Real>(x: R, up: bool) -> R {
    let by = 8.0 * R::EPSILON.to_f64().max(f64::EPSILON);
    x * R::from_f64(if up { 1.0 + by } else { 1.0 - by })
}

/// A function of the state that keeps the motion where it is positive, and what does so.
#[derive(Clone)]
pub struct Bounce<F, C> {
    function: F,
    change: Changed<C>,
    /// Its values at the ends of the last step.
    values: [f64; 2],
    wall: Wall,
    /// It has just changed the state, of which this was the rounding.
    own: Option<f64>,
}

impl<F, C> Bounce<F, C> {
    pub(crate) fn new(function: F, change: C) -> Self {
        Bounce { function, change: Changed(change), values: [0.0; 2], wall: Wall::FAR, own: None }
    }
}

impl<F, C> core::fmt::Debug for Bounce<F, C> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Bounce").field("values", &self.values).field("wall", &self.wall).finish_non_exhaustive()
    }
}

impl<X: Snapshot, F: FnMut(&X) -> f64, C: FnMut(&mut X)> Attend<X> for Bounce<F, C> {
    const EVENTS: usize = 1;
    const CHANGES: bool = true;

    fn begin(&mut self, start: &X) -> Result<(), Error> {
        self.turn(start);
        Ok(())
    }

    fn meet(&mut self, which: usize, step: &mut Within<'_, X>) -> Result<(), Error> {
        let Bounce { function, values, wall, .. } = self;
        *values = [values[1], function(step.end)];
        let ([value, _], time) = (*values, step.times[0]);
        let behind = || Error::BehindWall { event: which, time, value };
        if let Some(state) = wall.meet(step, *values, function, |state, function| rounding(state, function), behind)? {
            step.happened(After::Change, Event::new(which, state, Crossing::Falling, None));
        }
        Ok(())
    }

    fn meet_before(&mut self, which: usize, step: &mut Within<'_, X>) -> Result<(), Error> {
        let Bounce { function, values: [before, _], wall, .. } = self;
        let values = [*before, function(step.end)];
        if let Some(state) = wall.meet_before(step, values, function, |state, function| rounding(state, function))? {
            step.happened(After::Change, Event::new(which, state, Crossing::Falling, None));
        }
        Ok(())
    }

    fn is_behind(&mut self, _: usize, event: &Event<X>, state: &X) -> bool {
        is_rounding(event.state().time(), state.time()) && (self.function)(state) <= 0.0
    }

    fn change(&mut self, which: usize, event: &Event<X>, state: &mut X) -> Result<(), Error> {
        self.wall.often.count(which, event.state().time())?;
        self.own = Some(rounding(state, &mut self.function));
        self.change.change(event, state);
        Ok(())
    }

    fn turn(&mut self, state: &X) {
        let Bounce { function, values: [_, last], wall, own, .. } = self;
        *last = function(state);
        wall.go_on(*last, own.take(), || rounding(state, function));
    }
}
