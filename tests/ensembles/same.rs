//! Two sets of results.

use dmech::extend::{Fields, Rides};
use dmech::prelude::*;

use crate::laws::Many;

/// All that can be seen of two sets of results.
pub(crate) fn the_same<const D: usize>(a: &EnsembleRun<State<D>>, b: &EnsembleRun<State<D>>) {
    assert_eq!((a.checksum(), a.len()), (b.checksum(), b.len()));
    for k in 0..a.len() {
        let [one, other] = [a, b].map(|run| match run.member(k) {
            Ok(run) => (None, run),
            Err(failed) => (Some(format!("{:?}", failed.cause())), failed.run()),
        });
        assert_eq!(one.0, other.0, "{k}");
        let (one, other) = (one.1, other.1);
        // As text, where NaN is NaN and −0 is not 0.
        let text = |run: &Run<State<D>>| {
            format!("{:?} {:?} {} {:?} {}", run.last(), run.states(), run.steps(), run.events(), run.stopped())
        };
        assert_eq!(text(one), text(other), "{k}");
        let report = |run: &Run<State<D>>| {
            let report = run.report();
            let drifts: Vec<_> = Invariant::ALL.iter().map(|&of| (report.drift(of), report.kept(of))).collect();
            let own: Vec<_> = report.own_drifts().collect();
            let cost = (report.evaluations(), report.iterations(), report.rough(), report.dt_range());
            format!(
                "{drifts:?} {own:?} {cost:?} {} {} {:?} {}",
                report.scheme(),
                report.dt(),
                report.tolerance(),
                report.mass()
            )
        };
        assert_eq!(report(one), report(other), "{k}");
    }
}

pub(crate) type Made<L, S, const D: usize> = Ensemble<fn(usize) -> L, fn(usize) -> State<D>, S>;

/// Members of a law of the suite.
pub(crate) fn of<L: Many<D> + Fields<D>, S: Rides<L, D> + Sync, const D: usize>(
    members: usize,
    scheme: S,
) -> Made<L, S, D> {
    let law: fn(usize) -> L = L::member;
    let start: fn(usize) -> State<D> = L::start;
    Ensemble::of(members).law(law).start(start).scheme(scheme)
}
