//! Two sets of results.

use std::fmt::Debug;

use dmech::extend::{Columns, Fields, Rides};
use dmech::prelude::*;

use crate::laws::Many;

/// All that can be seen of what became of a member, as text, where NaN is NaN and −0 is not 0.
pub(crate) fn outcome<X: Debug>(member: Result<&Run<X>, &Interrupted<X>>) -> String {
    let (cause, run) = match member {
        Ok(run) => (None, run),
        Err(failed) => (Some(failed.cause()), failed.run()),
    };
    let report = run.report();
    let drifts: Vec<_> = Invariant::ALL.iter().map(|&of| (report.drift(of), report.kept(of))).collect();
    let own: Vec<_> = report.own_drifts().collect();
    let cost = (report.evaluations(), report.iterations(), report.rough(), report.dt_range());
    let (dt, tolerance, mass) = (report.dt(), report.tolerance(), report.mass());
    format!(
        "{cause:?} {:?} {:?} {} {:?} {} {drifts:?} {own:?} {cost:?} {} {dt} {tolerance:?} {mass}",
        run.last(),
        run.states(),
        run.steps(),
        run.events(),
        run.stopped(),
        report.scheme()
    )
}

/// All that can be seen of two sets of results.
pub(crate) fn the_same<X: Clone + Columns + Debug>(a: &EnsembleRun<X>, b: &EnsembleRun<X>) {
    assert_eq!((a.checksum(), a.len()), (b.checksum(), b.len()));
    for k in 0..a.len() {
        assert_eq!(outcome(a.member(k)), outcome(b.member(k)), "{k}");
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
