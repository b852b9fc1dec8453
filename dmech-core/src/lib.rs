//! What runs in dmech: laws, schemes, Newton, simulations, invariants, reports.
//!
//! A law is a [`Potential`]; the macros of `dmech` write one from its declaration, and one can be written by hand. A
//! [`Simulation`] moves a [`State`] under it by a scheme, and the [`Run`] that comes back has the states, the invariants
//! and a report.
#![forbid(unsafe_code)]

#[cfg(feature = "nalgebra")]
mod algebra;
#[cfg(feature = "approx")]
mod approx;
#[cfg(feature = "serde")]
mod checkpoint;
mod error;
mod invariant;
mod law;
mod name;
#[cfg(feature = "serde")]
mod resume;
mod run;
mod setup;
mod simulation;
mod span;
mod state;
mod stepper;
mod text;
pub mod vector;

pub mod extend;

pub mod newton;
#[cfg(feature = "scene")]
pub mod scene;
pub mod scheme;
pub mod system;

#[cfg(feature = "serde")]
pub use checkpoint::{Carried, Checkpoint, Saved};
pub use dmech_scalar::{DoubleDouble, Mask, Real};
#[cfg(feature = "serde")]
pub use error::Difference;
#[cfg(feature = "scene")]
pub use error::SceneError;
pub use error::{Disagreement, Error, Place};
pub use invariant::{Drift, Invariant, Kept};
#[doc(hidden)]
pub use law::written;
pub use law::{
    Between, Conservative, Derivation, Field, Force, Law, MassIndependent, Masses, Numbers, PairLaw, Potential, Reads,
    Symmetric, VelocityIndependent, radial,
};
#[cfg(feature = "scene")]
pub use law::{LinkLaw, Within};
pub use run::{Columns, Interrupted, Report, Run};
#[cfg(feature = "scene")]
pub use scene::{Scene, SceneState};
pub use scheme::{
    Adaptable, Adaptive, CompensatedLeapfrog, Composed, DiscreteGradient, Explicit, ForceGradient, Guess, Implicit,
    Kanatani, Leapfrog, Newton, Nystrom, Start, coefficients,
};
pub use setup::Setup;
pub use simulation::{NoScheme, Simulation};
pub use state::State;
pub use stepper::Stepper;
pub use system::{Particle, System};

/// Everything that a program needs: `use dmech::prelude::*;`.
pub mod prelude {
    #[cfg(feature = "serde")]
    pub use crate::checkpoint::Checkpoint;
    pub use crate::law::{Conservative, Derivation, Force, Law, MassIndependent, Potential, VelocityIndependent};
    #[cfg(feature = "scene")]
    pub use crate::scene::{Scene, SceneState};
    pub use crate::scheme::{
        Adaptable, CompensatedLeapfrog, Composed, DiscreteGradient, Explicit, ForceGradient, Guess, Implicit, Kanatani,
        Leapfrog, Method, Newton, Nystrom, Scheme, Start, coefficients,
    };
    pub use crate::{Drift, Error, Interrupted, Invariant, Kept, Particle, Run, Simulation, State, Stepper};
    pub use dmech_scalar::{DoubleDouble, Real as _};
}
