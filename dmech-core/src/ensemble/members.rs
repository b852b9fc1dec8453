//! Members of one law.

use core::ops::Range;

use super::Ensemble;
use super::block::{Block, Outcome};
use super::company::Companies;
use super::in_order::Blocks;
use super::plan::Plan;
use super::rides::Rides;
use crate::law::Fields;
use crate::run::{Attend, Simulation};
use crate::span::Span;
use crate::state::State;

/// The laws of members.
#[diagnostic::on_unimplemented(
    message = "the members of this ensemble have no laws yet",
    label = "call `.law(|k| …)` first",
    note = "where they are no laws with one start each, `Ensemble::each` takes simulations of any kind"
)]
pub trait LawOf<L>: Fn(usize) -> L {}

#[diagnostic::do_not_recommend]
impl<L, F: Fn(usize) -> L> LawOf<L> for F {}

/// The starts of members.
#[diagnostic::on_unimplemented(
    message = "the members of this ensemble have no starts yet",
    label = "call `.start(|k| …)` first",
    note = "what accompanies a member sees its states: `.with(…)` comes after `.start(…)`"
)]
pub trait Starts<const D: usize>: Fn(usize) -> State<D> {}

#[diagnostic::do_not_recommend]
impl<const D: usize, F: Fn(usize) -> State<D>> Starts<D> for F {}

/// An ensemble that has all that its members need: laws, starts, masses, and a scheme that moves them.
pub trait Members<L: Fields<D>, const D: usize>: Sync {
    /// The scheme of all.
    type Scheme: Rides<L, D> + Sync;
    /// What accompanies each.
    type Attend: Attend<State<D>>;

    /// What all have in common.
    #[doc(hidden)]
    fn common(&self) -> &Simulation<(), (), Self::Scheme>;

    /// One of them, without what accompanies it.
    #[doc(hidden)]
    fn bare(&self, k: usize) -> Simulation<L, State<D>, Self::Scheme>;

    /// One of them.
    #[doc(hidden)]
    fn member(&self, k: usize) -> Simulation<L, State<D>, Self::Scheme, Self::Attend>;
}

impl<F, X, S, M, C, L, const D: usize> Members<L, D> for Ensemble<F, X, S, M, C>
where
    F: LawOf<L> + Sync,
    X: Starts<D> + Sync,
    M: Fn(usize) -> f64 + Sync,
    L: Fields<D>,
    S: Rides<L, D> + Sync,
    C: Companies<State<D>>,
{
    type Scheme = S;
    type Attend = C::Attend;

    fn common(&self) -> &Simulation<(), (), S> {
        &self.common
    }

    fn bare(&self, k: usize) -> Simulation<L, State<D>, S> {
        self.common.clone().moving((self.law)(k), (self.start)(k)).mass((self.mass)(k))
    }

    fn member(&self, k: usize) -> Simulation<L, State<D>, S, C::Attend> {
        self.bare(k).accompanied(self.company.of(k))
    }
}

/// Members of one law, as they move.
pub(super) struct OneLaw<'a, L, S, O, const D: usize> {
    pub(super) members: usize,
    pub(super) member: &'a (dyn Fn(usize) -> Simulation<L, State<D>, S, O> + Sync),
    /// One without what accompanies it: for those who only ask what it is.
    #[cfg_attr(not(any(feature = "ranks", feature = "store")), expect(dead_code, reason = "nobody else has to know"))]
    pub(super) bare: &'a (dyn Fn(usize) -> Simulation<L, State<D>, S> + Sync),
    /// What all have in common.
    #[cfg_attr(not(any(feature = "ranks", feature = "store")), expect(dead_code, reason = "nobody else has to know"))]
    pub(super) common: &'a Simulation<(), (), S>,
    pub(super) span: Span,
    /// The work of the steps is summed.
    pub(super) work: bool,
    /// How many side by side.
    pub(super) lanes: usize,
}

impl<L: Fields<D>, S: Rides<L, D> + Sync, O: Attend<State<D>>, const D: usize> Plan<State<D>>
    for OneLaw<'_, L, S, O, D>
{
    fn members(&self) -> usize {
        self.members
    }

    fn blocks(&self, threads: usize) -> Blocks {
        Blocks::of(self.members, threads).of_coordinates(D)
    }

    fn go(&self, members: Range<usize>) -> Vec<Outcome<State<D>>> {
        let OneLaw { member, span, work, lanes, .. } = *self;
        S::ride(&Block { members, member, span, work, lanes })
    }
}
