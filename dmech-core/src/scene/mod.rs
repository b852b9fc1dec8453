//! Many bodies: laws on each body, between any two, along a chain, on listed bonds.
//!
//! A [`Scene`] holds bodies and laws; [`Simulation::scene`](crate::Simulation::scene) runs it by any of the schemes. What
//! acts is composed in the type of the scene, so each law is compiled for itself and for no number of bodies in particular.
//! The Newton matrix of the implicit schemes follows from what is linked: block-tridiagonal for chains, dense for all pairs.

mod builder;
mod compensated;
mod matrix;
mod newton;
#[cfg(feature = "serde")]
mod resume;
mod scheme;
mod setting;
mod simulation;
mod state;
mod stepper;
mod terms;
mod vectors;
mod watch;

pub use builder::{Bodies, FieldLaw, Scene};
pub use compensated::CompensatedVectors;
pub use matrix::Matrix;
pub use newton::Solver;
pub use scheme::{SceneScheme, Start, Workspace};
pub use setting::{Setting, System};
pub use state::SceneState;
pub use stepper::SceneStepper;
pub use terms::{Acts, Bonds, Chain, Each, Fault, Linked, Moving, Pairs, Term, Topology, WithoutVelocities};
pub use vectors::Vectors;
