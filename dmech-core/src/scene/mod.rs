//! Many bodies: laws on each body, between any two, along a chain, on listed bonds.
//!
//! A [`Scene`] holds bodies and laws; [`Simulation::scene`](crate::Simulation::scene) runs it by any of the schemes. What
//! acts is composed in the type of the scene, so each law is compiled for itself and for no number of bodies in particular.
//! The Newton matrix of the implicit schemes follows from what is linked: block-tridiagonal for chains, dense for all pairs;
//! within a cut-off its blocks are a list, and it is solved by iteration.

mod acting;
mod bodies;
mod both;
mod builder;
mod changes;
mod compensated;
mod driven;
mod drives;
mod eights;
mod encounter;
mod few;
mod matrix;
mod newton;
mod space;
mod state;
mod system;
mod table;
mod terms;
mod topology;
mod vectors;

pub use bodies::Bodies;
pub use builder::{FieldLaw, Scene};
pub use compensated::CompensatedVectors;
pub use drives::Seen;
pub use encounter::{Collision, Encounter, Met};
pub use few::{Among, AmongFew, FewBodies, Mutual, Places, Restricted, Sides, Whole};
pub use matrix::Matrix;
pub use space::{Open, Periodic, Space};
pub use state::SceneState;
pub use system::{SceneRoom, SceneSolver, SceneStride, SceneSystem};
pub use table::LongCsv;
pub use terms::{Acts, Bonds, Chain, Each, Fault, Kicked, Laws, Linked, Moving, Near, One, Own, Pairs, Term};
pub use topology::Topology;
pub use vectors::Vectors;

use crate::law::CutOff;
use crate::run::Simulation;
use crate::scheme::Scheme;
use crate::setup::Setup;
use crate::stepper::Stepper;

/// A law on each body, as a type: [`Scene::field`] adds one.
pub type OnEach<X> = Each<One<X>>;
/// A law on each body of its own, as a type, where bodies carry a `P`: [`Scene::field_of`] adds them.
pub type OnEachOwn<X, P = ()> = Each<Own<X, P>>;
/// A law between any two bodies, as a type: [`Scene::pairs`] adds one.
pub type OnPairs<X> = Linked<X, Pairs>;
/// A law between bodies nearer than its cut-off, as a type: [`Scene::pairs`] and [`Scene::cutoff`] add one.
pub type OnNear<X> = Linked<CutOff<X>, Near>;
/// A law along a chain, as a type: [`Scene::chain`] adds one.
pub type OnChain<X> = Linked<X, Chain>;
/// A law on listed bonds, as a type: [`Scene::bonds`] adds one.
pub type OnBonds<X> = Linked<X, Bonds>;

/// The stepper of a scene with the laws `L`, for a field of a struct: laws stand in the order in which they were added,
/// `((), OnPairs<Gravity>)` or `(((), OnChain<Spring>), OnEach<Weight>)`.
///
/// ```
/// use dmech_core::prelude::*;
/// use dmech_core::scene::{OnEach, SceneStepper};
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
/// struct Game {
///     bodies: SceneStepper<1, ((), OnEach<Bowl>), Leapfrog>,
/// }
///
/// let scene = Scene::new().body(1.0, [0.3], [0.0]).field(Bowl { k: 2.0 });
/// let mut game = Game { bodies: Simulation::scene(scene).scheme(Leapfrog).dt(0.01).stepper()? };
/// game.bodies.advance(100)?;
/// # Ok::<(), Error>(())
/// ```
pub type SceneStepper<const D: usize, L, S, P = (), B = Open> = Stepper<<Scene<D, P, L, B> as Setup<()>>::System, S>;

impl<const D: usize, P, L, B> Simulation<(), Scene<D, P, L, B>> {
    /// The bodies of a scene under its laws.
    pub fn scene(scene: Scene<D, P, L, B>) -> Self {
        Simulation::of((), scene)
    }
}

impl<const D: usize, A: Acts<D>, S: Scheme<SceneSystem<D, A>>> Stepper<SceneSystem<D, A>, S> {
    /// Positions now.
    pub fn q(&self) -> Seen<'_, D> {
        self.system.seen(self.t(), self.position())
    }
}
