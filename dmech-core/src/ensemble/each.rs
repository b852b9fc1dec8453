//! Simulations of any kind, over the cores.

use core::ops::Range;
use std::time::Instant;

use super::EnsembleRun;
use super::in_order::{Blocks, Direct, Hands, Nobody, in_order};
use super::rides::Outcome;
use crate::error::Error;
use crate::run::{Attend, Follow, Shown, Simulation};
use crate::scheme::Scheme;
use crate::setup::Setup;
use crate::span::Span;

/// Simulations of any kind, made by [`Ensemble::each`](crate::Ensemble::each).
#[derive(Clone, Debug)]
#[must_use = "an ensemble does nothing until it is run"]
pub struct Each<F> {
    pub(super) member: F,
    pub(super) members: usize,
    pub(super) hands: Hands,
    pub(super) shown: Shown,
}

impl<F> Each<F> {
    /// On so many threads, 1024 at most; on all cores if nothing is said. The results are the same.
    pub fn threads(self, threads: usize) -> Self {
        Each { hands: Hands { threads: Some(threads), ..self.hands }, ..self }
    }

    /// Makes a number of steps with each member, or fewer where an event or an observer stops it.
    ///
    /// # Errors
    /// None yet; what fails of a member is in its [result](EnsembleRun::last).
    pub fn run<L, X, S, O>(self, steps: u64) -> Result<EnsembleRun<X::State>, Error>
    where
        F: Fn(usize) -> Simulation<L, X, S, O> + Sync,
        X: Setup<L, State: Send>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
    {
        self.collect(Span::Steps(steps))
    }

    /// Moves each member until a time: [`Simulation::run_until`].
    ///
    /// # Errors
    /// As [`run`](Each::run).
    pub fn run_until<L, X, S, O>(self, end: f64) -> Result<EnsembleRun<X::State>, Error>
    where
        F: Fn(usize) -> Simulation<L, X, S, O> + Sync,
        X: Setup<L, State: Send>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
    {
        self.collect(Span::Until(end))
    }

    fn collect<L, X, S, O>(self, span: Span) -> Result<EnsembleRun<X::State>, Error>
    where
        F: Fn(usize) -> Simulation<L, X, S, O> + Sync,
        X: Setup<L, State: Send>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
    {
        let Each { member, members, hands, shown } = self;
        let (clock, threads) = (Instant::now(), hands.threads());
        let mut all = All { outcomes: Vec::with_capacity(members), follow: Follow::new(shown, members as u64) };
        let work = |members: Range<usize>| members.map(|k| member(k).record(span)).collect::<Vec<_>>();
        in_order(Blocks::of(members, threads), threads, work, &mut all, &mut Nobody)?;
        all.follow.end(members as u64, true);
        Ok(EnsembleRun::new(all.outcomes, clock.elapsed()))
    }
}

struct All<X> {
    outcomes: Vec<Outcome<X>>,
    follow: Follow,
}

impl<X: Send> Direct for All<X> {
    type Job = Range<usize>;
    type Result = Vec<Outcome<X>>;

    fn job(&mut self, members: Range<usize>) -> Range<usize> {
        members
    }

    fn take(&mut self, members: Range<usize>, outcomes: Vec<Outcome<X>>) -> Result<(), Error> {
        self.outcomes.extend(outcomes);
        self.follow.look(members.end as u64);
        Ok(())
    }
}
