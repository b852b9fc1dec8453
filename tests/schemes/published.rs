//! Ends in print: the position to as many digits as a scheme reaches there.

use dmech::prelude::*;
use dmech::{StudyError, StudyReport};
use dmech_tests::published::{ClosedOrbit, MOON, PLEIADES_END, four_loops, pleiades, three_loops};

/// The error of the one run of a study.
fn error(report: Result<StudyReport, StudyError>) -> f64 {
    let report = report.unwrap();
    report.rows()[0].result().unwrap().error()
}

#[test]
fn pleiades_end_as_printed() {
    let end: Vec<_> = PLEIADES_END.map(|(q, _)| q).into();
    let study = Study::scene(pleiades(), 3.0).exact(move |_| end.clone());
    let found = error(study.adaptive(Nystrom::order8(), [1e-13]).run());
    assert!(found < 3e-11, "{found:e}");
}

/// A force that is linear in the velocity, and 0.006 from the moon twice.
#[test]
fn closed_orbits_close() {
    for ClosedOrbit { start, period, end } in [four_loops(), three_loops()] {
        let study = Study::new(MOON, start, period).exact(|_| end.q);
        let found = error(study.adaptive(Composed::order8(Boris), [1e-13]).run());
        assert!(found < 3e-11, "{found:e}");
    }
}
