//! Stepping a scene without recording.

use super::builder::Scene;
use super::scheme::{SceneScheme, Start, Workspace};
use super::setting::{Setting, System};
use super::state::SceneState;
use super::terms::{Acts, Fault, Term};
use super::vectors::Vectors;
use super::watch::SceneWatch;
use crate::error::Error;
use crate::fault::{PARTS, not_converged};
use crate::motion::{Motion, moves_on, steps_from};
use crate::newton::NotConverged;
use crate::watch::Drifts;

/// A scene advanced by hand: it records nothing.
///
/// Time is t₀ + k h after k steps, never a running sum. A step that fails leaves the scene where it was.
#[derive(Clone, Debug)]
pub struct SceneStepper<const D: usize, A: Acts<D>, S: SceneScheme<D, A>> {
    pub(super) system: System<D, A>,
    pub(super) scheme: S,
    pub(super) workspace: S::Workspace,
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
        moves_on(bodies.t, dt)?;
        let setting = Setting::new(dt, &bodies);
        let (q, v, t0) = (Vectors::from_list(&bodies.q), Vectors::from_list(&bodies.v), bodies.t);
        let acts = laws.prepare(&bodies)?;
        let mut workspace = S::Workspace::new(q.bodies(), &acts);
        let system = System { acts, setting };
        // The forces on all bodies are summed faster than those of each link are looked at.
        let mut slope = Vectors::zeros(q.bodies());
        system.slope(&q, &v, t0, &mut slope);
        let fault = if slope.is_finite() { None } else { system.acts.fault(None, &q, &v, t0) };
        if let Some(fault) = fault {
            return Err(fault_error(fault, 0, t0));
        }
        let start = Start { t: t0, q: &q, v: &v, slope: &slope };
        let memory = match scheme.begin(&system, start, &mut workspace) {
            Ok(memory) => memory,
            // A start that solves an equation makes a step backward.
            Err(cause) => return Err(unsolved(&system, start, -dt, 0, cause)),
        };
        let before = memory.clone();
        Ok(SceneStepper {
            system,
            scheme,
            workspace,
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
    /// [`Error::NotConverged`], [`Error::NotFinite`], or [`Error::Link`] and [`Error::Body`] where a law is not finite and
    /// it can be said between or on which bodies; the scene then stays where it was.
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
    /// As [`step`](SceneStepper::step); the scene then stands before the step that failed. It does not begin where so many
    /// steps would lead to [`Error::TimeStandsStill`].
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        let steps = self.possible(steps)?;
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

    /// So many steps from here, if the time can tell them apart.
    pub(super) fn possible(&self, steps: u64) -> Result<u64, Error> {
        steps_from(self.t(), steps, self.system.setting.dt)
    }

    /// Whether every potential is finite, which a run watches.
    pub(super) fn potential_is_finite(&self) -> Result<(), Error> {
        let (q, v) = &self.start;
        let fault = || self.system.acts.fault(None, q, v, self.t0);
        match self.system.acts.potential(q, self.t0) {
            potential if potential.is_finite() => Ok(()),
            _ => fault().map_or(Ok(()), |fault| Err(fault_error(fault, 0, self.t0))),
        }
    }

    fn attempt(&mut self) -> Result<(), NotConverged> {
        let effort = self.scheme.step(&self.system, self.t(), &mut self.memory, &mut self.workspace)?;
        self.evaluations += u64::from(effort.evaluations);
        self.iterations += u64::from(effort.iterations);
        self.steps += 1;
        Ok(())
    }

    /// Why a step failed, by the bodies where that can be said: from the memory that it left behind.
    #[cold]
    fn failure(&self, cause: Option<NotConverged>) -> Error {
        let dt = self.system.setting.dt;
        if let Some(cause) = cause {
            let (t, q) = (self.t(), self.scheme.position(&self.before));
            let v = self.scheme.velocity(&self.system, t, &self.before);
            let mut slope = Vectors::zeros(q.bodies());
            self.system.slope(q, &v, t, &mut slope);
            return unsolved(&self.system, Start { t, q, v: &v, slope: &slope }, dt, self.steps + 1, cause);
        }
        let (step, time) = (self.steps, self.t0 + (self.steps - 1) as f64 * dt);
        let q = self.scheme.position(&self.memory);
        if q.is_finite() {
            let v = self.scheme.velocity(&self.system, time, &self.before);
            if let Some(fault) = self.system.acts.fault(None, q, &v, time + dt) {
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

/// Why an implicit step from a state has no solution, as for one body: the first link or body on the way of freely falling
/// bodies on which what acts is not finite.
#[cold]
fn unsolved<const D: usize, A: Acts<D>>(
    system: &System<D, A>,
    Start { t, q, v, slope }: Start<'_, D>,
    dt: f64,
    step: u64,
    cause: NotConverged,
) -> Error {
    let fault = |part: &f64| {
        let passed = part * dt;
        let mut b = q.clone();
        for (i, b) in b.flat_mut().iter_mut().enumerate() {
            // The setting has h/m, and 0 for a pinned body.
            let fall = 0.5 * part * passed * dt.signum() * system.setting.kick.flat()[i] * slope.flat()[i];
            *b += passed * v.flat()[i] - fall;
        }
        if b.is_finite() { system.acts.fault(Some(q), &b, v, t + passed) } else { None }
    };
    match PARTS.iter().find_map(fault) {
        Some(fault) => fault_error(fault, step, t),
        None => not_converged(step, t, dt, cause),
    }
}

fn fault_error(fault: Fault, step: u64, time: f64) -> Error {
    match fault {
        Fault::Link { a, b, distance } => Error::Link { a, b, distance, step, time },
        Fault::Body { body, value, place } => Error::Body { body, value, place, step, time },
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
