//! Ensembles that several processes move together.

mod assist;
mod message;
mod relay;

use core::fmt;
use std::time::{Duration, Instant};

use assist::assist;
use message::SetUp;
use relay::Relay;

use super::{Ensemble, EnsembleRun, Members, Outcome};
use crate::error::Error;
use crate::law::Fields;
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

impl<L, X, S, M, C, R: Ranks + ?Sized> Ranked<'_, Ensemble<L, X, S, M, C>, R> {
    /// [`Ensemble::run`]: in the first rank what has come of all members, `None` in the others.
    ///
    /// # Errors
    /// As [`Ensemble::run`]; [`Error::OtherEnsemble`] in the first rank where a rank has another ensemble, and in the others
    /// [`Error::FirstRank`] where the first has failed.
    pub fn run<Y: Fields<D>, const D: usize>(self, steps: u64) -> Result<Option<EnsembleRun<State<D>>>, Error>
    where
        Ensemble<L, X, S, M, C>: Members<Y, D>,
    {
        self.collect(Span::Steps(steps))
    }

    /// [`Ensemble::run_until`]: in the first rank what has come of all members, `None` in the others.
    ///
    /// # Errors
    /// As [`run`](Ranked::run).
    pub fn run_until<Y: Fields<D>, const D: usize>(self, end: f64) -> Result<Option<EnsembleRun<State<D>>>, Error>
    where
        Ensemble<L, X, S, M, C>: Members<Y, D>,
    {
        self.collect(Span::Until(end))
    }

    /// [`Ensemble::for_each_until`]: every member is seen by the first rank, in order.
    ///
    /// # Errors
    /// As [`run`](Ranked::run).
    pub fn for_each_until<Y: Fields<D>, const D: usize>(
        self,
        end: f64,
        mut see: impl FnMut(usize, Outcome<State<D>>),
    ) -> Result<(), Error>
    where
        Ensemble<L, X, S, M, C>: Members<Y, D>,
    {
        self.go(Span::Until(end), &mut see)
    }

    fn collect<Y: Fields<D>, const D: usize>(self, span: Span) -> Result<Option<EnsembleRun<State<D>>>, Error>
    where
        Ensemble<L, X, S, M, C>: Members<Y, D>,
    {
        let (clock, mut members) = (Instant::now(), Vec::new());
        self.go(span, &mut |_, member| members.push(member))?;
        Ok((self.ranks.rank() == 0).then(|| EnsembleRun::new(members, clock.elapsed())))
    }

    fn go<Y: Fields<D>, const D: usize>(
        &self,
        span: Span,
        see: &mut dyn FnMut(usize, Outcome<State<D>>),
    ) -> Result<(), Error>
    where
        Ensemble<L, X, S, M, C>: Members<Y, D>,
    {
        let Ranked { ensemble, ranks } = self;
        let (member, bare) = (|k| ensemble.member(k), |k| ensemble.bare(k));
        let plan = ensemble.plan(span, &member, &bare)?;
        let set_up = SetUp::of(&plan);
        if ranks.rank() > 0 {
            return assist(*ranks, &plan, ensemble.hands.threads(), set_up);
        }
        ensemble.go(&plan, see, Relay::new(*ranks, &plan, set_up))
    }
}
