//! Setting up a scene.

use super::bodies::Bodies;
use super::drives::Drives;
use super::space::{Open, Periodic};
use super::state::SceneState;
use super::terms::{Bonds, Chain, Each, Linked, Near, One, Own, Pairs};
use super::{OnEach, OnEachOwn, OnNear};
use crate::law::Law;
use crate::law::{CutOff, LinkLaw, Symmetric};

/// Bodies in D dimensions that carry data `P`, and the laws `L` that act on them.
///
/// ```
/// # use dmech_core::prelude::*;
/// # use dmech_core::Scene;
/// let scene: Scene<2> = Scene::new()
///     .body(1.0, [0.0, 0.0], [0.0, 0.0])
///     .body(3.0, [1.0, 0.0], [0.0, 0.5]);
/// assert_eq!(scene.bodies(), 2);
/// ```
///
/// Laws are added by where they act: [`field`](Scene::field) on each body, [`field_of`](Scene::field_of) on each its own, [`pairs`](Scene::pairs) between any two,
/// [`chain`](Scene::chain) between neighbours, [`bonds`](Scene::bonds) between those of a list. Any number of them act
/// together; they are composed in the type, and each is compiled for itself, once for all numbers of bodies.
#[derive(Clone, Debug)]
#[must_use = "a scene does nothing until it is simulated"]
pub struct Scene<const D: usize, P = (), L = (), B = Open> {
    pub(super) bodies: Bodies<D, P>,
    pub(super) laws: L,
    pub(super) space: B,
}

/// A [`Law`] in D dimensions, which acts on each body by itself.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not act on each body of this scene by itself",
    label = "the bodies move in {D} dimensions",
    note = "a law of one body is a `#[potential]` or a `#[force]` of the position `q: [f64; {D}]`",
    note = "a law between two bodies acts along links: `.pairs(law)`, `.chain(law)`, `.bonds(law, list)`"
)]
pub trait FieldLaw<const D: usize>: Law<D> {}

#[diagnostic::do_not_recommend]
impl<const D: usize, X: Law<D>> FieldLaw<D> for X {}

impl<const D: usize, P> Scene<D, P> {
    /// An empty scene at t = 0.
    pub fn new() -> Self {
        let bodies = Bodies {
            masses: Vec::new(),
            q: Vec::new(),
            v: Vec::new(),
            data: Vec::new(),
            pins: Vec::new(),
            drives: Drives::none(),
            tests: Vec::new(),
            t: 0.0,
        };
        Scene { bodies, laws: (), space: Open }
    }
}

impl<const D: usize, P> Default for Scene<D, P> {
    fn default() -> Self {
        Scene::new()
    }
}

impl<const D: usize, L, B> Scene<D, (), L, B> {
    /// Adds a body of mass `mass` at `q` with velocity `v`.
    pub fn body(self, mass: f64, q: [f64; D], v: [f64; D]) -> Self {
        self.body_with(mass, q, v, ())
    }

    /// Adds a test body: it feels every law, with the mass `mass`, and does not act on the others.
    ///
    /// Its motion is that of a body of vanishing mass where forces are in proportion to it, as in gravity, whatever
    /// the mass. Energy, momenta and work of a scene are those of the bodies that act: these are a closed system, and what
    /// is an invariant stays one. Two test bodies do not know of each other, so that n of them take O(n).
    ///
    /// ```
    /// # use dmech_core::prelude::*;
    /// # use dmech_core::Scene;
    /// let scene = Scene::<2>::new()
    ///     .body(1.0, [0.0, 0.0], [0.0, 0.0])
    ///     .test_body(1.0, [1.0, 0.0], [0.0, 1.0]);
    /// assert_eq!(scene.bodies(), 2);
    /// ```
    pub fn test_body(self, mass: f64, q: [f64; D], v: [f64; D]) -> Self {
        self.test_body_with(mass, q, v, ())
    }
}

impl<const D: usize, P, L, B> Scene<D, P, L, B> {
    /// Adds a body that carries data for the laws, such as a charge.
    pub fn body_with(mut self, mass: f64, q: [f64; D], v: [f64; D], data: P) -> Self {
        self.bodies.masses.push(mass);
        self.bodies.q.push(q);
        self.bodies.v.push(v);
        self.bodies.data.push(data);
        self
    }

    /// Adds a [test body](Scene::test_body) that carries data for the laws.
    pub fn test_body_with(mut self, mass: f64, q: [f64; D], v: [f64; D], data: P) -> Self {
        self.bodies.tests.push(self.bodies.masses.len());
        self.body_with(mass, q, v, data)
    }

    /// Fixes body i, counted from 0 in the order of addition: it acts on the others and does not move.
    pub fn pin(mut self, i: usize) -> Self {
        self.bodies.pins.push(i);
        self
    }

    /// Moves body i along a given path, t ↦ (q, v) with v = dq/dt: a pin that is carried along. It acts on the others from
    /// where it is, and no force moves it; where the scene has put it does not count.
    ///
    /// What acts on the others depends on the time then, which every scheme takes as it takes a law that names the time, with
    /// its order; the energy is no invariant. v is what laws of the velocity feel. A path that bends, as one that stops, is
    /// best made to bend between two steps; it must be finite at all times, or the run ends with
    /// [`Error::Path`](crate::Error::Path). That v is the velocity of q is not checked. A path that depends on the motion, as of a hand in
    /// a game, is [`set_body`](crate::Stepper::set_body) between steps.
    ///
    /// ```
    /// # use dmech_core::prelude::*;
    /// # use dmech_core::Scene;
    /// // Hung up at 0.1 sin 3t.
    /// let scene = Scene::new()
    ///     .body(1.0, [0.0], [0.0])
    ///     .body(1.0, [-1.0], [0.0])
    ///     .drive(0, |t: f64| ([0.1 * (3.0 * t).sin()], [0.3 * (3.0 * t).cos()]));
    /// # let _ = scene;
    /// ```
    ///
    /// # Errors
    /// When the scene is set up: [`SceneError::DrivenTwice`](crate::SceneError::DrivenTwice) for two paths of a body.
    pub fn drive(mut self, i: usize, path: impl Fn(f64) -> ([f64; D], [f64; D]) + Send + Sync + 'static) -> Self {
        self.bodies.drives.push(i, path);
        self.pin(i)
    }

    /// The time of the start (default 0).
    pub fn at_time(mut self, t: f64) -> Self {
        self.bodies.t = t;
        self
    }

    /// The same bodies where a state has them, as at the end of another run.
    pub fn starting_from(mut self, state: &SceneState<D>) -> Self {
        let Bodies { q, v, t, .. } = &mut self.bodies;
        (*q, *v, *t) = (state.q.clone(), state.v.clone(), state.t);
        self
    }

    /// A box of the lengths l that repeats itself on all sides: bodies are separated by the nearest image of q_a − q_b.
    ///
    /// Only separations of pairs, chains and bonds are taken so. Positions are not wrapped: they go on and on, so that
    /// velocities, paths and diffusion are read off them as in open space; a body l away is the same body. A law on
    /// [each body](Scene::field) sees the position as it is.
    ///
    /// Energy and linear momentum are kept as without a box; the angular momentum is not, a box has corners. Without a
    /// [cut-off](Scene::cutoff) the force between two bodies jumps where the nearest image becomes another one.
    ///
    /// ```
    /// # use dmech_core::prelude::*;
    /// # use dmech_core::Scene;
    /// let scene = Scene::<3>::new().body(1.0, [0.1; 3], [0.0; 3]).body(1.0, [9.9; 3], [0.0; 3]).periodic([10.0; 3]);
    /// # let _ = scene;
    /// ```
    ///
    /// # Errors
    /// When run: [`SceneError::Length`](crate::SceneError::Length).
    pub fn periodic(self, lengths: [f64; D]) -> Scene<D, P, L, Periodic<D>> {
        Scene { bodies: self.bodies, laws: self.laws, space: Periodic::new(lengths) }
    }

    /// A law that acts on each body by itself, one for all: [`field_of`](Scene::field_of) gives each its own. Its `#[invariant]`s are those
    /// of one body, and a scene does not watch them: what is to be followed of all bodies is a [`watch`](crate::Simulation::watch).
    pub fn field<X: FieldLaw<D>>(self, law: X) -> Scene<D, P, (L, OnEach<X>), B> {
        self.with(Each { laws: One(law) })
    }

    /// A law of its own on each body, by the number of the body, counted from 0, and the data that it carries: charges in a magnetic
    /// field, drags, tethers.
    ///
    /// ```text
    /// Φ = Σ φ_i(q_i),   m_i q_i″ = −∂φ_i/∂q_i + F_i
    /// ```
    ///
    /// All are of one type, of which a law may name the mass `m`. The function is called for every body when the scene is set up, pins, driven
    /// and test bodies too, and not again. A body on which nothing is to act has `None` of laws that are `Option`s. On the way the law of a
    /// body is changed by [`law_of_mut`](crate::Stepper::law_of_mut).
    ///
    /// ```
    /// # use dmech_core::prelude::*;
    /// # use dmech_core::Scene;
    /// # #[derive(Clone, Copy)]
    /// # struct Tether { k: f64, to: f64 }
    /// # impl Conservative for Tether {}
    /// # impl Potential<1> for Tether {
    /// #     fn potential(&self, [x]: [f64; 1]) -> f64 { 0.5 * self.k * (x - self.to).powi(2) }
    /// #     fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] { [self.k * (x - self.to)] }
    /// #     fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] { [[self.k]] }
    /// #     fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] { [self.k * (0.5 * (a + b) - self.to)] }
    /// #     fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] { [[0.5 * self.k]] }
    /// # }
    /// // k (x − i)²/2, with the stiffness k that each body carries.
    /// let scene = Scene::new()
    ///     .body_with(1.0, [0.1], [0.0], 4.0)
    ///     .body_with(1.0, [0.9], [0.0], 9.0)
    ///     .field_of(|i, &k| Tether { k, to: i as f64 });
    /// let run = Simulation::scene(scene).scheme(Nystrom::order6()).dt(0.01).run_until(1.0)?;
    /// assert!((run.last().q[0][0] - 0.1 * 2.0_f64.cos()).abs() < 1e-12);
    /// assert!((run.last().q[1][0] - 1.0 + 0.1 * 3.0_f64.cos()).abs() < 1e-12);
    /// # Ok::<(), Interrupted<SceneState<1>>>(())
    /// ```
    ///
    /// # Errors
    /// When run: [`Error::Body`](crate::Error::Body) names the first body whose law is not finite where it is, and
    /// [`Error::NotAsWritten`](crate::Error::NotAsWritten) the first whose law is not what its method computes: each is compared where its
    /// body is and at eight places around it, as their numbers differ.
    pub fn field_of<X: FieldLaw<D>>(
        self,
        law: impl Fn(usize, &P) -> X + Send + Sync + 'static,
    ) -> Scene<D, P, (L, OnEachOwn<X, P>), B> {
        self.with(Each { laws: Own::new(law) })
    }

    /// A law that acts between any two bodies.
    pub fn pairs<X: LinkLaw<D, P> + Symmetric>(self, law: X) -> Scene<D, P, (L, Linked<X, Pairs>), B> {
        self.with(Linked { law, links: Pairs::default() })
    }

    /// A law that acts between consecutive bodies: a is body j and b is body j + 1.
    pub fn chain<X: LinkLaw<D, P>>(self, law: X) -> Scene<D, P, (L, Linked<X, Chain>), B> {
        self.with(Linked { law, links: Chain })
    }

    /// A law that acts between the listed pairs of bodies, (a, b).
    pub fn bonds<X: LinkLaw<D, P>>(
        self,
        law: X,
        list: impl IntoIterator<Item = (usize, usize)>,
    ) -> Scene<D, P, (L, Linked<X, Bonds>), B> {
        self.with(Linked { law, links: Bonds::new(list) })
    }

    fn with<X>(self, term: X) -> Scene<D, P, (L, X), B> {
        Scene { bodies: self.bodies, laws: (self.laws, term), space: self.space }
    }

    /// The masses, in the order of the bodies.
    pub fn masses(&self) -> &[f64] {
        &self.bodies.masses
    }

    /// The number of bodies.
    pub fn bodies(&self) -> usize {
        self.bodies.masses.len()
    }
}

impl<const D: usize, P, L, X, B> Scene<D, P, (L, Linked<X, Pairs>), B> {
    /// Ends the law on pairs that was added last at the distance r: `.pairs(law).cutoff(r)`.
    ///
    /// A law that vanishes at r is taken as it is; any other is shifted by its value there, Φ(d) − Φ(r), so that the
    /// energy is an invariant. Where the force does not vanish too it jumps at r: `DiscreteGradient`, its compositions
    /// and `Relaxed` keep the energy all the same; with other schemes what each passing through r leaves in it adds up as a
    /// walk, also where it is said to be bounded. So it does in a box without a cut-off, where the nearest image changes.
    ///
    /// Bodies within reach are found by cells, and remembered in lists until one of them has moved: time and memory are
    /// O(N), for N bodies of bounded density. The sums are formed in the order of the bodies, whatever the lists: they do
    /// not depend on when those were made, nor on the number of threads.
    ///
    /// ```
    /// # use dmech_core::prelude::*;
    /// # use dmech_core::{Between, PairLaw, Reads, Scene, Symmetric};
    /// # #[derive(Clone, Copy)] struct Soft;
    /// # #[derive(Clone, Copy)] struct Square;
    /// # impl Symmetric for Soft {}
    /// # impl VelocityIndependent for Soft {}
    /// # impl<P> Reads<P> for Soft { type Numbers = [f64; 0]; fn numbers(_: f64, _: &P) -> [f64; 0] { [] } }
    /// # impl<P, R: dmech_core::Real> PairLaw<1, P, R> for Soft {
    /// #     type Between<'a> = Square;
    /// #     fn between(&self, _: [R; 0], _: [R; 0], _: R) -> Square { Square }
    /// # }
    /// # impl<R: dmech_core::Real> Between<1, R> for Square {}
    /// # impl<R: dmech_core::Real> Potential<1, R> for Square {
    /// #     const CENTRAL: bool = true;
    /// #     fn potential(&self, [x]: [R; 1]) -> R { -x * x }
    /// #     fn gradient(&self, [x]: [R; 1]) -> [R; 1] { [-x - x] }
    /// #     fn hessian(&self, _: [R; 1]) -> [[R; 1]; 1] { [[R::from_f64(-2.0)]] }
    /// #     fn discrete_gradient(&self, [a]: [R; 1], [b]: [R; 1]) -> [R; 1] { [-a - b] }
    /// #     fn discrete_gradient_jacobian(&self, _: [R; 1], _: [R; 1]) -> [[R; 1]; 1] { [[-R::ONE]] }
    /// # }
    /// // Φ(r) = −r² within a distance of 1, shifted to 0 there; two bodies that meet across the edge of the box.
    /// let scene = Scene::new().body(1.0, [0.2], [-0.3]).body(1.0, [8.0], [0.1]).pairs(Soft).cutoff(1.0).periodic([9.0]);
    /// let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.05).run(200)?;
    /// assert!(run.drift(Invariant::Energy).unwrap().max_abs() < 1e-14);
    /// # Ok::<(), Interrupted<SceneState<1>>>(())
    /// ```
    ///
    /// Implicit steps store the blocks of the Jacobian of those pairs and solve by iteration, O(N) too.
    ///
    /// # Errors
    /// When run: [`SceneError::Cutoff`](crate::SceneError::Cutoff);
    /// [`SceneError::CutoffInBox`](crate::SceneError::CutoffInBox) where r is longer than half a box;
    /// [`SceneError::CutoffNotCentral`](crate::SceneError::CutoffNotCentral) for a potential of the direction.
    pub fn cutoff(self, r: f64) -> Scene<D, P, (L, OnNear<X>), B> {
        let Scene { bodies, laws: (laws, Linked { law, .. }), space } = self;
        Scene { bodies, laws: (laws, Linked { law: CutOff::new(law, r), links: Near::new(r) }), space }
    }
}
