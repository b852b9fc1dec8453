//! One scheme on one motion: what came out of it, and what must hold whatever came out.

use dmech::Law;
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};

/// What a trial needs to know of a recorded state.
pub(crate) trait Recorded {
    /// Its time.
    fn t(&self) -> f64;
    /// Whether all of its numbers are finite.
    fn is_finite(&self) -> bool;
    /// Σ m v²/2; one mass stands for all coordinates or bodies.
    fn kinetic_energy(&self, masses: &[f64]) -> f64;
}

impl<const D: usize> Recorded for State<D> {
    fn t(&self) -> f64 {
        self.t
    }
    fn is_finite(&self) -> bool {
        self.q.iter().chain(&self.v).all(|x| x.is_finite())
    }
    fn kinetic_energy(&self, masses: &[f64]) -> f64 {
        self.v.iter().zip(masses.iter().cycle()).map(|(v, m)| 0.5 * m * v * v).sum()
    }
}

impl<const D: usize> Recorded for SceneState<D> {
    fn t(&self) -> f64 {
        self.t
    }
    fn is_finite(&self) -> bool {
        self.q.iter().chain(&self.v).flatten().all(|x| x.is_finite())
    }
    fn kinetic_energy(&self, masses: &[f64]) -> f64 {
        let bodies = self.v.iter().zip(masses.iter().cycle());
        bodies.map(|(v, m)| 0.5 * m * v.iter().map(|x| x * x).sum::<f64>()).sum()
    }
}

/// One scheme on one motion.
pub(crate) struct Trial<X> {
    pub(crate) scheme: &'static str,
    pub(crate) dt: f64,
    /// Steps that were asked for.
    pub(crate) asked: u64,
    pub(crate) record_every: u64,
    pub(crate) run: Run<X>,
    /// Why it ended early.
    pub(crate) cause: Option<Error>,
    masses: Vec<f64>,
}

impl<X: Recorded> Trial<X> {
    pub(crate) fn completed(&self) -> bool {
        self.cause.is_none()
    }

    /// The recorded states and the last one.
    pub(crate) fn states(&self) -> impl Iterator<Item = &X> {
        self.run.states().iter().chain([self.run.last()])
    }

    /// The largest kinetic energy of the recorded states.
    ///
    /// An energy error is measured by it where the potential is far larger on the way than at the start: E is then the
    /// small difference of two large numbers, and no scheme can know it better than an ulp of these.
    pub(crate) fn largest_kinetic_energy(&self) -> f64 {
        self.states().map(|state| state.kinetic_energy(&self.masses)).fold(0.0, f64::max)
    }

    /// The largest |E − E₀| over the largest kinetic energy or |E₀|; NaN where the law has no energy.
    pub(crate) fn energy_error(&self) -> f64 {
        self.error_of(Invariant::Energy)
    }

    /// The same for the energy that the scheme keeps: for Kanatani's its own.
    pub(crate) fn own_energy_error(&self) -> f64 {
        match self.run.drift(Invariant::DiscreteEnergy) {
            Some(_) => self.error_of(Invariant::DiscreteEnergy),
            None => self.error_of(Invariant::Energy),
        }
    }

    fn error_of(&self, energy: Invariant) -> f64 {
        let Some(drift) = self.run.drift(energy) else { return f64::NAN };
        if drift.max_abs() < f64::MAX {
            drift.max_abs() / self.largest_kinetic_energy().max(drift.start().abs())
        } else {
            // Energies beyond the largest number, or the difference of two of them.
            f64::INFINITY
        }
    }

    /// Whether the scheme promises an energy exactly, its own or that of the motion.
    pub(crate) fn exact_energy(&self) -> bool {
        [Invariant::Energy, Invariant::DiscreteEnergy]
            .into_iter()
            .any(|energy| self.run.drift(energy).is_some() && self.run.kept(energy) == Kept::Exact)
    }

    /// What holds for every scheme on every motion: finite states at the times of whole steps, as many as were asked for
    /// or a typed error that names the step after the last.
    pub(crate) fn sound(&self) -> Result<(), String> {
        let (run, recorded) = (&self.run, self.run.states());
        let wrong = |what: String| Err(format!("{} at dt = {:e}: {what}", self.scheme, self.dt));
        if let Some(state) = self.states().find(|state| !state.is_finite()) {
            return wrong(format!("the state recorded at t = {} is not finite", state.t()));
        }
        // The step after the last, from where the last ended.
        let next = |step: u64, time: f64| step == run.steps() + 1 && time == run.last().t();
        let told = match self.cause {
            None => run.steps() == self.asked,
            Some(Error::NotConverged { step, time, dt, .. } | Error::NotFinite { step, time, dt }) => {
                next(step, time) && dt == self.dt
            }
            Some(
                Error::Link { step, time, .. } | Error::Body { step, time, .. } | Error::LawInStep { step, time, .. },
            ) => next(step, time),
            Some(Error::Law { .. } | Error::Underflow { .. }) if recorded.is_empty() => return Ok(()),
            Some(_) => false,
        };
        if !told {
            return wrong(format!("{} of {} steps, and the cause is {:?}", run.steps(), self.asked, self.cause));
        }
        if recorded.len() as u64 != 1 + run.steps() / self.record_every {
            return wrong(format!("{} states for {} steps", recorded.len(), run.steps()));
        }
        let start = recorded[0].t();
        for (k, state) in recorded.iter().enumerate() {
            if state.t() != start + (k as u64 * self.record_every) as f64 * self.dt {
                return wrong(format!("state {k} stands at t = {:e}", state.t()));
            }
        }
        Ok(())
    }
}

fn trial<X>(
    outcome: Result<Run<X>, Interrupted<X>>,
    dt: f64,
    asked: u64,
    record_every: u64,
    masses: Vec<f64>,
) -> Trial<X> {
    let (run, cause) = match outcome {
        Ok(run) => (run, None),
        Err(interrupted) => {
            let cause = interrupted.cause();
            (interrupted.into_run(), Some(cause))
        }
    };
    Trial { scheme: run.report().scheme(), dt, asked, record_every, run, cause, masses }
}

/// A law and where it starts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion<L, const D: usize> {
    pub(crate) law: L,
    pub(crate) start: State<D>,
    pub(crate) mass: f64,
    pub(crate) dt: f64,
    pub(crate) steps: u64,
    pub(crate) record_every: u64,
}

impl<L: Law<D> + Copy, const D: usize> Motion<L, D> {
    /// `steps` steps to the time `end`, all of them recorded.
    pub(crate) fn until(law: L, start: State<D>, end: f64, steps: u64) -> Self {
        Motion { law, start, mass: 1.0, dt: (end - start.t) / steps as f64, steps, record_every: 1 }
    }

    pub(crate) fn record_every(self, n: u64) -> Self {
        Motion { record_every: n, ..self }
    }

    pub(crate) fn by<S: Scheme<Particle<L, D>>>(&self, scheme: S) -> Trial<State<D>> {
        let simulation = Simulation::new(self.law, self.start).mass(self.mass).scheme(scheme);
        let outcome = simulation.dt(self.dt).record_every(self.record_every).run(self.steps);
        trial(outcome, self.dt, self.steps, self.record_every, vec![self.mass])
    }
}

/// A scene and how it is stepped.
#[derive(Clone, Debug)]
pub(crate) struct Together<const D: usize, L> {
    pub(crate) scene: Scene<D, (), L>,
    pub(crate) masses: Vec<f64>,
    pub(crate) dt: f64,
    pub(crate) steps: u64,
    pub(crate) record_every: u64,
}

impl<const D: usize, L: Term<D, ()> + Clone> Together<D, L> {
    pub(crate) fn by<S: Scheme<SceneSystem<D, L::Ready>>>(&self, scheme: S) -> Trial<SceneState<D>> {
        let simulation = Simulation::scene(self.scene.clone()).scheme(scheme).dt(self.dt);
        let outcome = simulation.record_every(self.record_every).run(self.steps);
        trial(outcome, self.dt, self.steps, self.record_every, self.masses.clone())
    }
}

/// Every scheme, in the order of the tables: those that fit any law, or with `positions` also those for forces that do not
/// depend on the velocity. A new scheme is a new line.
macro_rules! every_scheme {
    (positions: $run:expr) => {
        $crate::cases::trial::every_scheme!(@
            $run;
            Explicit,
            Leapfrog,
            Implicit,
            DiscreteGradient,
            Kanatani,
            Composed::new(Leapfrog, coefficients::Suzuki4),
            Composed::order6(Leapfrog),
            Nystrom::order6(),
            Composed::new(DiscreteGradient, coefficients::Suzuki4),
            Composed::order6(DiscreteGradient),
        )
    };
    (any: $run:expr) => {
        $crate::cases::trial::every_scheme!(@
            $run;
            Explicit,
            Implicit,
            DiscreteGradient,
            Composed::new(DiscreteGradient, coefficients::Suzuki4),
            Composed::order6(DiscreteGradient),
        )
    };
    (@ $run:expr; $($scheme:expr,)*) => { vec![$($run.by($scheme)),*] };
}
pub(crate) use every_scheme;
