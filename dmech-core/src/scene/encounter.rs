//! Encounters of bodies.

use super::builder::Scene;
use super::space::Space;
use super::state::SceneState;
use crate::error::{Error, SceneError};
use crate::run::{Attend, Attended, Crossing, Event, Simulation, Within};
use crate::vector::{difference, dot};

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
    pub fn encounter(self, distance: f64) -> Attended<(), Scene<D, P, L, B>, S, O, Encounter<B>> {
        self.watch_for(distance, false)
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
    pub fn stop_at_encounter(self, distance: f64) -> Attended<(), Scene<D, P, L, B>, S, O, Encounter<B>> {
        self.watch_for(distance, true)
    }

    fn watch_for(self, distance: f64, stops: bool) -> Attended<(), Scene<D, P, L, B>, S, O, Encounter<B>> {
        let space = self.start.space;
        self.attended(Encounter { distance, space, stops, excess: Vec::new() })
    }
}

/// The distance at which bodies meet, and by how much the squares of the distances of all pairs exceed its own.
#[derive(Clone, Debug)]
pub struct Encounter<B> {
    distance: f64,
    space: B,
    stops: bool,
    excess: Vec<f64>,
}

/// |q_a − q_b|² − r², in a periodic box to the nearest image.
fn excess<const D: usize>(state: &SceneState<D>, [a, b]: [usize; 2], distance: f64, space: &impl Space<D>) -> f64 {
    let d = space.image(difference(state.q[a], state.q[b]));
    dot(d, d) - distance * distance
}

fn pairs(bodies: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..bodies).flat_map(move |b| (0..b).map(move |a| [a, b]))
}

impl<const D: usize, B: Space<D>> Attend<SceneState<D>> for Encounter<B> {
    const EVENTS: usize = 1;

    fn begin(&mut self, start: &SceneState<D>) -> Result<(), Error> {
        if !(self.distance > 0.0 && self.distance.is_finite()) {
            return Err(SceneError::Encounter { distance: self.distance }.into());
        }
        self.excess = pairs(start.q.len()).map(|pair| excess(start, pair, self.distance, &self.space)).collect();
        Ok(())
    }

    fn meet(&mut self, which: usize, step: &mut Within<'_, SceneState<D>>) -> Result<(), Error> {
        for (pair, last) in pairs(step.end.q.len()).zip(&mut self.excess) {
            let now = excess(step.end, pair, self.distance, &self.space);
            let before = core::mem::replace(last, now);
            if before > 0.0 && now <= 0.0 {
                let mut function = |state: &SceneState<D>| excess(state, pair, self.distance, &self.space);
                let state = step.zero([before, now], &mut function)?;
                step.happened(self.stops, Event::new(which, state, Crossing::Falling, Some(pair)));
            }
        }
        Ok(())
    }

    fn is_behind(&mut self, _: usize, event: &Event<SceneState<D>>, state: &SceneState<D>) -> bool {
        event.bodies().is_some_and(|pair| excess(state, pair, self.distance, &self.space) <= 0.0)
    }
}
