//! Ensembles that several processes move together.

mod assist;
mod message;
mod relay;

use core::fmt;
use std::time::Duration;

use assist::assist;
use message::Mark;
use relay::Relay;
use serde::Serialize;
use serde::de::DeserializeOwned;

use super::each::OneByOne;
use super::in_order::Hands;
use super::plan::{Opened, See, Tally, sweep};
use super::told::Told;
use super::{EachAlone, Ensemble, EnsembleRun, Keeps, Members, Outcome};
use crate::checkpoint::Saved;
use crate::error::Error;
use crate::flat::Flat;
use crate::law::Fields;
use crate::run::{Attend, Shown, Simulation};
use crate::scheme::Scheme;
use crate::setup::Setup;
use crate::span::Span;
use crate::state::State;

/// How long a message may wait until somebody looks for it.
const PATIENCE: Duration = Duration::from_micros(200);

/// Processes that run the same program and can send one another messages, as the ranks of MPI can: `dmech_mpi::World` is one.
///
/// Messages from one to another arrive in the order in which they were sent. The first rank sends short ones only, of some hundred bytes,
/// and must not wait for the one who receives.
pub trait Ranks {
    /// Which of them this is, from 0; the first hands out the work and has the results.
    fn rank(&self) -> usize;

    /// How many there are.
    fn count(&self) -> usize;

    /// Sends a message.
    fn send(&self, to: usize, message: &[u8]);

    /// A message that has come, and from whom; `None` where there is none yet.
    fn receive(&self) -> Option<(usize, Vec<u8>)>;
}

/// An ensemble that is moved by several processes: [`Ensemble::ranks`].
#[must_use = "an ensemble does nothing until it is run"]
pub struct Ranked<'a, E, R: ?Sized> {
    ensemble: E,
    ranks: &'a R,
}

impl<E: fmt::Debug, R: Ranks + ?Sized> fmt::Debug for Ranked<'_, E, R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Ranked { ensemble, ranks } = self;
        f.debug_struct("Ranked")
            .field("ensemble", ensemble)
            .field("rank", &ranks.rank())
            .field("count", &ranks.count())
            .finish()
    }
}

impl<L, X, S, M, C> Ensemble<L, X, S, M, C> {
    /// Moved by all ranks, each of which runs this same program: the first hands out blocks of members to its own threads and to any rank
    /// that asks for more, and takes what comes back in the order of members. The results, to the bit those of one process, are in the
    /// first rank; it alone opens the [store](Ensemble::store) and shows progress (feature `ranks`; with MPI the crate `dmech-mpi`).
    ///
    /// `threads` are those of each rank. A rank needs no thread of its own to hand out: between two messages it sleeps.
    pub fn ranks<R: Ranks + ?Sized>(self, ranks: &R) -> Ranked<'_, Self, R> {
        Ranked { ensemble: self, ranks }
    }
}

impl<F, K> EachAlone<F, K> {
    /// Moved by all ranks: [`Ensemble::ranks`], of simulations of any kind whose states can be written with serde (feature `ranks`). Each
    /// rank makes the members that it moves, and the first those that come home.
    pub fn ranks<R: Ranks + ?Sized>(self, ranks: &R) -> Ranked<'_, Self, R> {
        Ranked { ensemble: self, ranks }
    }
}

impl<E, R: Ranks + ?Sized> Ranked<'_, E, R> {
    /// [`Ensemble::run`]: in the first rank what has come of all members, `None` in the others.
    ///
    /// # Errors
    /// As [`Ensemble::run`]; [`Error::OtherEnsemble`] in the first rank where a rank has another ensemble, and in the others
    /// [`Error::FirstRank`] where the first has failed.
    pub fn run<M, X: Clone>(self, steps: u64) -> Result<Option<EnsembleRun<X>>, Error>
    where
        E: Travels<M, X>,
    {
        self.gathered(Span::Steps(steps))
    }

    /// [`Ensemble::run_until`]: in the first rank what has come of all members, `None` in the others.
    ///
    /// # Errors
    /// As [`run`](Ranked::run).
    pub fn run_until<M, X: Clone>(self, end: f64) -> Result<Option<EnsembleRun<X>>, Error>
    where
        E: Travels<M, X>,
    {
        self.gathered(Span::Until(end))
    }

    /// [`Ensemble::for_each_until`]: every member is seen by the first rank, in order.
    ///
    /// # Errors
    /// As [`run`](Ranked::run).
    pub fn for_each_until<M, X: Clone>(self, end: f64, mut see: impl FnMut(usize, Outcome<X>)) -> Result<(), Error>
    where
        E: Travels<M, X>,
    {
        self.ensemble.travel(self.ranks, Span::Until(end), &mut see).map(|_| ())
    }

    fn gathered<M, X: Clone>(self, span: Span) -> Result<Option<EnsembleRun<X>>, Error>
    where
        E: Travels<M, X>,
    {
        let run = EnsembleRun::gathered(0, &|see| self.ensemble.travel(self.ranks, span, see))?;
        Ok((self.ranks.rank() == 0).then_some(run))
    }
}

/// An ensemble whose members, of the kind M with states X, ranks can move together: one that can be run, with states that can be sent.
#[diagnostic::on_unimplemented(
    message = "this ensemble cannot be run on ranks yet",
    note = "it needs `.law(|k| …)`, `.start(|k| …)` and `.scheme(…)`; of `Ensemble::each` simulations of laws or scenes, of numbers that are `Exact` and written with serde"
)]
pub trait Travels<M, X> {
    /// Moves all members; the first rank sees them.
    #[doc(hidden)]
    fn travel<R: Ranks + ?Sized>(&self, ranks: &R, span: Span, see: See<'_, X>) -> Result<Tally, Error>;
}

impl<L, X, S, M, C, Y: Fields<D>, const D: usize> Travels<Y, State<D>> for Ensemble<L, X, S, M, C>
where
    Self: Members<Y, D>,
{
    fn travel<R: Ranks + ?Sized>(&self, ranks: &R, span: Span, see: See<'_, State<D>>) -> Result<Tally, Error> {
        self.planned(span, |plan| {
            together(ranks, plan, (self.hands, self.beside.shown.clone()), || self.open(plan), see)
        })
    }
}

#[diagnostic::do_not_recommend]
impl<F, K, L, X, S, O> Travels<(L, X, S, O), X::State> for EachAlone<F, K>
where
    F: Fn(usize) -> Simulation<L, X, S, O> + Sync,
    X: Setup<L, State: Flat + Serialize + DeserializeOwned, System: Saved>,
    S: Scheme<X::System>,
    O: Attend<X::State>,
    K: Keeps<L, X, S, O>,
{
    fn travel<R: Ranks + ?Sized>(&self, ranks: &R, span: Span, see: See<'_, X::State>) -> Result<Tally, Error> {
        let plan = OneByOne { members: self.members, member: &self.member, span };
        together(ranks, &plan, (self.hands, self.shown.clone()), || self.keep.open(&plan), see)
    }
}

/// The first rank hands out and sees what comes, the others move what they are given.
fn together<'a, R: Ranks + ?Sized, X: Clone + Send + Serialize + DeserializeOwned>(
    ranks: &R,
    plan: &dyn Told<X>,
    (hands, shown): (Hands, Shown),
    open: impl FnOnce() -> Opened<'a, X>,
    see: See<'_, X>,
) -> Result<Tally, Error> {
    let mark = Mark::of(plan);
    if ranks.rank() > 0 {
        return assist(ranks, plan, hands.threads(), mark).map(|()| Tally::default());
    }
    sweep(plan, (hands, shown), open(), see, Relay::new(ranks, plan, mark))
}
