//! Which steps a study takes.

use dmech_core::Error;

use super::row::StudyRow;
use crate::error::StudyError;
use crate::motion::Scales;

/// No run of a default ladder is followed by another with twice its work once it needed this many forces.
const MOST_FORCES: u64 = 1 << 21;

/// Halvings in a default ladder: enough for any law whose start has a time of its own.
const MOST_HALVINGS: i32 = 24;

/// From the largest step to the smallest, each once; none is longer than the span.
pub(super) fn steps(steps: Vec<f64>, span: f64) -> Result<Vec<f64>, StudyError> {
    let mut steps = falling(steps, StudyError::NoSteps, |dt| Error::TimeStep { dt })?;
    steps.iter_mut().for_each(|dt| *dt = dt.min(span));
    steps.dedup();
    Ok(steps)
}

/// Tolerances, likewise.
pub(super) fn tolerances(tolerances: &[f64]) -> Result<Vec<f64>, StudyError> {
    falling(tolerances.to_vec(), StudyError::NoTolerances, |tolerance| Error::Tolerance { tolerance })
}

fn falling(mut rungs: Vec<f64>, none: StudyError, refused: fn(f64) -> Error) -> Result<Vec<f64>, StudyError> {
    if rungs.is_empty() {
        return Err(none);
    }
    if let Some(&rung) = rungs.iter().find(|rung| !(**rung > 0.0 && rung.is_finite())) {
        return Err(refused(rung).into());
    }
    rungs.sort_by(|a, b| b.total_cmp(a));
    rungs.dedup();
    Ok(rungs)
}

/// h, h/2, h/4, …
pub(super) fn halvings(first: f64) -> impl Iterator<Item = f64> {
    (0..MOST_HALVINGS).map(move |k| first * f64::from(-k).exp2())
}

/// The rows of a scheme without a ladder: from a step that is too large, or the whole span, to one that is small enough.
pub(super) fn default(scales: &Scales, span: f64, resolution: f64, measure: impl Fn(f64) -> StudyRow) -> Vec<StudyRow> {
    let (first, mut rows) = (scales.time.min(span), Vec::new());
    for dt in halvings(first) {
        rows.push(measure(dt));
        if is_long_enough(&rows, scales.length, resolution) {
            break;
        }
    }
    let mut doubled = first;
    while rows[0].steps() > 1 && rows[0].result().is_ok_and(|figures| figures.error() < 1e-2 * scales.length) {
        doubled *= 2.0;
        rows.insert(0, measure(doubled));
    }
    rows
}

/// Whether a smaller step would tell nothing: the last one was costly, or halving it no longer lessens the error.
///
/// Errors count as no longer falling only where they are small against the length, or at the error of the reference:
/// large ones often rise before they fall. A run that fails may succeed with a smaller step.
fn is_long_enough(rows: &[StudyRow], length: f64, resolution: f64) -> bool {
    let figures = |row: &StudyRow| row.result().ok().copied();
    let Some(last) = rows.last().and_then(figures) else {
        let stands_still = |row: &StudyRow| matches!(row.result(), Err(Error::TimeStandsStill { .. }));
        return rows.last().is_some_and(|row| row.steps() > MOST_FORCES || stands_still(row));
    };
    let stalled = |before: f64| before < 1e-8 * length && last.error() > 0.5 * before;
    last.evaluations() >= MOST_FORCES
        || last.error() <= resolution
        || rows.iter().rev().nth(1).and_then(figures).is_some_and(|before| stalled(before.error()))
}
