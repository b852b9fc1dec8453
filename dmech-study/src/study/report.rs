//! What a study found.

use std::time::Duration;

use super::interpolate::{Cost, cost_at};
use super::reference::Reference;
use super::row::{Figures, StudyRow};

/// The outcome of a [`Study`](super::Study): its rows as data, the cost of an error, a table (`Display`) and CSV.
///
/// ```text
/// log cost = linear in log error, between two neighbouring steps of the ladder
/// ```
///
/// Where a ladder encloses an error more than once, the smallest steps count; an error that the largest step reaches
/// costs at most that step; one below the [`resolution`](StudyReport::resolution) cannot be told and has no cost.
///
/// With the feature `serde` it can be written, but not read; why a run failed stands there in words.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[must_use = "the report is of no use unless it is looked at"]
pub struct StudyReport {
    schemes: Vec<(&'static str, u32)>,
    rows: Vec<StudyRow>,
    span: [f64; 2],
    resolution: f64,
    reference: Option<Reference>,
    /// How large the motion is.
    #[cfg(feature = "plot")]
    length: f64,
}

impl StudyReport {
    pub(super) fn new(
        schemes: Vec<(&'static str, u32)>,
        rows: Vec<StudyRow>,
        span: [f64; 2],
        resolution: f64,
        reference: Option<Reference>,
    ) -> Self {
        StudyReport {
            schemes,
            rows,
            span,
            resolution,
            reference,
            #[cfg(feature = "plot")]
            length: 1.0,
        }
    }

    #[cfg(feature = "plot")]
    pub(super) fn of_length(self, length: f64) -> Self {
        StudyReport { length, ..self }
    }

    #[cfg(feature = "plot")]
    pub(super) fn length(&self) -> f64 {
        self.length
    }

    /// Every run: the schemes in the order of the study, each from its largest step to its smallest.
    pub fn rows(&self) -> &[StudyRow] {
        &self.rows
    }

    /// Names and declared orders of the schemes.
    pub fn schemes(&self) -> &[(&'static str, u32)] {
        &self.schemes
    }

    /// The rows of one scheme, counted from 0.
    pub fn rows_of(&self, scheme: usize) -> impl Iterator<Item = &StudyRow> {
        self.rows.iter().filter(move |row| row.entrant() == scheme)
    }

    /// The times of start and end.
    pub fn span(&self) -> [f64; 2] {
        self.span
    }

    /// What errors were measured against; `None` if it was an exact solution.
    pub fn reference(&self) -> Option<&Reference> {
        self.reference.as_ref()
    }

    /// Errors below this cannot be told: that of the reference, and in any case the rounding of the position.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// The time that each scheme needs for an error, in the order of [`schemes`](StudyReport::schemes); `None` where
    /// its ladder does not reach it.
    pub fn time_at(&self, error: f64) -> Vec<(&'static str, Option<Duration>)> {
        self.times_at(error).map(|(name, cost)| (name, cost.map(|cost| seconds(cost.value())))).collect()
    }

    /// The evaluations of the force that each scheme needs for an error, likewise: the same on every machine.
    pub fn evaluations_at(&self, error: f64) -> Vec<(&'static str, Option<f64>)> {
        let evaluations = self.at(error, |figures| figures.evaluations as f64);
        evaluations.map(|(name, cost)| (name, cost.map(Cost::value))).collect()
    }

    /// The scheme that needs the least time for an error, and that time; `None` where none reaches it.
    pub fn fastest_at(&self, error: f64) -> Option<(&'static str, Duration)> {
        let times = self.time_at(error).into_iter();
        times.filter_map(|(name, time)| time.map(|time| (name, time))).min_by_key(|(_, time)| *time)
    }

    /// In seconds.
    pub(super) fn times_at(&self, error: f64) -> impl Iterator<Item = (&'static str, Option<Cost>)> {
        self.at(error, |figures| figures.time.as_secs_f64().max(1e-9))
    }

    fn at(&self, error: f64, cost: fn(&Figures) -> f64) -> impl Iterator<Item = (&'static str, Option<Cost>)> {
        let known = error >= self.resolution;
        self.schemes.iter().enumerate().map(move |(scheme, (name, _))| {
            let figures = self.rows_of(scheme).filter_map(|row| row.result().ok());
            let points: Vec<_> = figures.map(|figures| (figures.error.max(self.resolution), cost(figures))).collect();
            (*name, if known { cost_at(error, &points) } else { None })
        })
    }
}

/// A time; the longest there is where it has no other.
pub(super) fn seconds(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX)
}
