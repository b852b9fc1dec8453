//! The report of a run.

use core::fmt;
use std::time::Duration;

use crate::drift::{Drift, Drifts, OwnDrifts};
use crate::invariant::{Invariant, Kept};
use crate::method::Method;
use crate::text::Number;
use crate::words::Word;

/// What a run cost.
#[derive(Clone, Copy, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Cost {
    pub(crate) steps: u64,
    pub(crate) evaluations: u64,
    pub(crate) iterations: u64,
    /// Steps made in parts, or in which a force bent.
    pub(crate) rough: u64,
    pub(crate) elapsed: Duration,
    /// The shortest and the longest step, where they differ.
    pub(crate) range: Option<[f64; 2]>,
}

/// What a run kept and what it cost. `Display` shows it as a table for the terminal.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Report {
    #[cfg_attr(feature = "serde", serde(with = "crate::words"))]
    scheme: Word,
    order: u32,
    tolerance: Option<f64>,
    #[cfg_attr(feature = "serde", serde(with = "missing"))]
    dt: f64,
    mass: f64,
    kept: [Kept; Invariant::ALL.len()],
    drifts: Drifts,
    own: OwnDrifts,
    work: Cost,
}

impl Report {
    /// With what the scheme says it keeps of any system.
    pub(crate) fn new<M: Method>(scheme: &M, dt: Option<f64>, mass: f64) -> Self {
        let (tolerance, scheme, order) = (scheme.tolerance(), M::NAME, M::ORDER);
        let (drifts, own, work) = Default::default();
        let (dt, kept) = (dt.unwrap_or(f64::NAN), Invariant::each(&mut M::keeps));
        Report { scheme, order, tolerance, dt, mass, kept, drifts, own, work }
    }

    /// How well the invariants of a system are kept.
    pub(crate) fn keep(&mut self, kept: [Kept; Invariant::ALL.len()]) {
        self.kept = kept;
    }

    #[cfg(any(feature = "ranks", feature = "store"))]
    pub(crate) fn work(&self) -> Cost {
        self.work
    }

    pub(crate) fn finish(&mut self, drifts: Drifts, own: OwnDrifts, work: Cost) {
        self.drifts = drifts;
        self.own = own;
        self.work = work;
    }

    /// The name of the scheme.
    pub fn scheme(&self) -> &'static str {
        self.scheme
    }

    /// The order of the scheme.
    pub fn order(&self) -> u32 {
        self.order
    }

    /// The time step, with a tolerance the longest that was allowed; NaN if it was missing.
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// The tolerance, where the steps follow the motion.
    pub fn tolerance(&self) -> Option<f64> {
        self.tolerance
    }

    /// The shortest and the longest step, but for the last one of `run_until` that is shortened to land; `None` in an
    /// adaptive run without any other.
    pub fn dt_range(&self) -> Option<[f64; 2]> {
        if self.tolerance.is_none() {
            return Some([self.dt; 2]);
        }
        self.work.range.filter(|[shortest, longest]| shortest <= longest)
    }

    /// The mass; with masses per coordinate the unit that they are in.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Steps completed.
    pub fn steps(&self) -> u64 {
        self.work.steps
    }

    /// How an invariant moved.
    pub fn drift(&self, invariant: Invariant) -> Option<Drift> {
        self.drifts[invariant as usize]
    }

    /// How an invariant moved that the law declares itself, or a quantity that the run watched, by its name.
    pub fn drift_of(&self, name: &str) -> Option<Drift> {
        self.own.of(name)
    }

    /// The invariants that the law declares itself, and the quantities that the run watched, each with its name.
    pub fn own_drifts(&self) -> impl Iterator<Item = (&'static str, Drift)> + '_ {
        self.own.iter()
    }

    /// How well the scheme must keep an invariant; [`Kept::No`] where [`drift`](Report::drift) is `None`: what there is not is not kept.
    /// What is bounded on smooth motions is so between [rough](Report::rough) steps.
    pub fn kept(&self, invariant: Invariant) -> Kept {
        match self.drift(invariant).map_or(Kept::No, |_| self.kept[invariant as usize]) {
            Kept::Bounded if self.work.rough > 0 => Kept::BetweenSeams,
            kept => kept,
        }
    }

    /// Evaluations of the force, the start not counted.
    pub fn evaluations(&self) -> u64 {
        self.work.evaluations
    }

    /// Newton corrections.
    pub fn iterations(&self) -> u64 {
        self.work.iterations
    }

    /// Steps of [`Gauss`](crate::Gauss) and [`LineIntegral`](crate::LineIntegral) that had to be made in parts, as they were too
    /// long for their sweeps, or in which a force bent or jumped as eight stages see it: at a seam of a law with choices, or as the step
    /// was far too long. They have not the order of the scheme.
    pub fn rough(&self) -> u64 {
        self.work.rough
    }

    /// Time that the run took, recording and watching included.
    pub fn elapsed(&self) -> Duration {
        self.work.elapsed
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Cost { steps, evaluations, iterations, elapsed, .. } = self.work;
        let per_step = |total: f64| if steps == 0 { 0.0 } else { total / steps as f64 };
        write!(f, "{}, order {}, ", self.scheme, self.order)?;
        match (self.tolerance, self.dt_range()) {
            (None, _) => write!(f, "dt = {}", Number(self.dt))?,
            (Some(tolerance), None) => write!(f, "tolerance {tolerance:e}")?,
            (Some(tolerance), Some([shortest, longest])) => {
                write!(f, "tolerance {tolerance:e}, dt from {shortest:.3e} to {longest:.3e}")?;
            }
        }
        writeln!(f, ", {steps} steps")?;
        let wide = self.own.iter().map(|(name, _)| name.chars().count()).fold(22, usize::max);
        writeln!(
            f,
            "  {:<wide$} {:>22} {:>12} {:>12} {:>12}  must be",
            "invariant", "at the start", "largest", "relative", "per time"
        )?;
        let known = Invariant::ALL.iter().filter_map(|&invariant| {
            Some((invariant.to_string(), self.drift(invariant)?, self.kept(invariant).to_string()))
        });
        // What a scheme does with a quantity that it does not know is for the run to show.
        let own = self.own.iter().map(|(name, drift)| (shown(name), drift, "–".to_owned()));
        for (name, drift, kept) in known.chain(own) {
            let [start, largest, relative, slope] = drift.figures();
            writeln!(f, "  {name:<wide$} {start:>22} {largest:>12} {relative:>12} {slope:>12}  {kept}")?;
        }
        writeln!(
            f,
            "  {:<wide$} {evaluations:>22} {:>12.2} per step",
            "force evaluations",
            per_step(evaluations as f64)
        )?;
        writeln!(
            f,
            "  {:<wide$} {iterations:>22} {:>12.2} per step",
            "Newton iterations",
            per_step(iterations as f64)
        )?;
        if self.work.rough > 0 {
            writeln!(f, "  {:<wide$} {:>22} {:>12} of lower order", "rough steps", self.work.rough, "")?;
        }
        if elapsed.is_zero() {
            return write!(f, "  {:<wide$} {:>22}", "time", "not measured");
        }
        let nanoseconds = per_step(elapsed.as_secs_f64() * 1e9);
        write!(f, "  {:<wide$} {:>22} {nanoseconds:>12.1} ns per step", "time", format!("{elapsed:.2?}"))
    }
}

/// The name of a quantity as a report shows it.
pub(super) fn shown(name: &str) -> String {
    name.replace('_', " ")
}

/// A number that may be missing, and is NaN then: that is nothing in a file, as formats may have no NaN.
#[cfg(feature = "serde")]
mod missing {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        Some(*number).filter(|number| !number.is_nan()).serialize(serializer)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        Option::deserialize(deserializer).map(|number| number.unwrap_or(f64::NAN))
    }
}
