//! Runs that were made before, put together again.

use super::report::Work;
use super::{Attend, Event, Run, Simulation};
use crate::error::Error;
use crate::invariant::{Drift, Drifts, Invariant, MAX_OWN, OwnDrifts};
use crate::scheme::Scheme;
use crate::setup::Setup;
use crate::system::System;

/// What a run does not have of its simulation.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Restored<X> {
    pub(crate) last: X,
    pub(crate) states: Vec<X>,
    pub(crate) events: Vec<Event<X>>,
    pub(crate) stopped: bool,
    pub(crate) drifts: Drifts,
    /// Of the law itself, then those that were watched.
    pub(crate) own: [Option<Drift>; 2 * MAX_OWN],
    pub(crate) work: Work,
}

impl<X: Clone> Run<X> {
    /// The same of a run.
    pub(crate) fn to_restore(&self) -> Restored<X> {
        let mut own = [None; 2 * MAX_OWN];
        own.iter_mut().zip(self.report.own_drifts()).for_each(|(place, (_, drift))| *place = Some(drift));
        let drifts = Invariant::ALL.map(|invariant| self.drift(invariant));
        let Run { last, states, events, stopped, .. } = self.clone();
        Restored { last, states, events, stopped, drifts, own, work: self.report.work() }
    }
}

impl<L, X: Setup<L>, S, O: Attend<X::State>> Simulation<L, X, S, O> {
    /// The run that this simulation gave.
    pub(crate) fn restore(self, before: Restored<X::State>) -> Result<Run<X::State>, Error>
    where
        S: Scheme<X::System>,
    {
        let length = self.step_length::<<X::System as System>::Scalar>()?;
        let Simulation { law, start, scheme, settings, mut attend } = self;
        let first = start.start();
        let mut run = Run::empty(before.last, &scheme, settings.dt.unwrap_or(f64::NAN), start.mass(settings.mass));
        let system = start.system(law, settings.mass, length)?;
        (run.states, run.events, run.stopped) = (before.states, before.events, before.stopped);
        run.report.keep(Invariant::ALL.map(|invariant| S::kept(&system, invariant)));
        let mut names = system.own_invariants().to_vec();
        attend.look(<X::System as System>::time(&first), &first);
        attend.drifts(&mut |name, _| names.push(name));
        let mut own = OwnDrifts::default();
        for (name, drift) in names.into_iter().zip(before.own) {
            drift.into_iter().for_each(|drift| own.add(name, drift));
        }
        run.report.finish(before.drifts, own, before.work);
        Ok(run)
    }
}
