//! An ensemble as it moves.

use core::ops::Range;

use super::in_order::{Aides, Blocks, Direct, Hands, in_order};
use super::rides::{Block, Outcome, Rides};
use crate::error::Error;
use crate::law::Fields;
use crate::run::{Attend, Follow, Simulation};
use crate::span::Span;
use crate::state::State;

/// What is to be done.
pub(super) struct Plan<'a, L, S, O, const D: usize> {
    pub(super) members: usize,
    pub(super) member: &'a (dyn Fn(usize) -> Simulation<L, State<D>, S, O> + Sync),
    /// One without what accompanies it: for those who only ask what it is.
    #[cfg_attr(not(any(feature = "ranks", feature = "store")), expect(dead_code, reason = "nobody else has to know"))]
    pub(super) bare: &'a (dyn Fn(usize) -> Simulation<L, State<D>, S> + Sync),
    /// What all have in common.
    #[cfg_attr(not(any(feature = "ranks", feature = "store")), expect(dead_code, reason = "nobody else has to know"))]
    pub(super) common: &'a Simulation<(), (), S>,
    pub(super) span: Span,
    /// How many side by side.
    pub(super) lanes: usize,
}

/// Members in rows.
pub(super) type Ranges = Vec<Range<usize>>;

/// Members that were moved, each with its number, in order.
pub(super) type Moved<X> = Vec<(usize, Outcome<X>)>;

impl<L: Fields<D>, S: Rides<L, D> + Sync, O: Attend<State<D>>, const D: usize> Plan<'_, L, S, O, D> {
    fn block(&self, members: Range<usize>) -> Block<'_, L, S, O, D> {
        Block { members, member: self.member, span: self.span, lanes: self.lanes }
    }

    /// Moves some.
    pub(super) fn go(&self, rows: Ranges) -> Moved<State<D>> {
        rows.into_iter().flat_map(|row| row.clone().zip(S::ride(&self.block(row)))).collect()
    }

    /// Moves all members, and hands them over as they arrive.
    pub(super) fn run<A>(&self, hands: Hands, mut arrival: Arrival<'_, State<D>>, aides: &mut A) -> Result<(), Error>
    where
        A: Aides<Ranges, Moved<State<D>>>,
    {
        let threads = hands.threads();
        let blocks = Blocks::of(self.members, threads * aides.processes()).of_coordinates(D);
        let outcome = in_order(blocks, threads, |rows| self.go(rows), &mut arrival, aides);
        arrival.follow.end(arrival.seen, outcome.is_ok());
        outcome
    }

    /// What accompanies each member, as far as it can be told without having it made: that may open files.
    #[cfg(any(feature = "ranks", feature = "store"))]
    pub(super) fn company(&self) -> String {
        let observed = if O::OBSERVES { ", observed" } else { "" };
        format!("{} events and {} watched quantities{observed}", O::EVENTS, O::QUANTITIES)
    }

    /// Moves one.
    #[cfg(feature = "ranks")]
    pub(super) fn alone(&self, k: usize) -> Outcome<State<D>> {
        self.block(k..k + 1).alone(k)
    }
}

/// Where members are kept before they are seen.
pub(super) trait Keep<X> {
    /// Those that are not there.
    fn missing(&self, members: Range<usize>) -> Ranges;

    /// Keeps those that were moved, and puts what was there between them.
    fn keep(&mut self, members: Range<usize>, moved: Moved<X>) -> Result<Vec<Outcome<X>>, Error>;
}

/// They are kept nowhere.
pub(super) struct Nowhere;

impl<X> Keep<X> for Nowhere {
    fn missing(&self, members: Range<usize>) -> Ranges {
        vec![members]
    }

    fn keep(&mut self, _: Range<usize>, moved: Moved<X>) -> Result<Vec<Outcome<X>>, Error> {
        Ok(moved.into_iter().map(|(_, outcome)| outcome).collect())
    }
}

/// The members on their way to where they are kept and seen.
pub(super) struct Arrival<'a, X> {
    pub(super) keep: &'a mut dyn Keep<X>,
    pub(super) see: &'a mut dyn FnMut(usize, Outcome<X>),
    pub(super) follow: Follow,
    /// How many were seen.
    pub(super) seen: u64,
}

impl<X: Send> Direct for Arrival<'_, X> {
    type Job = Ranges;
    type Result = Moved<X>;

    fn job(&mut self, members: Range<usize>) -> Ranges {
        self.keep.missing(members)
    }

    fn take(&mut self, members: Range<usize>, moved: Moved<X>) -> Result<(), Error> {
        let any = !moved.is_empty();
        for (k, outcome) in members.clone().zip(self.keep.keep(members.clone(), moved)?) {
            (self.see)(k, outcome);
        }
        self.seen = members.end as u64;
        if any {
            self.follow.look(self.seen);
        } else {
            self.follow.pass(self.seen);
        }
        Ok(())
    }
}
