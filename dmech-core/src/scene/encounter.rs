//! Encounters of bodies.

use std::collections::{BTreeMap, BTreeSet};

use super::builder::Scene;
use super::space::Space;
use super::state::SceneState;
use crate::error::{Error, SceneError};
use crate::run::{
    After, Attend, Attended, Change, Crossing, Event, Simulation, Wall, Within, is_further_behind, passes,
};
use crate::span::is_rounding;
use crate::vector::{difference, dot};

/// A simulation that looks for encounters of its bodies.
pub type Met<const D: usize, P, L, B, S, O, C = ()> = Attended<(), Scene<D, P, L, B>, S, O, Encounter<B, C>>;

impl<const D: usize, P, L, B: Space<D>, S, O> Simulation<(), Scene<D, P, L, B>, S, O> {
    /// Watches for pairs of bodies that come nearer to one another than a distance, which
    /// [`Run::events`](crate::Run::events) then has, with [`bodies`](crate::Event::bodies) and the state at that distance. Pairs
    /// that are nearer at the start have met before. A pair that comes and goes within one step may be missed; each step
    /// looks at all pairs.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    /// let scene = Scene::<1>::new().body(1.0, [0.0], [0.0]).body(1.0, [3.0], [-1.0]).body(1.0, [-9.0], [2.0]);
    /// let run = Simulation::scene(scene).scheme(Leapfrog).dt(0.3).encounter(0.5).run_until(6.0)?;
    /// let met: Vec<_> = run.events().iter().map(|event| (event.bodies().unwrap(), event.state().t)).collect();
    /// assert_eq!(met.len(), 3);
    /// assert!(met[0].0 == [0, 1] && (met[0].1 - 2.5).abs() < 1e-14);
    /// assert!(met[1].0 == [1, 2] && (met[1].1 - 11.5 / 3.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When run: [`SceneError::Encounter`] where the distance is not positive and finite.
    pub fn encounter(self, distance: f64) -> Met<D, P, L, B, S, O> {
        self.watch_for(distance, After::Nothing, ())
    }

    /// As [`encounter`](Simulation::encounter), and the run ends at the first, as at [`stop_when`](Simulation::stop_when): what goes on
    /// from [`Run::last`](crate::Run::last) stops at the next.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    /// let scene = Scene::<1>::new().body(1.0, [0.0], [0.0]).body(1.0, [3.0], [-1.0]);
    /// let run = Simulation::scene(scene).scheme(Leapfrog).dt(0.3).stop_at_encounter(0.5).run_until(6.0)?;
    /// assert!(run.stopped() && (run.last().t - 2.5).abs() < 1e-14);
    /// assert_eq!(run.events()[0].bodies(), Some([0, 1]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`encounter`](Simulation::encounter).
    pub fn stop_at_encounter(self, distance: f64) -> Met<D, P, L, B, S, O> {
        self.watch_for(distance, After::Stop, ())
    }

    /// Keeps bodies apart: where two come as near as a distance the motion goes on from another state, as hard balls of this diameter do.
    /// The function is given the state and the two bodies. It is [`bounce_off`](Simulation::bounce_off) for each pair.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    /// // Balls of equal mass and diameter 1/2 on a line exchange their velocities.
    /// let scene = Scene::<1>::new().body(1.0, [0.0], [1.0]).body(1.0, [2.0], [0.0]).body(1.0, [3.0], [0.0]);
    /// let balls = Simulation::scene(scene).scheme(Leapfrog).dt(0.25);
    /// let run = balls.collide_at(0.5, |state, [a, b]| state.v.swap(a, b)).run_until(4.0)?;
    /// let met: Vec<_> = run.events().iter().map(|event| (event.bodies().unwrap(), event.state().t)).collect();
    /// assert!(met[0].0 == [0, 1] && (met[0].1 - 1.5).abs() < 1e-14);
    /// assert!(met[1].0 == [1, 2] && (met[1].1 - 2.0).abs() < 1e-14);
    /// assert_eq!(run.last().v, [[0.0], [0.0], [1.0]]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Bodies that are nearer at the start may part, and are refused if they come nearer still. Those that pass through one another within a
    /// step are not kept apart. Where two come to rest on each other the whole run ends, as
    /// for a ball on a floor.
    ///
    /// # Errors
    /// As [`encounter`](Simulation::encounter) and [`change_when`](Simulation::change_when), and [`SceneError::Overlap`] where two bodies
    /// that are nearer come nearer still.
    pub fn collide_at<C: FnMut(&mut SceneState<D>, [usize; 2])>(
        self,
        distance: f64,
        change: C,
    ) -> Met<D, P, L, B, S, O, Collision<C>> {
        self.watch_for(distance, After::Change, Collision(change))
    }

    fn watch_for<C>(self, distance: f64, then: After, change: C) -> Met<D, P, L, B, S, O, C> {
        let (space, held) = (self.start.space, self.start.bodies.pins.iter().copied().collect());
        let (excess, starts, contacts, own) = (Vec::new(), Vec::new(), BTreeMap::new(), Vec::new());
        self.attended(Encounter { distance, space, held, then, excess, starts, change, contacts, own })
    }
}

/// The distance at which bodies meet, by how much the squares of the distances of all pairs exceed its own, and what it changes.
#[derive(Clone, Debug)]
pub struct Encounter<B, C = ()> {
    distance: f64,
    space: B,
    /// Bodies that no collision moves.
    held: BTreeSet<usize>,
    then: After,
    excess: Vec<f64>,
    /// The same at the start of the step.
    starts: Vec<f64>,
    change: C,
    /// Pairs that have just met, or touch, by their number.
    contacts: BTreeMap<usize, Wall>,
    /// Those whose motion is being changed, and the rounding before.
    own: Vec<(usize, f64)>,
}

/// A function that changes the state where two bodies meet.
#[derive(Clone, Copy)]
pub struct Collision<C>(C);

impl<C> core::fmt::Debug for Collision<C> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Collision")
    }
}

impl<X, C: FnMut(&mut X, [usize; 2])> Change<X> for Collision<C> {
    fn change(&mut self, event: &Event<X>, state: &mut X) {
        if let Some(bodies) = event.bodies() {
            (self.0)(state, bodies);
        }
    }
}

/// |q_a − q_b|² − r², in a periodic box to the nearest image.
fn excess<const D: usize>(state: &SceneState<D>, [a, b]: [usize; 2], distance: f64, space: &impl Space<D>) -> f64 {
    let d = space.image(difference(state.q[a], state.q[b]));
    dot(d, d) - distance * distance
}

fn pairs(bodies: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..bodies).flat_map(move |b| (0..b).map(move |a| [a, b]))
}

/// The number of a pair.
fn number([a, b]: [usize; 2]) -> usize {
    b * (b - 1) / 2 + a
}

/// What a few roundings of the places of a pair change in its excess.
fn rounding<const D: usize>(state: &SceneState<D>, [a, b]: [usize; 2], distance: f64) -> f64 {
    let far = |i: usize| state.q[i].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    // And of the time that it takes to get there.
    let speed = dot(difference(state.v[a], state.v[b]), difference(state.v[a], state.v[b])).sqrt();
    f64::EPSILON * distance * (16.0 * (distance + far(a) + far(b)) + 8.0 * state.t.abs() * speed)
}

impl<B, C> Encounter<B, C> {
    fn excess<const D: usize>(&self, state: &SceneState<D>, pair: [usize; 2]) -> f64
    where
        B: Space<D>,
    {
        excess(state, pair, self.distance, &self.space)
    }

    /// Of a pair between two values of the excess, the state in which it meets.
    fn meet<const D: usize>(
        &mut self,
        (k, pair): (usize, [usize; 2]),
        values: [f64; 2],
        step: &mut Within<'_, SceneState<D>>,
    ) -> Result<Option<SceneState<D>>, Error>
    where
        B: Space<D>,
        C: Change<SceneState<D>>,
    {
        let Encounter { distance, space, held, contacts, .. } = self;
        let mut function = |state: &SceneState<D>| excess(state, pair, *distance, space);
        let meets = passes(values, Crossing::Falling).is_some();
        if !C::CHANGES {
            return if meets { step.zero(values, &mut function).map(Some) } else { Ok(None) };
        }
        if meets || is_further_behind(values) && !pair.iter().all(|body| held.contains(body)) {
            contacts.entry(k).or_insert(Wall::FAR);
        }
        let Some(wall) = contacts.get_mut(&k) else { return Ok(None) };
        let ([a, b], distance, time) = (pair, *distance, step.times[0]);
        let behind =
            || SceneError::Overlap { a, b, apart: (values[0] + distance * distance).sqrt(), distance, time }.into();
        wall.meet(step, values, &mut function, |state, _| rounding(state, pair, distance), behind)
    }
}

impl<const D: usize, B: Space<D>, C: Change<SceneState<D>>> Attend<SceneState<D>> for Encounter<B, C> {
    const EVENTS: usize = 1;
    const CHANGES: bool = C::CHANGES;

    fn begin(&mut self, start: &SceneState<D>) -> Result<(), Error> {
        if !(self.distance > 0.0 && self.distance.is_finite()) {
            return Err(SceneError::Encounter { distance: self.distance }.into());
        }
        self.turn(start);
        Ok(())
    }

    fn meet(&mut self, which: usize, step: &mut Within<'_, SceneState<D>>) -> Result<(), Error> {
        if C::CHANGES {
            self.starts.clone_from(&self.excess);
        }
        for (k, pair) in pairs(step.end.q.len()).enumerate() {
            let now = self.excess(step.end, pair);
            let values = [core::mem::replace(&mut self.excess[k], now), now];
            if let Some(state) = self.meet((k, pair), values, step)? {
                step.happened(self.then, Event::new(which, state, Crossing::Falling, Some(pair)));
            }
        }
        let start = step.times[0];
        self.contacts.retain(|_, wall| wall.on || !wall.often.is_over(start));
        Ok(())
    }

    fn meet_before(&mut self, which: usize, step: &mut Within<'_, SceneState<D>>) -> Result<(), Error> {
        if !C::CHANGES {
            return Ok(());
        }
        let Encounter { distance, space, contacts, starts, .. } = self;
        for (k, pair) in pairs(step.end.q.len()).enumerate() {
            let mut function = |state: &SceneState<D>| excess(state, pair, *distance, space);
            let now = function(step.end);
            if now >= 0.0 {
                continue;
            }
            let wall = contacts.entry(k).or_insert(Wall::FAR);
            if let Some(state) =
                wall.meet_before(step, [starts[k], now], &mut function, |state, _| rounding(state, pair, *distance))?
            {
                step.happened(self.then, Event::new(which, state, Crossing::Falling, Some(pair)));
            }
        }
        Ok(())
    }

    fn is_behind(&mut self, _: usize, event: &Event<SceneState<D>>, state: &SceneState<D>) -> bool {
        let at_once = !C::CHANGES || is_rounding(event.state().t, state.t);
        at_once && event.bodies().is_some_and(|pair| self.excess(state, pair) <= 0.0)
    }

    fn change(&mut self, which: usize, event: &Event<SceneState<D>>, state: &mut SceneState<D>) -> Result<(), Error> {
        let Some(pair) = event.bodies() else { return Ok(()) };
        let k = number(pair);
        self.contacts.entry(k).or_insert(Wall::FAR).often.count(which, event.state().t)?;
        self.own.push((k, rounding(event.state(), pair, self.distance)));
        self.change.change(event, state);
        Ok(())
    }

    fn turn(&mut self, state: &SceneState<D>) {
        let Encounter { distance, space, excess: all, contacts, own, .. } = self;
        all.clear();
        for (k, pair) in pairs(state.q.len()).enumerate() {
            let value = excess(state, pair, *distance, space);
            all.push(value);
            let touches = || value.abs() <= rounding(state, pair, *distance);
            if C::CHANGES && (contacts.contains_key(&k) || touches()) {
                let wall = contacts.entry(k).or_insert(Wall::FAR);
                let changed = own.iter().find(|(of, _)| *of == k).map(|&(_, rounding)| rounding);
                wall.go_on(value, changed, || rounding(state, pair, *distance));
            }
        }
        own.clear();
    }
}
