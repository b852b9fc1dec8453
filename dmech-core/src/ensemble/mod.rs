//! Many motions of one law.

mod block;
mod company;
mod convoy;
mod counts;
mod deviations;
mod each;
mod export;
mod in_order;
mod lanes;
mod member;
mod members;
mod plan;
#[cfg(feature = "ranks")]
mod ranks;
mod rides;
mod rows;
mod run;
mod share;
#[cfg(feature = "progress")]
mod shown;
mod steps;
#[cfg(feature = "store")]
mod store;
mod sweep;
mod together;
#[cfg(any(feature = "ranks", feature = "store"))]
mod told;

#[cfg(feature = "store")]
use std::path::PathBuf;
use std::sync::Arc;

pub use block::{Block, Outcome};
pub use company::{Companies, Company, Joined, NoCompany, With};
pub use each::{EachAlone, Keeps};
pub use export::End;
pub use members::{LawOf, Members, Starts};
pub use plan::Nowhere;
#[cfg(feature = "ranks")]
pub use ranks::{Ranked, Ranks, Travels};
pub use rides::Rides;
pub use rows::LANES;
pub use run::{Checksum, EnsembleRun};
pub use steps::InLanes;
#[cfg(feature = "store")]
pub use store::InFile;
pub use together::Together;

use in_order::Hands;

use crate::law::{MassIndependent, Masses};
use crate::run::{Shown, Simulation};
#[cfg(feature = "scene")]
use crate::scene::{AmongFew, FewBodies, Sides};
use crate::scheme::{Adaptable, Adaptive, NoScheme};
use crate::state::State;

/// Many motions: of one law, with parameters and a start for each. Sweeps of parameters, Monte Carlo, maps of chaos.
///
/// Members ride side by side in the lanes of a few registers, and a lane whose member has ended takes the next; blocks of
/// members go over the cores. Every member is, to the bit, what it is alone, whatever the number of lanes and threads. One that fails
/// is told, and costs the others nothing.
///
/// All schemes ride in lanes, with equal and with adaptive steps, but [`Relaxed`](crate::Relaxed), which moves each member alone. The
/// law is one that `#[dmech::law]` has written, which can be taken apart into its numbers, or an `Option` of such a law, where some members
/// move freely; a scene of few bodies is one too (`Ensemble::scene`). [`Ensemble::each`] takes simulations of any kind, each moved alone:
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/quartic.md")]
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
pub struct Ensemble<L = NoLaw, X = NoStart, S = NoScheme, M = fn(usize) -> f64, C = NoCompany> {
    law: L,
    start: X,
    mass: M,
    company: C,
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
    /// The work of their steps is summed.
    work: bool,
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

impl Ensemble {
    /// So many members, of a law and a start for each.
    pub fn of(members: usize) -> Self {
        let common = Simulation::of((), ());
        Ensemble {
            law: NoLaw,
            start: NoStart,
            mass: |_| 1.0,
            company: NoCompany,
            common,
            members,
            hands: Hands::ALL,
            beside: Beside::default(),
        }
    }

    /// Members by their laws and starts, in their order: as a list or an iterator has them.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    /// # fn map<L: dmech_core::extend::Fields<2> + Clone + Send + Sync>(orbit: impl Fn(f64) -> L) -> Result<(), Error>
    /// # where Leapfrog: dmech_core::extend::Rides<L, 2> {
    /// let masses = [0.3, 1.0, 4.5];
    /// let members = masses.map(|gm| (orbit(gm), State::new([1.0, 0.0], [0.0, gm.sqrt()])));
    /// let run = Ensemble::over(members).scheme(Leapfrog).dt(1e-3).run_until(10.0)?;
    /// assert_eq!(run.len(), 3);
    /// # Ok(())
    /// # }
    /// ```
    pub fn over<Y, const D: usize>(
        members: impl IntoIterator<Item = (Y, State<D>)>,
    ) -> Ensemble<impl Fn(usize) -> Y + Clone + Sync, impl Fn(usize) -> State<D> + Clone + Sync>
    where
        Y: Clone + Send + Sync,
    {
        let laws: Arc<[(Y, State<D>)]> = members.into_iter().collect();
        let starts = Arc::clone(&laws);
        Ensemble::of(laws.len()).law(move |k| laws[k].0.clone()).start(move |k| starts[k].1)
    }

    /// So many simulations of any kind, each moved alone, over all cores: scenes among them. What they record is kept.
    pub fn each<F>(members: usize, member: F) -> EachAlone<F> {
        EachAlone { member, members, hands: Hands::ALL, shown: Shown::default(), keep: Nowhere }
    }
}

impl<L, X, S, M> Ensemble<L, X, S, M> {
    /// Has each member accompanied, by its number: by events, also such as end it, by quantities whose drift is examined, by
    /// observers, by a stream of its own. To the bit what a [`Simulation`] alone would see.
    ///
    /// Members ride in lanes as before; for events and observers each is examined after every step, which takes some nanoseconds.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    /// # fn map<L: dmech_core::extend::Fields<2>>(law: impl Fn(usize) -> L + Sync) -> Result<(), Error>
    /// # where Leapfrog: dmech_core::extend::Rides<L, 2> {
    /// // Where does each cross the plane x = 0, and which of them escape?
    /// let run = Ensemble::of(1000)
    ///     .law(law)
    ///     .start(|k| State::new([0.5, 0.0], [0.0, 1.6 + 1e-3 * k as f64]))
    ///     .scheme(Leapfrog)
    ///     .dt(1e-3)
    ///     .with(|_, member| {
    ///         member
    ///             .event(|state| state.q[0], Crossing::Rising)
    ///             .stop_when(|state| state.q[0].hypot(state.q[1]) - 10.0, Crossing::Rising)
    ///     })
    ///     .run_until(100.0)?;
    /// let escaped = run.members().flatten().filter(|run| run.stopped()).count();
    /// println!("{escaped} have escaped");
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// It is said once, with everything in it, and after [`start`](Ensemble::start).
    ///
    /// Functions see the states of their own member only, in the order of time; which members come first is not said. What they have in
    /// common, a sum or a histogram, is behind a lock or atomic; what [`Run`](crate::Run) has comes in the order of members. On several
    /// ranks each sees those that it moves.
    pub fn with<O, F, const D: usize>(self, company: F) -> Ensemble<L, X, S, M, With<F>>
    where
        X: Starts<D>,
        F: Fn(usize, Company<State<D>>) -> Company<State<D>, O> + Sync,
    {
        let Ensemble { law, start, mass, common, members, hands, beside, .. } = self;
        Ensemble { law, start, mass, company: With(company), common, members, hands, beside }
    }
}

impl<L, X, S, M, C> Ensemble<L, X, S, M, C> {
    /// The law of each member, by its number.
    pub fn law<F, Y>(self, law: F) -> Ensemble<F, X, S, M, C>
    where
        F: Fn(usize) -> Y + Sync,
    {
        let Ensemble { start, mass, company, common, members, hands, beside, .. } = self;
        Ensemble { law, start, mass, company, common, members, hands, beside }
    }

    /// The start of each member, by its number.
    pub fn start<F, const D: usize>(self, start: F) -> Ensemble<L, F, S, M, C>
    where
        F: Fn(usize) -> State<D> + Sync,
    {
        let Ensemble { law, mass, company, common, members, hands, beside, .. } = self;
        Ensemble { law, start, mass, company, common, members, hands, beside }
    }

    /// The bodies of each member, by its number, as law and start: small scenes whose number of bodies is known, side by side in lanes.
    ///
    /// ```
    /// # use dmech_core::prelude::*;
    /// # use dmech_core::scene::{AmongFew, Scene, Term};
    /// # fn map<L: Term<2, ()>>(planets: impl Fn(usize) -> Scene<2, (), L> + Clone + Sync) -> Result<(), Error>
    /// # where L::Ready: AmongFew<2, 3> + dmech_core::scheme::WithoutVelocities {
    /// // Scenes of three bodies in the plane, six coordinates.
    /// let run = Ensemble::of(1000)
    ///     .scene(|k| planets(k).as_law::<3, 6>())
    ///     .scheme(Nystrom::order6())
    ///     .dt(0.01)
    ///     .run_until(100.0)?;
    /// let place = run.last(7).map(|state| state.bodies::<2>().q[1]);
    /// # Ok(())
    /// # }
    /// ```
    #[cfg(feature = "scene")]
    pub fn scene<F, A, const D: usize, const N: usize, const K: usize, Y: Sides>(
        self,
        scene: F,
    ) -> Ensemble<F, impl Fn(usize) -> State<K> + Clone + Sync, S, M, C>
    where
        F: Fn(usize) -> FewBodies<A, D, N, K, Y> + Clone + Sync,
        A: AmongFew<D, N, Y>,
    {
        let start = scene.clone();
        self.law(scene).start(move |k| start(k).start())
    }

    /// The mass of each member, by its number (default 1).
    pub fn mass<F>(self, mass: F) -> Ensemble<L, X, S, F, C>
    where
        F: Fn(usize) -> f64 + Sync,
    {
        let Ensemble { law, start, company, common, members, hands, beside, .. } = self;
        Ensemble { law, start, mass, company, common, members, hands, beside }
    }

    /// A mass for each coordinate of each member, by its number, in units of [`mass`](Ensemble::mass): [`Simulation::masses`]. It comes
    /// after [`law`](Ensemble::law), and belongs to it: a law that is given later has none of them.
    ///
    /// A law of several bodies is a small scene whose members ride in lanes.
    pub fn masses<F, Y, const D: usize>(
        self,
        masses: F,
    ) -> Ensemble<impl Fn(usize) -> Masses<Y, D> + Clone + Sync, X, S, M, C>
    where
        L: Fn(usize) -> Y + Clone + Sync,
        Y: MassIndependent,
        F: Fn(usize) -> [f64; D] + Clone + Sync,
    {
        let Ensemble { law, start, mass, company, common, members, hands, beside } = self;
        let law = move |k| Masses::new(law(k), masses(k));
        Ensemble { law, start, mass, company, common, members, hands, beside }
    }

    fn set<T>(self, set: impl FnOnce(Simulation<(), (), S>) -> Simulation<(), (), T>) -> Ensemble<L, X, T, M, C> {
        let Ensemble { law, start, mass, company, common, members, hands, beside } = self;
        Ensemble { law, start, mass, company, common: set(common), members, hands, beside }
    }

    /// The scheme of all.
    pub fn scheme<T>(self, scheme: T) -> Ensemble<L, X, T, M, C> {
        self.set(|common| common.scheme(scheme))
    }

    /// The time step of all; with [`adaptive`](Ensemble::adaptive) the longest.
    pub fn dt(self, dt: f64) -> Self {
        self.set(|common| common.dt(dt))
    }

    /// Steps that follow the motion of each member: [`Simulation::adaptive`].
    pub fn adaptive(self, tolerance: f64) -> Ensemble<L, X, Adaptive<S>, M, C>
    where
        S: Adaptable,
    {
        self.set(|common| common.adaptive(tolerance))
    }

    /// Looks at the invariants after every n-th step (default 1, as a run does that records every state). No state is kept but the
    /// last: a look costs about as much as a step, so that every tenth or hundredth is often enough.
    pub fn look_every(self, n: u64) -> Self {
        self.set(|common| common.record_every(n))
    }

    /// Sums the work of every step, so that [`Invariant::WorkEnergy`](crate::Invariant::WorkEnergy) of each member is watched too, to the
    /// bit as a [`Simulation`] alone watches it.
    ///
    /// The other invariants are seen in a state; work is done in every step, and costs nothing where nobody asks for it. With AVX2 a
    /// member's step of leap-frog on a planet takes 3.8 ns in place of 1.4 then, one of `DiscreteGradient` 14 in place of 11, one of
    /// `Nystrom::order6()` a sixth more.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    /// # fn map<L: dmech_core::extend::Fields<2>>(law: impl Fn(usize) -> L + Sync) -> Result<(), Error>
    /// # where Implicit: dmech_core::extend::Rides<L, 2> {
    /// let members = Ensemble::of(1000).law(law).start(|_| State::new([0.5, 0.0], [0.0, 1.6])).scheme(Implicit).dt(1e-2);
    /// let run = members.look_every(10).watch_work().run_until(10.0)?;
    /// assert!(run.drift(7, Invariant::WorkEnergy).unwrap().max_relative() < 1e-13);
    /// # Ok(())
    /// # }
    /// ```
    pub fn watch_work(self) -> Self {
        Ensemble { beside: Beside { work: true, ..self.beside }, ..self }
    }

    /// Keeps the states at these times of every member: [`Simulation::record_at`]. The invariants are examined after the steps in
    /// which they lie; times that a member does not reach are not recorded.
    pub fn record_at(self, times: impl IntoIterator<Item = f64>) -> Self {
        self.set(|common| common.record_at(times))
    }

    /// Keeps the states at the times t₀ + k dt of every member: [`Simulation::record_dt`].
    pub fn record_dt(self, dt: f64) -> Self {
        self.set(|common| common.record_dt(dt))
    }

    /// On so many threads, 1024 at most; on all cores if nothing is said. The results are the same.
    pub fn threads(self, threads: usize) -> Self {
        Ensemble { hands: Hands { threads: Some(threads), ..self.hands }, ..self }
    }

    /// At most so many members side by side. By default 8, and for laws of at most five coordinates 16 with AVX2 and 32 with AVX-512,
    /// except under `Gauss` and `LineIntegral`. The results are the same.
    pub fn lanes(self, lanes: usize) -> Self {
        Ensemble { hands: Hands { lanes: lanes.clamp(1, LANES), ..self.hands }, ..self }
    }
}
