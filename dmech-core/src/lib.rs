//! What runs in dmech: laws, schemes, Newton, simulations, invariants, reports.
//!
//! A law is a [`Potential`]; the macros of `dmech` write one from its declaration, and one can be written by hand. A
//! [`Simulation`] moves a [`State`] under it by a scheme, and the [`Run`] that comes back has the states, the invariants
//! and a report.
#![forbid(unsafe_code)]

#[cfg(feature = "approx")]
mod approx;
#[cfg(feature = "serde")]
mod checkpoint;
mod csv;
mod error;
mod interrupted;
mod invariant;
mod law;
mod masses;
mod motion;
mod name;
mod pair;
mod progress;
mod report;
#[cfg(feature = "serde")]
mod resume;
mod run;
mod setup;
mod simulation;
mod state;
mod stepper;
mod text;
#[cfg(feature = "nalgebra")]
mod vectors;
mod watch;
#[doc(hidden)]
pub mod written;

pub mod extend;

pub mod newton;
#[cfg(feature = "scene")]
pub mod scene;
pub mod scheme;
pub mod system;

#[cfg(feature = "serde")]
pub use checkpoint::{Carried, Checkpoint, Difference, Saved};
pub use csv::Columns;
pub use dmech_scalar::{DoubleDouble, Mask, Real};
#[cfg(feature = "scene")]
pub use error::SceneError;
pub use error::{Disagreement, Error, Place};
pub use interrupted::Interrupted;
pub use invariant::{Drift, Invariant, Kept};
pub use law::{Conservative, Derivation, Field, Force, Law, MassIndependent, Potential, VelocityIndependent};
pub use masses::Masses;
#[cfg(feature = "scene")]
pub use pair::LinkLaw;
pub use pair::{Between, Numbers, PairLaw, Reads, Symmetric, radial};
pub use report::Report;
pub use run::Run;
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
