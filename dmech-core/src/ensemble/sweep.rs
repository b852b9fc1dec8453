//! Moving all members of one law.

use super::in_order::Nobody;
use super::members::{Members, OneLaw};
use super::plan::{Nowhere, Opened, See, Tally, sweep};
#[cfg(feature = "store")]
use super::store::Stored;
use super::{Ensemble, EnsembleRun, Outcome};
use crate::error::Error;
use crate::law::Fields;
use crate::method::Method;
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
        EnsembleRun::gathered(self.members, &|see| self.go(Span::Steps(steps), see))
    }

    /// Moves each member until a time: [`Simulation::run_until`](crate::Simulation::run_until).
    ///
    /// # Errors
    /// As [`run`](Ensemble::run); an `end` before the starts of all members is refused.
    pub fn run_until<Y: Fields<D>, const D: usize>(self, end: f64) -> Result<EnsembleRun<State<D>>, Error>
    where
        Self: Members<Y, D>,
    {
        EnsembleRun::gathered(self.members, &|see| self.go(Span::Until(end), see))
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
        self.go(Span::Until(end), &mut see).map(|_| ())
    }

    fn go<Y: Fields<D>, const D: usize>(&self, span: Span, see: See<'_, State<D>>) -> Result<Tally, Error>
    where
        Self: Members<Y, D>,
    {
        self.planned(span, |plan| sweep(plan, (self.hands, self.beside.shown.clone()), self.open(plan), see, Nobody))
    }

    /// What is to be done, unless all of it is refused.
    pub(super) fn planned<Y: Fields<D>, T, const D: usize>(
        &self,
        span: Span,
        then: impl FnOnce(&PlanOf<'_, Self, Y, D>) -> Result<T, Error>,
    ) -> Result<T, Error>
    where
        Self: Members<Y, D>,
    {
        let common = self.common();
        // What every member would be refused for is one error.
        common.settings.check_for_all(&common.scheme, span)?;
        self.check_end(span)?;
        let (member, bare) = (|k| self.member(k), |k| self.bare(k));
        let Ensemble { members, ref beside, ref hands, .. } = *self;
        then(&OneLaw { members, member: &member, bare: &bare, common, span, work: beside.work, lanes: hands.lanes })
    }

    /// Refuses an end that lies before the start of every member.
    fn check_end<Y: Fields<D>, const D: usize>(&self, span: Span) -> Result<(), Error>
    where
        Self: Members<Y, D>,
    {
        if matches!(span, Span::Steps(_)) {
            return Ok(());
        }
        let common = self.common();
        let (dt, equal) = (common.step_length::<f64>()?, common.scheme.tolerance().is_none());
        let mut refused = Ok(());
        for k in 0..self.members {
            match span.steps(self.bare(k).start.t, dt, equal.then_some(f64::EPSILON)) {
                Err(before @ Error::Span { .. }) => refused = refused.and(Err(before)),
                _ => return Ok(()),
            }
        }
        refused
    }

    /// Where they are kept.
    pub(super) fn open<'a, Y: Fields<D>, const D: usize>(
        &self,
        plan: &'a PlanOf<'a, Self, Y, D>,
    ) -> Opened<'a, State<D>>
    where
        Self: Members<Y, D>,
    {
        #[cfg(feature = "store")]
        if let Some(path) = &self.beside.path {
            return Stored::open(path, plan);
        }
        #[cfg(not(feature = "store"))]
        let _ = plan;
        Ok(Box::new(Nowhere))
    }
}

/// What is to be done with all of them.
pub(super) type PlanOf<'a, E, L, const D: usize> =
    OneLaw<'a, L, <E as Members<L, D>>::Scheme, <E as Members<L, D>>::Attend, D>;
