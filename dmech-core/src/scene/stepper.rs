//! Stepping a scene without recording.

use super::builder::Scene;
use super::newton::Solver;
use super::scheme::{SceneScheme, Start};
use super::setting::{Setting, System};
use super::state::SceneState;
use super::terms::{Acts, Fault, Term};
use super::vectors::Vectors;
use super::watch::SceneWatch;
use crate::error::Error;
use crate::motion::Motion;
use crate::newton::NotConverged;
use crate::watch::Drifts;

/// A scene advanced by hand: it records nothing.
///
/// Time is t₀ + k h after k steps, never a running sum. A step that fails leaves the scene where it was.
#[derive(Clone, Debug)]
pub struct SceneStepper<const D: usize, A: Acts<D>, S: SceneScheme<D, A>> {
    pub(super) system: System<D, A>,
    pub(super) scheme: S,
    pub(super) solver: Solver<D>,
    pub(super) t0: f64,
    pub(super) memory: S::Memory,
    /// The memory before the last step.
    pub(super) before: S::Memory,
    pub(super) start: (Vectors<D>, Vectors<D>),
    pub(super) steps: u64,
    pub(super) evaluations: u64,
    pub(super) iterations: u64,
}

impl<const D: usize, A: Acts<D>, S: SceneScheme<D, A>> SceneStepper<D, A, S> {
    pub(super) fn new<P, L: Term<D, P, Ready = A>>(scene: Scene<D, P, L>, scheme: S, dt: f64) -> Result<Self, Error> {
        if !(dt > 0.0 && dt.is_finite()) {
            return Err(Error::TimeStep { dt });
        }
        let Scene { bodies, laws } = scene;
        bodies.check()?;
        let setting = Setting::new(dt, &bodies);
        let (q, v, t0) = (Vectors::from_list(&bodies.q), Vectors::from_list(&bodies.v), bodies.t);
        let acts = laws.prepare(&bodies)?;
        if let Some(fault) = acts.fault(&q, &v, t0) {
            return Err(fault_error(fault, 0, t0));
        }
        let mut solver = Solver::new(q.bodies(), &acts.links(q.bodies()));
        let system = System { acts, setting };
        let memory = match scheme.begin(&system, Start { t: t0, q: &q, v: &v }, &mut solver) {
            Ok(memory) => memory,
            Err(NotConverged { iterations, residual }) => {
                return Err(Error::NotConverged { step: 0, time: t0, dt, iterations: iterations as u32, residual });
            }
        };
        let before = memory.clone();
        Ok(SceneStepper {
            system,
            scheme,
            solver,
            t0,
            memory,
            before,
            start: (q, v),
            steps: 0,
            evaluations: 0,
            iterations: 0,
        })
    }

    /// Advances by one time step.
    ///
    /// # Errors
    /// [`Error::NotConverged`], [`Error::NotFinite`], or [`Error::Link`] and [`Error::Body`] where it can be said which
    /// bodies; the scene then stays where it was.
    pub fn step(&mut self) -> Result<(), Error> {
        self.before.clone_from(&self.memory);
        let attempt = self.attempt();
        if attempt.is_ok() && self.scheme.finite(&self.memory) {
            return Ok(());
        }
        let error = self.failure(attempt.err());
        self.memory.clone_from(&self.before);
        if attempt.is_ok() {
            self.steps -= 1;
        }
        Err(error)
    }

    /// Advances by several steps; whether the motion is finite is looked at once, at the end. The states are those of as
    /// many calls of [`step`](SceneStepper::step).
    ///
    /// # Errors
    /// As [`step`](SceneStepper::step); the scene then stands before the step that failed.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        self.before.clone_from(&self.memory);
        let counts = (self.steps, self.evaluations, self.iterations);
        let done = (0..steps).try_for_each(|_| self.attempt());
        if done.is_ok() && self.scheme.finite(&self.memory) {
            return Ok(());
        }
        // Step by step to the one that fails.
        self.memory.clone_from(&self.before);
        (self.steps, self.evaluations, self.iterations) = counts;
        (0..steps).try_for_each(|_| self.step())
    }

    fn attempt(&mut self) -> Result<(), NotConverged> {
        let effort = self.scheme.step(&self.system, self.t(), &mut self.memory, &mut self.solver)?;
        self.evaluations += u64::from(effort.evaluations);
        self.iterations += u64::from(effort.iterations);
        self.steps += 1;
        Ok(())
    }

    /// Why a step failed, by the bodies where that can be said: from the memory that it left behind.
    #[cold]
    fn failure(&self, cause: Option<NotConverged>) -> Error {
        let dt = self.system.setting.dt;
        if let Some(NotConverged { iterations, residual }) = cause {
            return Error::NotConverged {
                step: self.steps + 1,
                time: self.t(),
                dt,
                iterations: iterations as u32,
                residual,
            };
        }
        let (step, time) = (self.steps, self.t0 + (self.steps - 1) as f64 * dt);
        let q = self.scheme.position(&self.memory);
        if q.is_finite() {
            let v = self.scheme.velocity(&self.system, time, &self.before);
            if let Some(fault) = self.system.acts.fault(q, &v, time + dt) {
                return fault_error(fault, step, time);
            }
        }
        Error::NotFinite { step, time, dt }
    }

    /// Positions and velocities now.
    pub fn state(&self) -> SceneState<D> {
        if self.steps == 0 {
            let (q, v) = &self.start;
            return SceneState { t: self.t0, q: q.to_list(), v: v.to_list() };
        }
        let t = self.t();
        let v = self.scheme.velocity(&self.system, t, &self.memory);
        SceneState { t, q: self.q().to_list(), v: v.to_list() }
    }

    /// Time now, t₀ + k h.
    #[inline]
    pub fn t(&self) -> f64 {
        self.t0 + self.steps as f64 * self.system.setting.dt
    }

    /// Positions now.
    pub fn q(&self) -> &Vectors<D> {
        self.scheme.position(&self.memory)
    }

    /// Steps made.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Evaluations of all forces so far, the start not counted.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// Newton corrections so far.
    pub fn iterations(&self) -> u64 {
        self.iterations
    }
}

fn fault_error(fault: Fault, step: u64, time: f64) -> Error {
    match fault {
        Fault::Link { a, b, distance } => Error::Link { a, b, distance, step, time },
        Fault::Body { body, value } => Error::Body { body, value, step, time },
    }
}

impl<const D: usize, A: Acts<D>, S: SceneScheme<D, A>> Motion for SceneStepper<D, A, S> {
    type State = SceneState<D>;
    type Watch = SceneWatch<D>;

    fn state(&self) -> SceneState<D> {
        SceneStepper::state(self)
    }

    fn watch(&self) -> SceneWatch<D> {
        SceneWatch::begin(&self.system, &self.scheme, &self.memory, &SceneStepper::state(self))
    }

    fn step_watched(&mut self, watch: &mut SceneWatch<D>) -> Result<(), Error> {
        self.step()?;
        watch.add_work(self.scheme.work(&self.system.setting, &self.before, &self.memory));
        Ok(())
    }

    fn observe(&self, watch: &mut SceneWatch<D>, state: &SceneState<D>) {
        watch.observe(&self.system, &self.scheme, &self.memory, state);
    }

    fn drifts(watch: &SceneWatch<D>) -> Drifts {
        watch.drifts()
    }

    fn effort(&self) -> [u64; 3] {
        [self.steps, self.evaluations, self.iterations]
    }
}
