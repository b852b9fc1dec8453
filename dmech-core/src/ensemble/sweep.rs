//! Moving all members of an ensemble.

use std::time::Instant;

use super::in_order::{Aides, Nobody};
use super::members::{Bare, Members, Moving, PlanOf};
use super::plan::{Arrival, Moved, Nowhere, Plan, Ranges};
#[cfg(feature = "store")]
use super::store::Stored;
use super::{Ensemble, EnsembleRun, Outcome};
use crate::error::Error;
use crate::law::Fields;
use crate::run::Follow;
use crate::span::Span;
use crate::state::State;

impl<L, X, S, M, C> Ensemble<L, X, S, M, C> {
    /// Makes a number of steps with each member.
    ///
    /// # Errors
    /// [`Error`] for what is refused for all: a step or a tolerance. What fails of a member is in its [result](EnsembleRun::last).
    pub fn run<Y: Fields<D>, const D: usize>(self, steps: u64) -> Result<EnsembleRun<State<D>>, Error>
    where
        Self: Members<Y, D>,
    {
        self.collect(Span::Steps(steps))
    }

    /// Moves each member until a time: [`Simulation::run_until`](crate::Simulation::run_until).
    ///
    /// # Errors
    /// As [`run`](Ensemble::run).
    pub fn run_until<Y: Fields<D>, const D: usize>(self, end: f64) -> Result<EnsembleRun<State<D>>, Error>
    where
        Self: Members<Y, D>,
    {
        self.collect(Span::Until(end))
    }

    /// Moves each member until a time, and hands each to a function in their order, with its number: means, extrema, histograms, and
    /// files. Nothing is kept, so that there is room for any number.
    ///
    /// # Errors
    /// As [`run`](Ensemble::run).
    pub fn for_each_until<Y: Fields<D>, const D: usize>(
        self,
        end: f64,
        mut see: impl FnMut(usize, Outcome<State<D>>),
    ) -> Result<(), Error>
    where
        Self: Members<Y, D>,
    {
        self.go(&self.plan(Span::Until(end), &|k| self.member(k), &|k| self.bare(k))?, &mut see, Nobody)
    }

    fn collect<Y: Fields<D>, const D: usize>(self, span: Span) -> Result<EnsembleRun<State<D>>, Error>
    where
        Self: Members<Y, D>,
    {
        let (clock, mut members) = (Instant::now(), Vec::with_capacity(self.members));
        self.go(
            &self.plan(span, &|k| self.member(k), &|k| self.bare(k))?,
            &mut |_, member| members.push(member),
            Nobody,
        )?;
        Ok(EnsembleRun::new(members, clock.elapsed()))
    }

    pub(super) fn plan<'a, Y: Fields<D>, const D: usize>(
        &'a self,
        span: Span,
        member: &'a (dyn Fn(usize) -> Moving<Self, Y, D> + Sync),
        bare: &'a (dyn Fn(usize) -> Bare<Self, Y, D> + Sync),
    ) -> Result<PlanOf<'a, Self, Y, D>, Error>
    where
        Self: Members<Y, D>,
    {
        let common = self.common();
        let dt = common.step_length::<f64>()?;
        // What every member would be refused for is one error.
        common.settings.due.check_for_any()?;
        span.check(dt)?;
        Ok(Plan { members: self.members, member, bare, common, span, lanes: self.hands.lanes })
    }

    /// Moves all members; those who help are told of the end.
    pub(super) fn go<Y: Fields<D>, const D: usize>(
        &self,
        plan: &PlanOf<'_, Self, Y, D>,
        see: &mut dyn FnMut(usize, Outcome<State<D>>),
        mut aides: impl Aides<Ranges, Moved<State<D>>>,
    ) -> Result<(), Error>
    where
        Self: Members<Y, D>,
    {
        let outcome = self.arrive(plan, see, &mut aides);
        let ended = aides.end(outcome.is_err());
        outcome.and(ended)
    }

    fn arrive<Y: Fields<D>, const D: usize>(
        &self,
        plan: &PlanOf<'_, Self, Y, D>,
        see: &mut dyn FnMut(usize, Outcome<State<D>>),
        aides: &mut impl Aides<Ranges, Moved<State<D>>>,
    ) -> Result<(), Error>
    where
        Self: Members<Y, D>,
    {
        let follow = Follow::new(self.beside.shown.clone(), self.members as u64);
        #[cfg(feature = "store")]
        if let Some(path) = &self.beside.path {
            let mut stored = match Stored::open(path, plan) {
                Ok(stored) => stored,
                Err(refused) => {
                    follow.end(0, false);
                    return Err(refused);
                }
            };
            plan.run(self.hands, Arrival { keep: &mut stored, see, follow, seen: 0 }, aides)?;
            return stored.close();
        }
        plan.run(self.hands, Arrival { keep: &mut Nowhere, see, follow, seen: 0 }, aides)
    }
}
