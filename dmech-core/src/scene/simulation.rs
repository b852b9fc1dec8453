//! Running a scene.

use super::builder::Scene;
use super::scheme::SceneScheme;
use super::state::SceneState;
use super::stepper::SceneStepper;
use super::terms::Term;
use crate::error::{Error, Interrupted};
use crate::motion::{record, steps_until};
use crate::progress::Shown;
use crate::run::Run;
use crate::simulation::{NoScheme, Simulation};

impl<const D: usize, P, L> Simulation<(), Scene<D, P, L>> {
    /// The bodies of a scene under its laws.
    pub fn scene(scene: Scene<D, P, L>) -> Self {
        Simulation {
            law: (),
            start: scene,
            scheme: NoScheme,
            mass: 1.0,
            dt: None,
            record_every: 1,
            shown: Shown::default(),
        }
    }
}

impl<const D: usize, P, L, S> Simulation<(), Scene<D, P, L>, S> {
    /// A stepper, which does not record.
    ///
    /// # Errors
    /// [`Error`] for input that is refused.
    pub fn stepper(self) -> Result<SceneStepper<D, L::Ready, S>, Error>
    where
        L: Term<D, P>,
        S: SceneScheme<D, L::Ready>,
    {
        let dt = self.dt.ok_or(Error::MissingTimeStep)?;
        SceneStepper::new(self.start, self.scheme, dt)
    }

    /// Makes a number of steps.
    ///
    /// # Errors
    /// [`Interrupted`] with everything recorded so far: input that is refused, a step that does not converge, a state
    /// that is not finite, bodies that meet where their law is singular.
    pub fn run(self, steps: u64) -> Result<Run<SceneState<D>>, Interrupted<SceneState<D>>>
    where
        L: Term<D, P>,
        S: SceneScheme<D, L::Ready>,
    {
        self.record(|stepper| stepper.possible(steps))
    }

    /// Makes as many steps as it takes to reach the time `end`, as for one body.
    ///
    /// # Errors
    /// As [`run`](Simulation::run); an `end` before the start is refused.
    pub fn run_until(self, end: f64) -> Result<Run<SceneState<D>>, Interrupted<SceneState<D>>>
    where
        L: Term<D, P>,
        S: SceneScheme<D, L::Ready>,
    {
        self.record(|stepper| steps_until(stepper.t(), end, stepper.system.setting.dt))
    }

    fn record(
        self,
        count: impl FnOnce(&SceneStepper<D, L::Ready, S>) -> Result<u64, Error>,
    ) -> Result<Run<SceneState<D>>, Interrupted<SceneState<D>>>
    where
        L: Term<D, P>,
        S: SceneScheme<D, L::Ready>,
    {
        let (record_every, dt) = (self.record_every, self.dt.unwrap_or(f64::NAN));
        let shown = self.shown.clone();
        let bodies = &self.start.bodies;
        let start = SceneState { t: bodies.t, q: bodies.q.clone(), v: bodies.v.clone() };
        let mass = bodies.masses.iter().sum();
        let run = Run::empty(start, &self.scheme, dt, mass);
        let prepared = if record_every == 0 { Err(Error::RecordEvery) } else { self.stepper() };
        let prepared = prepared.and_then(|stepper| {
            stepper.potential_is_finite()?;
            Ok((count(&stepper)?, stepper))
        });
        match prepared {
            Ok((steps, stepper)) => record(stepper, run, steps, record_every, shown),
            Err(cause) => Err(Interrupted::new(run, cause)),
        }
    }
}
