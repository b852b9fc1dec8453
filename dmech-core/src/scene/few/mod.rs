//! A scene whose number of bodies is known when it is compiled, as one law.

mod among;
mod between;
mod each;
mod links;
mod sides;
mod sums;
mod whole;

pub use among::{Among, AmongFew, Places};
pub use sides::{Mutual, Restricted, Sides};
pub use whole::Whole;

use core::array::from_fn;

use dmech_scalar::Real;

use super::builder::Scene;
use super::space::Space;
use super::state::SceneState;
use super::terms::Term;
use crate::error::{Error, SceneError};
use crate::law::written::named;
use crate::law::{Fields, Law, LinearInVelocity, Numbers, VelocityIndependent};
use crate::state::State;
use crate::system::{LinearVelocities, WithoutVelocities};

type Of<N, R> = <N as Numbers>::Of<R>;

/// N bodies in D dimensions under the terms `A` of a scene, as one law of K = N D coordinates, body after body: [`Scene::as_law`].
///
/// ```text
/// Φ = Σ φ(q_a − q_b) + Σ φ(q_a),   m_a q_a″ = −∂Φ/∂q_a + F_a
/// ```
///
/// The loops of a [`Scene`] are over as many bodies as there are; here their number is in the type, and a step is code made for it. It
/// is stepped as other laws are: in any scalar, and side by side with others in the lanes of an [ensemble](crate::Ensemble::scene).
/// Masses are those of the bodies; a [`mass`](crate::Simulation::mass) beside them multiplies their inertia, and not what laws read of
/// them; that of a pinned body is infinite. Momenta are sums over the bodies. It is the same motion as that of the scene, in other
/// roundings.
///
/// Under [`Restricted`] some may be test bodies ([`Scene::as_restricted_law`]): sums are those over the others.
pub struct FewBodies<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, S: Sides = Mutual> {
    numbers: A::Numbers,
    /// By which bodies count in sums: the masses that were given, also of those at rest; 0 of test bodies.
    weights: [f64; N],
    /// Masses by which accelerations are forces: infinite, of bodies that are pinned. A quotient by it is 0 to the bit, so that nothing
    /// is there for pins where there are none.
    inertia: [f64; N],
    first: State<K>,
    refused: Option<Error>,
}

impl<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, S: Sides> FewBodies<A, D, N, K, S> {
    /// Where the bodies of the scene are.
    pub fn start(&self) -> State<K> {
        self.first
    }

    fn of<P, L: Term<D, P, B, Ready = A>, B: Space<D>>(scene: Scene<D, P, L, B>) -> Result<Self, Error> {
        let Scene { bodies, laws, space } = scene;
        bodies.check()?;
        space.check()?;
        let acts = laws.prepare(&bodies, space)?;
        acts.as_written(&|i| [bodies.q[i], bodies.v[i]], bodies.t)?;
        let (t, given) = (bodies.t, bodies.masses.len());
        let masses = <[f64; N]>::try_from(bodies.masses);
        let masses = masses.map_err(|_| SceneError::NotSoMany { bodies: given, declared: N })?;
        let tests = |i: &usize| bodies.tests.contains(i);
        if let Some(body) = bodies.drives.bodies().chain((0..N).filter(|i| S::MUTUAL && tests(i))).min() {
            return Err(SceneError::NotFree { body }.into());
        }
        let weights = from_fn(|i| if tests(&i) { 0.0 } else { masses[i] });
        let inertia = from_fn(|i| if bodies.pins.contains(&i) { f64::INFINITY } else { masses[i] });
        let [q, v] = [bodies.q, bodies.v].map(|list| from_fn(|i| list[i / D][i % D]));
        Ok(FewBodies { numbers: acts.numbers(), weights, inertia, first: State { t, q, v }, refused: None })
    }

    /// The law; what refuses it is told when it is run.
    fn new<P, L: Term<D, P, B, Ready = A>, B: Space<D>>(scene: Scene<D, P, L, B>) -> Self {
        const { assert!(K == N * D, "a scene of N bodies in D dimensions is a law of K = N D coordinates") };
        FewBodies::of(scene).unwrap_or_else(|cause| FewBodies {
            numbers: Numbers::from_list(|_| f64::NAN),
            weights: [1.0; N],
            inertia: [1.0; N],
            first: State::new([0.0; K], [0.0; K]),
            refused: Some(cause),
        })
    }
}

impl<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, S: Sides> Copy for FewBodies<A, D, N, K, S> {}
impl<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, S: Sides> Clone
    for FewBodies<A, D, N, K, S>
{
    fn clone(&self) -> Self {
        *self
    }
}

impl<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, S: Sides> core::fmt::Debug
    for FewBodies<A, D, N, K, S>
{
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut shown = f.debug_struct("FewBodies");
        shown
            .field("weights", &self.weights)
            .field("inertia", &self.inertia)
            .field("start", &self.first)
            .finish_non_exhaustive()
    }
}

impl<const D: usize, P, B: Space<D>, L: Term<D, P, B>> Scene<D, P, L, B> {
    /// The scene of N bodies as one law of K = N D coordinates, for few bodies, two to some twenty: [`FewBodies`].
    ///
    /// Laws are those that `#[dmech::law]` writes, on each body, on all pairs, also with a cut-off, along the chain and along bonds, of 24
    /// bodies at most. Members of an ensemble may have each its own list of bonds, its own box, its own pins. All pairs are looked at,
    /// also where a cut-off leaves few. What a simulation of the scene would refuse is refused when the law is run, and so are another
    /// number of bodies ([`SceneError::NotSoMany`]) and bodies that are driven ([`SceneError::NotFree`]). Test bodies are those of
    /// [`as_restricted_law`](Scene::as_restricted_law), and refused here.
    pub fn as_law<const N: usize, const K: usize>(self) -> FewBodies<L::Ready, D, N, K>
    where
        L::Ready: AmongFew<D, N>,
    {
        FewBodies::new(self)
    }

    /// The same of a scene with [test bodies](Scene::test_body), which feel the others and do not act on them: as in the restricted
    /// problem of three bodies, or clones of an asteroid among planets.
    ///
    /// Energy, momenta and work are those of the bodies that act, as in the scene. Which bodies are test bodies may differ from member to
    /// member of an ensemble, all and none of them too. That choices are made along each link is why it is another law: of one without
    /// test bodies it is, to the bit, what [`as_law`](Scene::as_law) gives, in more time.
    ///
    /// ```
    /// # use dmech_core::prelude::*;
    /// # use dmech_core::scene::{AmongFew, Restricted, Scene, Term};
    /// # fn map<L: Term<2, ()>>(planets: impl Fn() -> Scene<2, (), L> + Clone + Sync) -> Result<(), Error>
    /// # where L::Ready: AmongFew<2, 3, Restricted> + dmech_core::scheme::WithoutVelocities {
    /// // A sun, a planet, and an asteroid that is elsewhere in each member.
    /// let run = Ensemble::of(1000)
    ///     .scene(|k| planets().test_body(1.0, [2.0, 1e-3 * k as f64], [0.0, 0.7]).as_restricted_law::<3, 6>())
    ///     .scheme(Nystrom::order6())
    ///     .dt(0.01)
    ///     .run_until(100.0)?;
    /// # Ok(())
    /// # }
    /// ```
    pub fn as_restricted_law<const N: usize, const K: usize>(self) -> FewBodies<L::Ready, D, N, K, Restricted>
    where
        L::Ready: AmongFew<D, N, Restricted>,
    {
        FewBodies::new(self)
    }
}

impl<const K: usize> State<K> {
    /// The state of the bodies whose coordinates these are, D of each, body after body: [`Scene::as_law`].
    pub fn bodies<const D: usize>(&self) -> SceneState<D> {
        const { assert!(K.is_multiple_of(D), "the coordinates are those of whole bodies") };
        let [q, v] = [&self.q, &self.v].map(|x| x.as_chunks().0.to_vec());
        SceneState { t: self.t, q, v }
    }
}

#[diagnostic::do_not_recommend]
impl<A: AmongFew<D, N, S> + WithoutVelocities, const D: usize, const N: usize, const K: usize, S: Sides>
    VelocityIndependent for FewBodies<A, D, N, K, S>
{
}

#[diagnostic::do_not_recommend]
impl<A: AmongFew<D, N, S> + LinearVelocities, const D: usize, const N: usize, const K: usize, S: Sides> LinearInVelocity
    for FewBodies<A, D, N, K, S>
{
}

impl<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, R: Real, S: Sides> Law<K, R>
    for FewBodies<A, D, N, K, S>
{
    type Field<'a>
        = Whole<A, D, N, K, R, S>
    where
        Self: 'a;

    const AUTONOMOUS: bool = A::AUTONOMOUS;
    const BODY: usize = D;
    const LINEAR_MOMENTUM: bool = A::LINEAR_MOMENTUM;
    const ANGULAR_MOMENTUM: bool = A::ANGULAR_MOMENTUM;
    const ALL_COUNT: bool = S::MUTUAL;

    #[inline(always)]
    fn field(&self, _: R, t: R) -> Whole<A, D, N, K, R, S> {
        let numbers = A::Numbers::gather(|k| R::from_f64(self.numbers.at(k)));
        let acting = S::acting(&self.weights.map(R::from_f64));
        Whole { acts: A::moment(numbers, acting, t), inertia: self.inertia.map(R::from_f64), t }
    }

    fn refused(&self) -> Option<Error> {
        self.refused
    }

    fn pinned(&self, i: usize) -> bool {
        self.inertia[i / D] == f64::INFINITY
    }

    /// A test body has the mass by which it is moved; one that is pinned any.
    fn mass_ratios(&self) -> [f64; K] {
        from_fn(|i| match (self.weights[i / D], self.inertia[i / D]) {
            (0.0, f64::INFINITY) => 1.0,
            (0.0, inertia) => inertia,
            (weight, _) => weight,
        })
    }

    #[inline(always)]
    fn weights(&self) -> [R; K] {
        from_fn(|i| R::from_f64(self.weights[i / D]))
    }

    fn tell(&self, see: &mut dyn FnMut(&'static str, f64)) {
        named(<Self as Fields<K>>::names, &self.numbers(), see);
    }
}

impl<A: AmongFew<D, N, S>, const D: usize, const N: usize, const K: usize, S: Sides> Fields<K>
    for FewBodies<A, D, N, K, S>
{
    type Numbers = ([[f64; N]; 2], A::Numbers);
    type Moment<R: Real> = Whole<A, D, N, K, R, S>;

    fn numbers(&self) -> Self::Numbers {
        ([self.weights, self.inertia], self.numbers)
    }

    fn names(see: &mut dyn FnMut(&'static str)) {
        ["mass", "inertia"].into_iter().for_each(|name| (0..N).for_each(|_| see(name)));
        A::names(see);
    }

    #[inline(always)]
    fn moment<R: Real>(
        ([weights, inertia], numbers): ([[R; N]; 2], Of<A::Numbers, R>),
        _: R,
        t: R,
    ) -> Whole<A, D, N, K, R, S> {
        Whole { acts: A::moment(numbers, S::acting(&weights), t), inertia, t }
    }

    #[inline(always)]
    fn masses<R: Real>(([weights, _], _): ([[R; N]; 2], Of<A::Numbers, R>)) -> [R; K] {
        from_fn(|i| weights[i / D])
    }
}
