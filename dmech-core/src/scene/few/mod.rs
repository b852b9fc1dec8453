//! A scene whose number of bodies is known when it is compiled, as one law.

mod among;
mod links;
mod terms;
mod whole;

pub use among::{Among, AmongFew, Places};
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
pub struct FewBodies<A: AmongFew<D, N>, const D: usize, const N: usize, const K: usize> {
    numbers: A::Numbers,
    masses: [f64; N],
    /// Masses by which accelerations are forces: infinite, of bodies that are pinned. A quotient by it is 0 to the bit, so that nothing
    /// is there for pins where there are none. What is summed over the bodies has the masses that were given, at rest.
    inertia: [f64; N],
    first: State<K>,
    refused: Option<Error>,
}

impl<A: AmongFew<D, N>, const D: usize, const N: usize, const K: usize> FewBodies<A, D, N, K> {
    /// Where the bodies of the scene are.
    pub fn start(&self) -> State<K> {
        self.first
    }

    fn of<P, L: Term<D, P, B, Ready = A>, B: Space<D>>(scene: Scene<D, P, L, B>) -> Result<Self, Error> {
        let Scene { bodies, laws, space } = scene;
        bodies.check()?;
        space.check()?;
        let acts = laws.prepare(&bodies, space)?;
        let (t, given) = (bodies.t, bodies.masses.len());
        let masses = <[f64; N]>::try_from(bodies.masses);
        let masses = masses.map_err(|_| SceneError::NotSoMany { bodies: given, declared: N })?;
        if let Some(body) = bodies.drives.bodies().chain(bodies.tests.iter().copied()).min() {
            return Err(SceneError::NotFree { body }.into());
        }
        let inertia = from_fn(|i| if bodies.pins.contains(&i) { f64::INFINITY } else { masses[i] });
        let [q, v] = [bodies.q, bodies.v].map(|list| from_fn(|i| list[i / D][i % D]));
        Ok(FewBodies { numbers: acts.numbers(), masses, inertia, first: State { t, q, v }, refused: None })
    }
}

impl<A: AmongFew<D, N>, const D: usize, const N: usize, const K: usize> Copy for FewBodies<A, D, N, K> {}
impl<A: AmongFew<D, N>, const D: usize, const N: usize, const K: usize> Clone for FewBodies<A, D, N, K> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A: AmongFew<D, N>, const D: usize, const N: usize, const K: usize> core::fmt::Debug for FewBodies<A, D, N, K> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut shown = f.debug_struct("FewBodies");
        shown
            .field("masses", &self.masses)
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
    /// number of bodies ([`SceneError::NotSoMany`]) and bodies that are driven or test bodies ([`SceneError::NotFree`]).
    pub fn as_law<const N: usize, const K: usize>(self) -> FewBodies<L::Ready, D, N, K>
    where
        L::Ready: AmongFew<D, N>,
    {
        const { assert!(K == N * D, "a scene of N bodies in D dimensions is a law of K = N D coordinates") };
        FewBodies::of(self).unwrap_or_else(|cause| FewBodies {
            numbers: Numbers::from_list(|_| f64::NAN),
            masses: [1.0; N],
            inertia: [1.0; N],
            first: State::new([0.0; K], [0.0; K]),
            refused: Some(cause),
        })
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
impl<A: AmongFew<D, N> + WithoutVelocities, const D: usize, const N: usize, const K: usize> VelocityIndependent
    for FewBodies<A, D, N, K>
{
}

#[diagnostic::do_not_recommend]
impl<A: AmongFew<D, N> + LinearVelocities, const D: usize, const N: usize, const K: usize> LinearInVelocity
    for FewBodies<A, D, N, K>
{
}

impl<A: AmongFew<D, N>, const D: usize, const N: usize, const K: usize, R: Real> Law<K, R> for FewBodies<A, D, N, K> {
    type Field<'a>
        = Whole<A, D, N, K, R>
    where
        Self: 'a;

    const AUTONOMOUS: bool = A::AUTONOMOUS;
    const BODY: usize = D;
    const LINEAR_MOMENTUM: bool = A::LINEAR_MOMENTUM;
    const ANGULAR_MOMENTUM: bool = A::ANGULAR_MOMENTUM;

    #[inline(always)]
    fn field(&self, _: R, t: R) -> Whole<A, D, N, K, R> {
        let numbers = A::Numbers::gather(|k| R::from_f64(self.numbers.at(k)));
        Whole { acts: A::moment(numbers, t), inertia: self.inertia.map(R::from_f64), t }
    }

    fn refused(&self) -> Option<Error> {
        self.refused
    }

    fn pinned(&self, i: usize) -> bool {
        self.inertia[i / D] == f64::INFINITY
    }

    fn mass_ratios(&self) -> [f64; K] {
        from_fn(|i| self.masses[i / D])
    }

    fn tell(&self, see: &mut dyn FnMut(&'static str, f64)) {
        named(<Self as Fields<K>>::names, &self.numbers(), see);
    }
}

impl<A: AmongFew<D, N>, const D: usize, const N: usize, const K: usize> Fields<K> for FewBodies<A, D, N, K> {
    type Numbers = ([[f64; N]; 2], A::Numbers);
    type Moment<R: Real> = Whole<A, D, N, K, R>;

    fn numbers(&self) -> Self::Numbers {
        ([self.masses, self.inertia], self.numbers)
    }

    fn names(see: &mut dyn FnMut(&'static str)) {
        ["mass", "inertia"].into_iter().for_each(|name| (0..N).for_each(|_| see(name)));
        A::names(see);
    }

    #[inline(always)]
    fn moment<R: Real>(
        ([_, inertia], numbers): ([[R; N]; 2], <A::Numbers as Numbers>::Of<R>),
        _: R,
        t: R,
    ) -> Whole<A, D, N, K, R> {
        Whole { acts: A::moment(numbers, t), inertia, t }
    }

    #[inline(always)]
    fn masses<R: Real>(([masses, _], _): ([[R; N]; 2], <A::Numbers as Numbers>::Of<R>)) -> [R; K] {
        from_fn(|i| masses[i / D])
    }
}
