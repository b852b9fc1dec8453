//! What runs in dmech: laws, schemes, Newton, simulations, invariants, reports.
//!
//! A law is a [`Potential`]; the macros of `dmech` write one from its declaration, and one can be written by hand. A
//! [`Simulation`] moves a [`State`] under it by a scheme, and the [`Run`] that comes back has the states, the invariants
//! and a report.
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "nalgebra")]
mod algebra;
#[cfg(feature = "approx")]
mod approx;
mod changes;
#[cfg(feature = "serde")]
mod checkpoint;
#[cfg(feature = "serde")]
mod components;
mod drift;
mod ensemble;
mod error;
#[cfg(any(feature = "ranks", feature = "store"))]
mod flat;
mod fnv;
mod invariant;
mod law;
mod look;
mod method;
mod name;
#[doc(hidden)]
pub mod off;
#[cfg(feature = "serde")]
mod resume;
mod run;
mod setup;
mod snapshot;
mod span;
mod state;
mod stepper;
mod text;
pub mod vector;
mod words;

pub mod extend;

pub mod newton;
#[cfg(feature = "scene")]
pub mod scene;
pub mod scheme;
pub mod system;

#[cfg(feature = "serde")]
pub use checkpoint::{Carried, Checkpoint, Saved};
pub use dmech_scalar::{DoubleDouble, Mask, Real};
pub use drift::Drift;
pub use ensemble::{Ensemble, EnsembleRun};
#[cfg(feature = "serde")]
pub use error::Difference;
#[cfg(feature = "scene")]
pub use error::SceneError;
#[cfg(feature = "store")]
pub use error::StoreError;
pub use error::{Disagreement, Error, Place};
pub use invariant::{Invariant, Kept};
pub use law::{
    Between, Conservative, Derivation, Field, Force, Law, LinearInVelocity, MassIndependent, Masses, Numbers, PairLaw,
    Potential, Reads, Symmetric, VelocityIndependent, radial,
};
#[cfg(feature = "scene")]
pub use law::{CutOff, LinkLaw};
#[doc(hidden)]
pub use law::{rotation, written};
pub use run::{Columns, Crossing, Csv, Event, History, HistoryPart, Interrupted, Npy, Report, Run, Simulation};
#[cfg(feature = "scene")]
pub use scene::{Scene, SceneState};
pub use scheme::NoScheme;
pub use scheme::{
    Adaptable, Adaptive, Boris, CompensatedLeapfrog, Composed, DiscreteGradient, Explicit, ForceGradient, Gauss, Guess,
    Implicit, Kanatani, Leapfrog, LineIntegral, Newton, Nystrom, Relaxed, RungeKuttaNystrom, Start, coefficients,
};
pub use setup::Setup;
pub use state::State;
pub use stepper::Stepper;
pub use system::{Particle, System};

/// Everything that a program needs: `use dmech::prelude::*;`.
pub mod prelude {
    #[cfg(feature = "serde")]
    pub use crate::checkpoint::Checkpoint;
    pub use crate::law::{
        Conservative, Derivation, Force, Law, LinearInVelocity, MassIndependent, Potential, VelocityIndependent,
    };
    #[cfg(feature = "scene")]
    pub use crate::scene::{Scene, SceneState};
    pub use crate::scheme::{
        Adaptable, Boris, CompensatedLeapfrog, Composed, DiscreteGradient, Explicit, ForceGradient, Gauss, Guess,
        Implicit, Kanatani, Leapfrog, LineIntegral, Method, Newton, Nystrom, Relaxed, RungeKuttaNystrom, Scheme, Start,
        coefficients,
    };
    pub use crate::{
        Crossing, Csv, Drift, Ensemble, EnsembleRun, Error, Event, Interrupted, Invariant, Kept, Npy, Particle, Run,
        Simulation, State, Stepper,
    };
    pub use dmech_scalar::{DoubleDouble, Real as _};
}
