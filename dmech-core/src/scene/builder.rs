//! Setting up a scene.

use super::bodies::Bodies;
use super::state::SceneState;
use super::terms::{Bonds, Chain, Each, Linked, Pairs};
use crate::law::Law;
use crate::law::{LinkLaw, Symmetric};

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
/// Laws are added by where they act: [`field`](Scene::field) on each body, [`pairs`](Scene::pairs) between any two,
/// [`chain`](Scene::chain) between neighbours, [`bonds`](Scene::bonds) between those of a list. Any number of them act
/// together; they are composed in the type, and each is compiled for itself, once for all numbers of bodies.
#[derive(Clone, Debug)]
#[must_use = "a scene does nothing until it is simulated"]
pub struct Scene<const D: usize, P = (), L = ()> {
    pub(super) bodies: Bodies<D, P>,
    pub(super) laws: L,
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
        let bodies =
            Bodies { masses: Vec::new(), q: Vec::new(), v: Vec::new(), data: Vec::new(), pins: Vec::new(), t: 0.0 };
        Scene { bodies, laws: () }
    }
}

impl<const D: usize, P> Default for Scene<D, P> {
    fn default() -> Self {
        Scene::new()
    }
}

impl<const D: usize, L> Scene<D, (), L> {
    /// Adds a body of mass `mass` at `q` with velocity `v`.
    pub fn body(self, mass: f64, q: [f64; D], v: [f64; D]) -> Self {
        self.body_with(mass, q, v, ())
    }
}

impl<const D: usize, P, L> Scene<D, P, L> {
    /// Adds a body that carries data for the laws between bodies, such as a charge.
    pub fn body_with(mut self, mass: f64, q: [f64; D], v: [f64; D], data: P) -> Self {
        self.bodies.masses.push(mass);
        self.bodies.q.push(q);
        self.bodies.v.push(v);
        self.bodies.data.push(data);
        self
    }

    /// Fixes body i, counted from 0 in the order of addition: it acts on the others and does not move.
    pub fn pin(mut self, i: usize) -> Self {
        self.bodies.pins.push(i);
        self
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

    /// A law that acts on each body by itself.
    pub fn field<X: FieldLaw<D>>(self, law: X) -> Scene<D, P, (L, Each<X>)> {
        self.with(Each { law })
    }

    /// A law that acts between any two bodies.
    pub fn pairs<X: LinkLaw<D, P> + Symmetric>(self, law: X) -> Scene<D, P, (L, Linked<X, Pairs>)> {
        self.with(Linked { law, links: Pairs::default() })
    }

    /// A law that acts between consecutive bodies: a is body j and b is body j + 1.
    pub fn chain<X: LinkLaw<D, P>>(self, law: X) -> Scene<D, P, (L, Linked<X, Chain>)> {
        self.with(Linked { law, links: Chain })
    }

    /// A law that acts between the listed pairs of bodies, (a, b).
    pub fn bonds<X: LinkLaw<D, P>>(
        self,
        law: X,
        list: impl IntoIterator<Item = (usize, usize)>,
    ) -> Scene<D, P, (L, Linked<X, Bonds>)> {
        self.with(Linked { law, links: Bonds::new(list) })
    }

    fn with<X>(self, term: X) -> Scene<D, P, (L, X)> {
        Scene { bodies: self.bodies, laws: (self.laws, term) }
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
