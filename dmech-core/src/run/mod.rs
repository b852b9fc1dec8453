//! Running: the loop, what it records and watches, what comes back.

mod attend;
mod between;
mod change;
mod csv;
mod due;
mod event;
mod history;
mod interrupted;
mod log;
mod motion;
mod npy;
mod observe;
mod output;
mod passage;
#[cfg(feature = "plot")]
mod picture;
mod progress;
mod quantity;
mod report;
#[cfg(any(feature = "ranks", feature = "store"))]
mod restored;
#[cfg(feature = "progress")]
mod shown;
mod simulation;
mod stream;
#[cfg(all(test, feature = "serde"))]
mod tests;
mod wall;
mod watch;
mod zero;

pub use attend::{After, Attend, Within};
pub use change::{Change, Changed};
pub use csv::{Columns, Csv};
pub(crate) use due::Due;
pub use event::{Crossing, Event};
pub use history::{History, HistoryPart};
pub use interrupted::Interrupted;
pub(crate) use log::Log;
pub(crate) use motion::Motion;
pub use npy::Npy;
pub use observe::Observer;
pub use passage::Passage;
#[cfg(feature = "scene")]
pub(crate) use passage::passes;
pub(crate) use progress::{Follow, Shown};
pub use quantity::Quantity;
#[cfg(any(feature = "ranks", feature = "store"))]
pub(crate) use report::Cost;
pub use report::Report;
#[cfg(any(feature = "ranks", feature = "store"))]
pub(crate) use restored::Restored;
#[cfg(feature = "progress")]
pub(crate) use shown::bar;
pub(crate) use simulation::Extent;
#[cfg(any(feature = "ranks", feature = "store"))]
pub(crate) use simulation::Settings;
pub use simulation::{Attended, Simulation};
pub use stream::{Sink, Stream};
pub use wall::Bounce;
#[cfg(feature = "scene")]
pub(crate) use wall::{Wall, is_further_behind};
pub use watch::Watch;

use crate::drift::{Drift, Drifts, OwnDrifts};
use crate::error::Error;
use crate::invariant::{Invariant, Kept};
#[cfg(not(any(feature = "ranks", feature = "store")))]
use report::Cost;

/// The recorded states of a simulation, what it kept and what it cost.
///
/// It does not name the law or the scheme in its type, so runs of different schemes fit into one array.
///
/// With the feature `serde` it can be written and read. JSON gives back every bit through `serde_json` with its feature
/// `float_roundtrip`; it has no NaN and no infinity, which become `null` and are then refused. The [history](Run::history) of its
/// invariants is not written.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Run<X> {
    states: Vec<X>,
    last: X,
    events: Vec<Event<X>>,
    stopped: bool,
    report: Report,
    /// Not of members of ensembles, nor of runs that were read.
    #[cfg_attr(feature = "serde", serde(skip))]
    histories: Option<Box<history::Histories>>,
}

/// States to make room for in advance, whatever the machine.
const ROOM: u64 = 1 << 16;

impl<X> Run<X> {
    pub(crate) fn empty(start: X, report: Report) -> Self {
        Run { states: Vec::new(), last: start, events: Vec::new(), stopped: false, report, histories: None }
    }

    /// Refuses more states, each of so many bytes, than there is memory for, before the run and not when it is full.
    fn expect(&mut self, states: u64, size: usize) -> Result<(), Error> {
        let bytes = states.saturating_mul(size as u64);
        let room = usize::try_from(bytes).is_ok_and(|bytes| Vec::<u8>::new().try_reserve_exact(bytes).is_ok());
        if states > ROOM && !room {
            return Err(Error::Recording { states, bytes });
        }
        self.states.reserve(states.min(ROOM) as usize);
        Ok(())
    }

    /// The states that were recorded: the first, then every n-th; or those at the times that were asked for.
    pub fn states(&self) -> &[X] {
        &self.states
    }

    /// The state at the end, also where it was not due to be recorded; the event that stopped the run, where one did.
    pub fn last(&self) -> &X {
        &self.last
    }

    /// What happened, in the order of time: [`Simulation::event`](crate::Simulation::event),
    /// [`stop_when`](crate::Simulation::stop_when).
    pub fn events(&self) -> &[Event<X>] {
        &self.events
    }

    /// Whether an event or an observer ended the run.
    pub fn stopped(&self) -> bool {
        self.stopped
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

    /// How an invariant moved that the law declares itself, a method `#[invariant] fn name(…)`, or a quantity that was
    /// [watched](crate::Simulation::watch); `None` where there is none of this name.
    pub fn drift_of(&self, name: &str) -> Option<Drift> {
        self.report.drift_of(name)
    }

    /// How an invariant moved, in numbers over time; what `plot_drift` draws. `None` where there is no such invariant, of members of an
    /// [`Ensemble`](crate::Ensemble), which may be many, and of runs that were written and read.
    pub fn history(&self, invariant: Invariant) -> Option<&History> {
        self.histories.as_ref()?.of(invariant)
    }

    /// The same of an invariant that the law declares itself, or of a quantity that was [watched](crate::Simulation::watch), by its
    /// name.
    pub fn history_of(&self, name: &str) -> Option<&History> {
        let k = self.report.own_drifts().position(|(own, _)| own == name)?;
        self.histories.as_ref()?.of_own(k)
    }

    /// How well the scheme must keep an invariant; [`Kept::No`] where [`drift`](Run::drift) is `None`, as that of the energy is under a
    /// drag.
    pub fn kept(&self, invariant: Invariant) -> Kept {
        self.report.kept(invariant)
    }

    /// Invariants, work and time; `Display` shows it as a table.
    pub fn report(&self) -> &Report {
        &self.report
    }

    fn record(&mut self, state: X) {
        self.states.push(state);
    }

    fn happened(&mut self, event: Event<X>) {
        self.events.push(event);
    }

    /// Of what happened again and again at one time, the first is enough.
    fn forget_repeats(&mut self, event: &Event<X>, time: fn(&X) -> f64) {
        let same = |other: &Event<X>| other.which() == event.which() && time(other.state()) == time(event.state());
        while let [.., before, last] = &self.events[..]
            && same(before)
            && same(last)
        {
            self.events.pop();
        }
    }

    fn finish(&mut self, stopped: Option<X>, last: impl FnOnce() -> X, drifts: (Drifts, OwnDrifts), work: Cost) {
        self.stopped = stopped.is_some();
        self.last = stopped.unwrap_or_else(last);
        self.report.finish(drifts.0, drifts.1, work);
    }
}

impl<X> core::fmt::Display for Run<X> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.report.fmt(f)
    }
}
