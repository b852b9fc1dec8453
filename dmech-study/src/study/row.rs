//! One run of a study.

use std::time::Duration;

use dmech_core::extend::Drifts;
use dmech_core::{Drift, Error, Invariant};

use super::case::Case;
use super::entrant::{Runner, Watched};
use super::truth::Truth;
use crate::motion::Repeatable;

/// A scheme with one step of the ladder: what was measured, or why the run failed.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StudyRow {
    entrant: usize,
    scheme: &'static str,
    order: u32,
    dt: f64,
    steps: u64,
    tolerance: Option<f64>,
    #[cfg_attr(feature = "serde", serde(serialize_with = "outcome"))]
    result: Result<Figures, Error>,
}

/// What was measured of a run that reached the end.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Figures {
    pub(super) time: Duration,
    pub(super) evaluations: u64,
    pub(super) iterations: u64,
    pub(super) error: f64,
    pub(super) drifts: Drifts,
}

impl StudyRow {
    pub(super) fn new(
        (entrant, scheme, order): (usize, &'static str, u32),
        (dt, steps): (f64, u64),
        result: Result<Figures, Error>,
    ) -> Self {
        StudyRow { entrant, scheme, order, dt, steps, tolerance: None, result }
    }

    /// The name of the scheme.
    pub fn scheme(&self) -> &'static str {
        self.scheme
    }

    /// The order that the scheme declares.
    pub fn order(&self) -> u32 {
        self.order
    }

    /// The time step of the run, which may be a little less than that of the ladder; with a tolerance the mean step, NaN if
    /// the run did not reach the end.
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// The tolerance, where the steps follow the motion.
    pub fn tolerance(&self) -> Option<f64> {
        self.tolerance
    }

    /// The number of steps from the start to the end.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// What was measured.
    ///
    /// # Errors
    /// Why the run did not reach the end.
    pub fn result(&self) -> Result<&Figures, Error> {
        self.result.as_ref().map_err(|error| *error)
    }

    /// The place of the scheme in the study.
    pub(super) fn entrant(&self) -> usize {
        self.entrant
    }

    /// Runs once more, against the clock.
    pub(super) fn time_once<L, X: Repeatable<L>>(&mut self, case: &Case<L, X>, runner: &dyn Runner<L, X>) {
        if let Ok(figures) = &mut self.result
            && let Some(time) = runner.time(case, self.tolerance.unwrap_or(self.dt), self.steps, runs(figures.time))
        {
            figures.time = figures.time.min(time);
        }
    }
}

impl Figures {
    /// Wall time: the shortest of the repetitions.
    pub fn time(&self) -> Duration {
        self.time
    }

    /// Evaluations of the force, the start not counted.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// Newton corrections.
    pub fn iterations(&self) -> u64 {
        self.iterations
    }

    /// |q − q*| at the end.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// How an invariant moved; `None` where the law, or the scheme, has no such invariant.
    pub fn drift(&self, invariant: Invariant) -> Option<Drift> {
        self.drifts[invariant as usize]
    }
}

/// The figures, or the error in words: one that ends a run may have no form of its own.
#[cfg(feature = "serde")]
fn outcome<S: serde::Serializer>(result: &Result<Figures, Error>, serializer: S) -> Result<S::Ok, S::Error> {
    serde::Serialize::serialize(&result.as_ref().map_err(ToString::to_string), serializer)
}

/// Runs in a row that the clock can resolve, from the time of one.
fn runs(time: Duration) -> u32 {
    const RESOLVED: Duration = Duration::from_micros(50);
    let runs = RESOLVED.as_nanos() / time.as_nanos().max(50);
    1 + u32::try_from(runs).unwrap_or(0)
}

/// Runs a scheme with one step; the time is still to be measured.
pub(super) fn measure<L: Clone, X: Repeatable<L>>(
    case: &Case<L, X>,
    entrant: usize,
    runner: &dyn Runner<L, X>,
    dt: f64,
    truth: &Truth,
) -> StudyRow {
    let id = (entrant, runner.name(), runner.order());
    if runner.tolerances().is_some() {
        return measure_adaptive(case, id, runner, dt, truth);
    }
    let (steps, dt) = match case.whole_steps(dt) {
        Ok(whole) => whole,
        Err(error) => return StudyRow::new(id, (dt, 0), Err(error)),
    };
    let late = case.late(steps, dt);
    let figures = |run: Watched| figures(run, (case.end, dt), (truth, late));
    StudyRow::new(id, (dt, steps), runner.watch(case, dt, steps).and_then(figures))
}

/// The same with a tolerance in place of a step.
fn measure_adaptive<L: Clone, X: Repeatable<L>>(
    case: &Case<L, X>,
    id: (usize, &'static str, u32),
    runner: &dyn Runner<L, X>,
    tolerance: f64,
    truth: &Truth,
) -> StudyRow {
    let run = runner.watch(case, tolerance, 0);
    let steps = run.as_ref().map_or(0, |run| run.steps);
    let dt = if steps == 0 { f64::NAN } else { case.span() / steps as f64 };
    let row = StudyRow::new(id, (dt, steps), run.and_then(|run| figures(run, (case.end, dt), (truth, 0.0))));
    StudyRow { tolerance: Some(tolerance), ..row }
}

/// What was measured of a run with steps of about dt.
fn figures(run: Watched, (end, dt): (f64, f64), (truth, late): (&Truth, f64)) -> Result<Figures, Error> {
    let Watched { q, steps, evaluations, iterations, drifts } = run;
    match truth.distance(&q, late) {
        Some(error) => Ok(Figures { time: Duration::MAX, evaluations, iterations, error, drifts }),
        None => Err(Error::NotFinite { step: steps, time: end - dt, dt }),
    }
}
