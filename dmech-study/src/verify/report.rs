//! The outcome of a verification.

use core::fmt;

/// Whether a check was passed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Outcome {
    /// The figure is within its bound.
    Passed,
    /// It is not, or there was no figure where there must be one.
    Failed,
    /// The law or the start gives nothing to measure; the note says why.
    NotApplicable,
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Outcome::Passed => "passed",
            Outcome::Failed => "FAILED",
            Outcome::NotApplicable => "n/a",
        })
    }
}

/// One check: what was measured against what bound.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Check {
    pub(super) name: String,
    pub(super) measured: Option<f64>,
    pub(super) bound: Option<f64>,
    pub(super) outcome: Outcome,
    pub(super) note: String,
}

impl Check {
    /// Passed if the figure is at most the bound; a NaN is not.
    pub(super) fn at_most(name: impl Into<String>, measured: f64, bound: f64, note: impl Into<String>) -> Self {
        let outcome = if measured <= bound { Outcome::Passed } else { Outcome::Failed };
        Check { name: name.into(), measured: Some(measured), bound: Some(bound), outcome, note: note.into() }
    }

    /// Passed if the figure is at least the bound; a NaN is not.
    pub(super) fn at_least(name: impl Into<String>, measured: f64, bound: f64, note: impl Into<String>) -> Self {
        let outcome = if measured >= bound { Outcome::Passed } else { Outcome::Failed };
        Check { name: name.into(), measured: Some(measured), bound: Some(bound), outcome, note: note.into() }
    }

    pub(super) fn failed(name: impl Into<String>, note: impl Into<String>) -> Self {
        Check { name: name.into(), measured: None, bound: None, outcome: Outcome::Failed, note: note.into() }
    }

    pub(super) fn not_applicable(name: impl Into<String>, note: impl Into<String>) -> Self {
        Check { name: name.into(), measured: None, bound: None, outcome: Outcome::NotApplicable, note: note.into() }
    }

    /// Says of a power of the step that is too low what a law with choices may have to do with it.
    pub(super) fn hint_at_seams(&mut self) {
        if self.outcome == Outcome::Failed && self.measured < self.bound {
            self.note += "; the law has choices: a seam on the way lowers the power";
        }
    }

    /// What was checked.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The figure; `None` where nothing could be measured.
    pub fn measured(&self) -> Option<f64> {
        self.measured
    }

    /// The bound of the figure: from above, but for orders from below.
    pub fn bound(&self) -> Option<f64> {
        self.bound
    }

    /// Whether it was passed.
    pub fn outcome(&self) -> Outcome {
        self.outcome
    }

    /// The unit of the figure, or why there is none.
    pub fn note(&self) -> &str {
        &self.note
    }
}

/// What [`verify`](fn@super::verify) or [`verify_scheme`](super::verify_scheme) found: data, a table (`Display`), or one line
/// in a test ([`assert`](Verification::assert)).
#[derive(Clone, Debug)]
#[must_use = "the report is of no use unless it is looked at"]
pub struct Verification<Of = ()> {
    pub(super) of: Of,
    pub(super) checks: Vec<Check>,
}

impl<Of> Verification<Of> {
    /// Every check, in the order of the table.
    pub fn checks(&self) -> &[Check] {
        &self.checks
    }

    /// No check failed.
    pub fn passed(&self) -> bool {
        self.checks.iter().all(|check| check.outcome != Outcome::Failed)
    }

    /// For a test of one line.
    ///
    /// # Panics
    /// With the table, if a check failed.
    #[track_caller]
    pub fn assert(&self) {
        assert!(self.passed(), "the verification failed\n{self}");
    }
}

impl<Of> fmt::Display for Verification<Of> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let wide = self.checks.iter().map(|check| check.name.chars().count()).max().unwrap_or(0).max(5);
        writeln!(f, "{:<wide$}  {:>9}  {:>9}  {:<6}  note", "check", "measured", "bound", "")?;
        let number = |x: Option<f64>| match x {
            None => "-".to_owned(),
            Some(x) if x == 0.0 || (0.01..1000.0).contains(&x.abs()) => format!("{x:.3}"),
            Some(x) => format!("{x:.1e}"),
        };
        for Check { name, measured, bound, outcome, note } in &self.checks {
            let (measured, bound) = (number(*measured), number(*bound));
            writeln!(f, "{name:<wide$}  {measured:>9}  {bound:>9}  {outcome:<6}  {note}")?;
        }
        let count = |outcome| self.checks.iter().filter(|check| check.outcome == outcome).count();
        let (passed, failed) = (count(Outcome::Passed), count(Outcome::Failed));
        write!(f, "{passed} passed, {failed} failed, {} not applicable", count(Outcome::NotApplicable))
    }
}
