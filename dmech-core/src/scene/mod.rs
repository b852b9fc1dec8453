//! Many bodies: laws on each body, between any two, along a chain, on listed bonds.
//!
//! A [`Scene`] holds bodies and laws; [`Simulation::scene`](crate::Simulation::scene) runs it by any of the schemes. What
//! acts is composed in the type of the scene, so each law is compiled for itself and for no number of bodies in particular.
//! The Newton matrix of the implicit schemes follows from what is linked: block-tridiagonal for chains, dense for all pairs.

mod builder;
mod compensated;
mod matrix;
mod newton;
mod state;
mod system;
mod terms;
mod vectors;

pub use builder::{Bodies, FieldLaw, Scene};
pub use compensated::CompensatedVectors;
pub use matrix::Matrix;
pub use state::SceneState;
pub use system::{SceneRoom, SceneSolver, SceneStride, SceneSystem};
pub use terms::{Acts, Bonds, Chain, Each, Fault, Linked, Moving, Pairs, Term, Topology};
pub use vectors::Vectors;

use crate::scheme::Scheme;
use crate::simulation::Simulation;
use crate::stepper::Stepper;

impl<const D: usize, P, L> Simulation<(), Scene<D, P, L>> {
    /// The bodies of a scene under its laws.
    pub fn scene(scene: Scene<D, P, L>) -> Self {
        Simulation::of((), scene)
    }
}

impl<const D: usize, A: Acts<D>, S: Scheme<SceneSystem<D, A>>> Stepper<SceneSystem<D, A>, S> {
    /// Positions now.
    pub fn q(&self) -> &Vectors<D> {
        self.position()
    }
}
