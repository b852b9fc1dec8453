//! Runs that were made before, put together again.

use super::motion::kept;
use super::report::{Cost, Report};
use super::{Event, Run, Simulation};
use crate::drift::{Drifts, OwnDrifts};
use crate::error::Error;
use crate::invariant::Invariant;
use crate::method::Method;
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
    pub(crate) own: OwnDrifts,
    pub(crate) work: Cost,
}

impl<X: Clone> Run<X> {
    /// The same of a run.
    pub(crate) fn to_restore(&self) -> Restored<X> {
        let drifts = Invariant::ALL.map(|invariant| self.drift(invariant));
        let mut own = OwnDrifts::default();
        self.report.own_drifts().for_each(|(name, drift)| own.add(name, drift));
        let Run { last, states, events, stopped, .. } = self.clone();
        Restored { last, states, events, stopped, drifts, own, work: self.report.work() }
    }
}

impl<X> Restored<X> {
    /// The run of a scheme, with what it says it keeps of any system.
    fn run<M: Method>(self, scheme: &M, dt: Option<f64>, mass: f64) -> Run<X> {
        let mut run = Run::empty(self.last, Report::new(scheme, dt, mass));
        (run.states, run.events, run.stopped) = (self.states, self.events, self.stopped);
        run.report.finish(self.drifts, self.own, self.work);
        run
    }
}

impl<L, X: Setup<L>, S> Simulation<L, X, S> {
    /// The run that this simulation gave; whatever accompanied it is not asked again.
    pub(crate) fn restore(self, before: Restored<X::State>) -> Result<Run<X::State>, Error>
    where
        S: Scheme<X::System>,
    {
        let length = self.step_length::<<X::System as System>::Scalar>()?;
        let Simulation { law, start, scheme, settings, .. } = self;
        let mut run = before.run(&scheme, settings.dt, start.whole_mass(settings.mass));
        let system = start.system(law, settings.mass, length)?;
        run.report.keep(kept::<X::System, S>(&system));
        Ok(run)
    }
}
