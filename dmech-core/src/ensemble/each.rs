//! Simulations of any kind, over the cores.

use core::ops::Range;

use super::EnsembleRun;
use super::block::Outcome;
use super::in_order::{Blocks, Hands, Nobody};
use super::plan::{Nowhere, Opened, Plan, See, Tally, sweep};
use crate::error::Error;
use crate::run::{Attend, Shown, Simulation};
use crate::scheme::Scheme;
use crate::setup::Setup;
use crate::span::Span;

/// Simulations of any kind, made by [`Ensemble::each`](crate::Ensemble::each).
#[derive(Clone, Debug)]
#[must_use = "an ensemble does nothing until it is run"]
pub struct EachAlone<F, K = Nowhere> {
    pub(super) member: F,
    pub(super) members: usize,
    pub(super) hands: Hands,
    pub(super) shown: Shown,
    /// Where they are kept.
    pub(super) keep: K,
}

impl<F, K> EachAlone<F, K> {
    /// On so many threads, 1024 at most; on all cores if nothing is said. The results are the same.
    pub fn threads(self, threads: usize) -> Self {
        EachAlone { hands: Hands { threads: Some(threads), ..self.hands }, ..self }
    }

    /// Makes a number of steps with each member, or fewer where an event or an observer stops it.
    ///
    /// # Errors
    /// [`Error`] of a store. What fails of a member is in its [result](EnsembleRun::last).
    pub fn run<L, X, S, O>(self, steps: u64) -> Result<EnsembleRun<X::State>, Error>
    where
        F: Fn(usize) -> Simulation<L, X, S, O> + Sync,
        X: Setup<L, State: Send>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
        K: Keeps<L, X, S, O>,
    {
        EnsembleRun::gathered(self.members, &|see| self.go(Span::Steps(steps), see))
    }

    /// Moves each member until a time: [`Simulation::run_until`].
    ///
    /// # Errors
    /// As [`run`](EachAlone::run).
    pub fn run_until<L, X, S, O>(self, end: f64) -> Result<EnsembleRun<X::State>, Error>
    where
        F: Fn(usize) -> Simulation<L, X, S, O> + Sync,
        X: Setup<L, State: Send>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
        K: Keeps<L, X, S, O>,
    {
        EnsembleRun::gathered(self.members, &|see| self.go(Span::Until(end), see))
    }

    /// Moves each member until a time, and hands each to a function in their order, with its number:
    /// [`Ensemble::for_each_until`](crate::Ensemble::for_each_until). None is kept, so that there is room for any number.
    ///
    /// ```
    /// # #[cfg(feature = "scene")] {
    /// use dmech_core::prelude::*;
    /// # #[derive(Clone, Copy)]
    /// # struct Bowl { k: f64 }
    /// # impl Conservative for Bowl {}
    /// # impl Potential<1> for Bowl {
    /// #     fn potential(&self, [x]: [f64; 1]) -> f64 { 0.5 * self.k * x * x }
    /// #     fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] { [self.k * x] }
    /// #     fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] { [[self.k]] }
    /// #     fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] { [0.5 * self.k * (a + b)] }
    /// #     fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] { [[0.5 * self.k]] }
    /// # }
    /// // As many bodies as the number of the member says, and one more.
    /// let bowls = Ensemble::each(100, |k| {
    ///     let bodies = (0..=k).fold(Scene::new(), |scene, i| scene.body(1.0, [0.01 * i as f64], [0.3]));
    ///     Simulation::scene(bodies.field(Bowl { k: 2.0 })).scheme(Leapfrog).dt(0.01).record_every(100)
    /// });
    /// let mut farthest = 0.0_f64;
    /// bowls.for_each_until(5.0, |_, member| {
    ///     let last = member.unwrap().last().clone();
    ///     farthest = last.q.iter().fold(farthest, |most, [x]| most.max(x.abs()));
    /// })?;
    /// assert!(farthest > 0.1);
    /// # }
    /// # Ok::<(), dmech_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`run`](EachAlone::run).
    pub fn for_each_until<L, X, S, O>(
        self,
        end: f64,
        mut see: impl FnMut(usize, Outcome<X::State>),
    ) -> Result<(), Error>
    where
        F: Fn(usize) -> Simulation<L, X, S, O> + Sync,
        X: Setup<L, State: Send>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
        K: Keeps<L, X, S, O>,
    {
        self.go(Span::Until(end), &mut see).map(|_| ())
    }

    fn go<L, X, S, O>(&self, span: Span, see: See<'_, X::State>) -> Result<Tally, Error>
    where
        F: Fn(usize) -> Simulation<L, X, S, O> + Sync,
        X: Setup<L, State: Send>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
        K: Keeps<L, X, S, O>,
    {
        let plan = OneByOne { members: self.members, member: &self.member, span };
        sweep(&plan, (self.hands, self.shown.clone()), self.keep.open(&plan), see, Nobody)
    }
}

/// Simulations of any kind, as they move.
pub struct OneByOne<'a, L, X, S, O> {
    pub(super) members: usize,
    pub(super) member: &'a (dyn Fn(usize) -> Simulation<L, X, S, O> + Sync),
    pub(super) span: Span,
}

impl<L, X: Setup<L>, S: Scheme<X::System>, O: Attend<X::State>> Plan<X::State> for OneByOne<'_, L, X, S, O> {
    fn members(&self) -> usize {
        self.members
    }

    fn blocks(&self, threads: usize) -> Blocks {
        Blocks::one_by_one(self.members, threads)
    }

    fn go(&self, members: Range<usize>) -> Vec<Outcome<X::State>> {
        members.map(|k| (self.member)(k).record(self.span, false)).collect()
    }
}

/// Where members of any kind are kept: nowhere, or in a store (feature `store`).
#[diagnostic::on_unimplemented(
    message = "these simulations cannot be kept in a store",
    note = "states of laws and of scenes are kept: of laws those whose numbers are `f64`, `f32`, `DoubleDouble`, or others that are `Exact`"
)]
pub trait Keeps<L, X: Setup<L>, S, O> {
    /// The place, open.
    #[doc(hidden)]
    fn open<'a>(&self, plan: &'a OneByOne<'a, L, X, S, O>) -> Opened<'a, X::State>;
}

impl<L, X: Setup<L>, S, O> Keeps<L, X, S, O> for Nowhere {
    fn open<'a>(&self, _: &'a OneByOne<'a, L, X, S, O>) -> Opened<'a, X::State> {
        Ok(Box::new(Nowhere))
    }
}
