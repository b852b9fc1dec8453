//! Running: the loop, what it records and watches, what comes back.

mod csv;
mod interrupted;
mod motion;
mod progress;
mod report;
mod watch;

pub use csv::Columns;
pub use interrupted::Interrupted;
pub(crate) use motion::record;
pub(crate) use progress::Shown;
pub use report::Report;
pub use watch::Watch;

use crate::invariant::{Drift, Drifts, Invariant, Kept, OwnDrifts};
use crate::scheme::Method;
use report::Work;

/// The recorded states of a simulation, what it kept and what it cost.
///
/// It does not name the law or the scheme in its type, so runs of different schemes fit into one array.
#[derive(Clone, Debug)]
pub struct Run<X> {
    states: Vec<X>,
    last: X,
    report: Report,
}

/// States to make room for in advance; a longer run grows as it goes.
const ROOM: u64 = 1 << 16;

impl<X> Run<X> {
    pub(crate) fn empty<M: Method>(start: X, scheme: &M, dt: f64, mass: f64) -> Self {
        let kept = Invariant::ALL.map(M::keeps);
        Run { states: Vec::new(), last: start, report: Report::new(scheme, dt, mass, kept) }
    }

    pub(crate) fn expect(&mut self, states: u64) {
        self.states.reserve(1 + states.min(ROOM) as usize);
    }

    /// The states that were recorded: the first, then every n-th.
    pub fn states(&self) -> &[X] {
        &self.states
    }

    /// The state at the end, also where it was not due to be recorded.
    pub fn last(&self) -> &X {
        &self.last
    }

    /// Steps completed.
    pub fn steps(&self) -> u64 {
        self.report.steps()
    }

    /// How an invariant moved over the recorded states and the last; `None` where the law, or the scheme, has no such
    /// invariant.
    pub fn drift(&self, invariant: Invariant) -> Option<Drift> {
        self.report.drift(invariant)
    }

    /// How an invariant moved that the law declares itself, a method `#[invariant] fn name(…)`; `None` where it has none of
    /// this name.
    pub fn drift_of(&self, name: &str) -> Option<Drift> {
        self.report.drift_of(name)
    }

    /// How well the scheme must keep an invariant that the law has.
    pub fn kept(&self, invariant: Invariant) -> Kept {
        self.report.kept(invariant)
    }

    /// Invariants, work and time; `Display` shows it as a table.
    pub fn report(&self) -> &Report {
        &self.report
    }
}

impl<X: Clone> Run<X> {
    pub(crate) fn record(&mut self, state: X) {
        self.last = state.clone();
        self.states.push(state);
    }

    pub(crate) fn finish(&mut self, last: X, drifts: Drifts, own: OwnDrifts, work: Work) {
        self.last = last;
        self.report.finish(drifts, own, work);
    }
}

impl<X> core::fmt::Display for Run<X> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.report.fmt(f)
    }
}
