//! Many motions of one law.

mod export;
mod lanes;
mod rides;
mod run;
mod share;
#[cfg(feature = "progress")]
mod shown;
mod steps;
#[cfg(feature = "store")]
mod store;

use core::num::NonZero;
use core::ops::Range;
#[cfg(feature = "store")]
use std::path::PathBuf;
use std::thread::available_parallelism;
use std::time::Instant;

pub use export::End;
pub use lanes::{Ride, Together};
pub use rides::{Block, Outcome, Rides};
pub use run::{Checksum, EnsembleRun};
pub use steps::InLanes;

use crate::error::Error;
use crate::law::Fields;
use crate::run::{Attend, Follow, Shown, Simulation};
use crate::scheme::{Adaptable, Adaptive, NoScheme, Scheme};
use crate::setup::Setup;
use crate::span::Span;
use crate::state::State;

/// Many motions: of one law, with parameters and a start for each. Sweeps of parameters, Monte Carlo, maps of chaos.
///
/// Members ride side by side in the lanes of a few registers, and a lane whose member has ended takes the next; blocks of
/// members go over the cores. Every member is, to the bit, what it is alone, whatever the number of lanes and threads. One that fails
/// is told, and costs the others nothing.
///
/// All schemes ride in lanes, with equal and with adaptive steps, but those of stages, [`Gauss`](crate::Gauss) and
/// [`LineIntegral`](crate::LineIntegral), which fill the lanes with one motion, and [`Relaxed`](crate::Relaxed): these move each member
/// alone. The law is one that `#[dmech::law]` has written, which can be taken apart into its numbers. [`Ensemble::each`] takes
/// simulations of any kind, each moved alone:
///
/// ```
/// use dmech_core::prelude::*;
/// # #[derive(Clone, Copy)]
/// # struct Quartic { k: f64 }
/// # impl Conservative for Quartic {}
/// # impl Potential<1> for Quartic {
/// #     fn potential(&self, [x]: [f64; 1]) -> f64 { 0.25 * self.k * x.powi(4) }
/// #     fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] { [self.k * x.powi(3)] }
/// #     fn hessian(&self, [x]: [f64; 1]) -> [[f64; 1]; 1] { [[3.0 * self.k * x * x]] }
/// #     fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] { [0.25 * self.k * (a + b) * (a * a + b * b)] }
/// #     fn discrete_gradient_jacobian(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
/// #         [[0.25 * self.k * (a * a + 2.0 * a * b + 3.0 * b * b)]]
/// #     }
/// # }
/// let run = Ensemble::each(100, |k| {
///     let law = Quartic { k: 1.0 + 0.01 * k as f64 };
///     Simulation::new(law, State::new([1.0], [0.3])).scheme(DiscreteGradient).dt(0.01).record_every(100)
/// });
/// let run = run.run_until(5.0)?;
/// assert!((0..100).all(|k| run.drift(k, Invariant::Energy).unwrap().max_relative() < 1e-13));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
#[must_use = "an ensemble does nothing until it is run"]
pub struct Ensemble<L = NoLaw, X = NoStart, S = NoScheme, M = fn(usize) -> f64> {
    law: L,
    start: X,
    mass: M,
    /// What all have in common.
    common: Simulation<(), (), S>,
    members: usize,
    hands: Hands,
    beside: Beside,
}

/// What there is beside the motions.
#[derive(Clone, Debug, Default)]
struct Beside {
    shown: Shown,
    /// Where the members are kept.
    #[cfg(feature = "store")]
    path: Option<PathBuf>,
}

/// In the type of an ensemble that was given no law: call `.law(|k| …)`.
#[derive(Clone, Copy, Debug)]
pub struct NoLaw;

/// In the type of an ensemble that was given no start: call `.start(|k| …)`.
#[derive(Clone, Copy, Debug)]
pub struct NoStart;

/// Who does the work.
#[derive(Clone, Copy, Debug)]
struct Hands {
    threads: Option<usize>,
    lanes: usize,
}

impl Hands {
    const ALL: Hands = Hands { threads: None, lanes: Ride::COUNT };

    /// Moves blocks of members, and takes what comes of them in order.
    fn share<T: Send>(self, members: usize, work: impl Fn(Range<usize>) -> T + Sync, take: impl FnMut(T)) {
        let cores = || available_parallelism().map_or(1, NonZero::get);
        let threads = self.threads.unwrap_or_else(cores).max(1);
        // A few for each thread, so that none waits long for the last.
        let size = (members / (8 * threads)).next_multiple_of(Ride::COUNT).clamp(Ride::COUNT, BLOCK);
        let block = |i: usize| work(i * size..members.min((i + 1) * size));
        share::in_order(members.div_ceil(size), threads, block, take);
    }
}

/// The most members in a block.
const BLOCK: usize = 512;

impl Ensemble {
    /// So many members, of a law and a start for each.
    pub fn of(members: usize) -> Self {
        let common = Simulation::of((), ());
        Ensemble {
            law: NoLaw,
            start: NoStart,
            mass: |_| 1.0,
            common,
            members,
            hands: Hands::ALL,
            beside: Beside::default(),
        }
    }

    /// So many simulations of any kind, each moved alone, over all cores: scenes, events, observers. What they record is kept.
    pub fn each<F>(members: usize, member: F) -> Each<F> {
        Each { member, members, hands: Hands::ALL, shown: Shown::default() }
    }
}

impl<L, X, S, M> Ensemble<L, X, S, M> {
    /// The law of each member, by its number.
    pub fn law<F, Y>(self, law: F) -> Ensemble<F, X, S, M>
    where
        F: Fn(usize) -> Y + Sync,
    {
        let Ensemble { start, mass, common, members, hands, beside, .. } = self;
        Ensemble { law, start, mass, common, members, hands, beside }
    }

    /// The start of each member, by its number.
    pub fn start<F, const D: usize>(self, start: F) -> Ensemble<L, F, S, M>
    where
        F: Fn(usize) -> State<D> + Sync,
    {
        let Ensemble { law, mass, common, members, hands, beside, .. } = self;
        Ensemble { law, start, mass, common, members, hands, beside }
    }

    /// The mass of each member, by its number (default 1).
    pub fn mass<F>(self, mass: F) -> Ensemble<L, X, S, F>
    where
        F: Fn(usize) -> f64 + Sync,
    {
        let Ensemble { law, start, common, members, hands, beside, .. } = self;
        Ensemble { law, start, mass, common, members, hands, beside }
    }

    fn common<T>(self, set: impl FnOnce(Simulation<(), (), S>) -> Simulation<(), (), T>) -> Ensemble<L, X, T, M> {
        let Ensemble { law, start, mass, common, members, hands, beside } = self;
        Ensemble { law, start, mass, common: set(common), members, hands, beside }
    }

    /// The scheme of all.
    pub fn scheme<T>(self, scheme: T) -> Ensemble<L, X, T, M> {
        self.common(|common| common.scheme(scheme))
    }

    /// The time step of all; with [`adaptive`](Ensemble::adaptive) the longest.
    pub fn dt(self, dt: f64) -> Self {
        self.common(|common| common.dt(dt))
    }

    /// Steps that follow the motion of each member: [`Simulation::adaptive`].
    pub fn adaptive(self, tolerance: f64) -> Ensemble<L, X, Adaptive<S>, M>
    where
        S: Adaptable,
    {
        self.common(|common| common.adaptive(tolerance))
    }

    /// Looks at the invariants after every n-th step (default 1, as a run does that records every state). No state is kept but the
    /// last: a look costs about as much as a step, so that every tenth or hundredth is often enough.
    pub fn look_every(self, n: u64) -> Self {
        self.common(|common| common.record_every(n))
    }

    /// Keeps the states at these times of every member: [`Simulation::record_at`]. The invariants are looked at there.
    pub fn record_at(self, times: impl IntoIterator<Item = f64>) -> Self {
        self.common(|common| common.record_at(times))
    }

    /// Keeps the states at the times t₀ + k dt of every member: [`Simulation::record_dt`].
    pub fn record_dt(self, dt: f64) -> Self {
        self.common(|common| common.record_dt(dt))
    }

    /// On so many threads; on all cores if nothing is said. The results are the same.
    pub fn threads(self, threads: usize) -> Self {
        Ensemble { hands: Hands { threads: Some(threads), ..self.hands }, ..self }
    }

    /// With so many members side by side at most; if nothing is said 8, with AVX2 16, with AVX-512 32. The results are the same.
    pub fn lanes(self, lanes: usize) -> Self {
        Ensemble { hands: Hands { lanes: lanes.clamp(1, Ride::COUNT), ..self.hands }, ..self }
    }

    /// Makes a number of steps with each member.
    ///
    /// # Errors
    /// [`Error`] for what is refused for all: a step or a tolerance. What fails of a member is in its [result](EnsembleRun::last).
    pub fn run<Y, const D: usize>(self, steps: u64) -> Result<EnsembleRun<State<D>>, Error>
    where
        L: Fn(usize) -> Y + Sync,
        X: Fn(usize) -> State<D> + Sync,
        M: Fn(usize) -> f64 + Sync,
        Y: Fields<D>,
        S: Rides<Y, D> + Sync,
    {
        self.collect(Span::Steps(steps))
    }

    /// Moves each member until a time: [`Simulation::run_until`].
    ///
    /// # Errors
    /// As [`run`](Ensemble::run).
    pub fn run_until<Y, const D: usize>(self, end: f64) -> Result<EnsembleRun<State<D>>, Error>
    where
        L: Fn(usize) -> Y + Sync,
        X: Fn(usize) -> State<D> + Sync,
        M: Fn(usize) -> f64 + Sync,
        Y: Fields<D>,
        S: Rides<Y, D> + Sync,
    {
        self.collect(Span::Until(end))
    }

    /// Moves each member until a time, and hands each to a function in their order, with its number: means, extrema, histograms, and
    /// files. Nothing is kept, so that there is room for any number.
    ///
    /// # Errors
    /// As [`run`](Ensemble::run).
    pub fn for_each_until<Y, const D: usize>(
        self,
        end: f64,
        see: impl FnMut(usize, Outcome<State<D>>),
    ) -> Result<(), Error>
    where
        L: Fn(usize) -> Y + Sync,
        X: Fn(usize) -> State<D> + Sync,
        M: Fn(usize) -> f64 + Sync,
        Y: Fields<D>,
        S: Rides<Y, D> + Sync,
    {
        self.go(Span::Until(end), see)
    }

    fn collect<Y, const D: usize>(self, span: Span) -> Result<EnsembleRun<State<D>>, Error>
    where
        L: Fn(usize) -> Y + Sync,
        X: Fn(usize) -> State<D> + Sync,
        M: Fn(usize) -> f64 + Sync,
        Y: Fields<D>,
        S: Rides<Y, D> + Sync,
    {
        let (clock, mut members) = (Instant::now(), Vec::with_capacity(self.members));
        self.go(span, |_, member| members.push(member))?;
        Ok(EnsembleRun::new(members, clock.elapsed()))
    }

    fn go<Y, const D: usize>(self, span: Span, mut see: impl FnMut(usize, Outcome<State<D>>)) -> Result<(), Error>
    where
        L: Fn(usize) -> Y + Sync,
        X: Fn(usize) -> State<D> + Sync,
        M: Fn(usize) -> f64 + Sync,
        Y: Fields<D>,
        S: Rides<Y, D> + Sync,
    {
        let Ensemble { law, start, mass, common, members, hands, beside } = self;
        common.step_length::<f64>()?;
        let member = |k: usize| common.clone().moving(law(k), start(k)).mass(mass(k));
        let mut follow = Follow::new(beside.shown, members as u64);
        #[cfg(feature = "store")]
        if let Some(path) = &beside.path {
            let plan = store::Plan { members, member: &member, common: &common, span };
            let (mut done, mut see) = (0, see);
            let outcome = store::go(path, &plan, hands, &mut follow, |k, outcome| {
                done = k as u64 + 1;
                see(k, outcome);
            });
            follow.end(done, outcome.is_ok());
            return outcome;
        }
        let block = |members| S::ride(&Block { members, member: &member, span, lanes: hands.lanes });
        let mut k = 0;
        hands.share(members, block, |outcomes| {
            for outcome in outcomes {
                see(k, outcome);
                k += 1;
            }
            follow.look(k as u64);
        });
        follow.end(members as u64, true);
        Ok(())
    }
}

/// Simulations of any kind, made by [`Ensemble::each`].
#[derive(Clone, Debug)]
#[must_use = "an ensemble does nothing until it is run"]
pub struct Each<F> {
    member: F,
    members: usize,
    hands: Hands,
    shown: Shown,
}

impl<F> Each<F> {
    /// On so many threads; on all cores if nothing is said. The results are the same.
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
        Ok(self.collect(Span::Steps(steps)))
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
        Ok(self.collect(Span::Until(end)))
    }

    fn collect<L, X, S, O>(self, span: Span) -> EnsembleRun<X::State>
    where
        F: Fn(usize) -> Simulation<L, X, S, O> + Sync,
        X: Setup<L, State: Send>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
    {
        let Each { member, members, hands, shown } = self;
        let (clock, mut all) = (Instant::now(), Vec::with_capacity(members));
        let mut follow = Follow::new(shown, members as u64);
        let block = |members: Range<usize>| members.map(|k| member(k).record(span)).collect::<Vec<_>>();
        hands.share(members, block, |outcomes| {
            all.extend(outcomes);
            follow.look(all.len() as u64);
        });
        follow.end(members as u64, true);
        EnsembleRun::new(all, clock.elapsed())
    }
}
