//! For those who write a scheme, or a law by hand.
//!
//! # A scheme of your own
//!
//! A [`Scheme`] is a program over the instructions of a [`System`]: one law, or the bodies of a scene; it cannot tell which it
//! has. This one drifts half a step, kicks, and drifts half a step:
//!
//! ```
//! use dmech_core::extend::*;
//! use dmech_core::prelude::*;
//!
//! #[derive(Clone, Copy, Debug)]
//! struct DriftKickDrift;
//!
//! impl Method for DriftKickDrift {
//!     const NAME: &'static str = "DriftKickDrift";
//!     const ORDER: u32 = 2;
//!     const SYMMETRIC: bool = true;
//!
//!     fn keeps(invariant: Invariant) -> Kept {
//!         Leapfrog::keeps(invariant)
//!     }
//! }
//!
//! impl<Y: System + WithoutVelocities> Scheme<Y> for DriftKickDrift {
//!     /// Position, velocity, and the velocity a step before.
//!     type Memory = [Y::Vector; 3];
//!     type Workspace = Y::Room;
//!
//!     fn workspace(&self, system: &Y, _: &Y::Stride) -> Y::Room {
//!         system.room()
//!     }
//!
//!     fn begin(
//!         &self, _: &Y, _: &Y::Stride, start: &Beginning<'_, Y>, _: &mut Y::Room,
//!     ) -> Result<Self::Memory, NotConverged> {
//!         Ok([start.q, start.v, start.v].map(Clone::clone))
//!     }
//!
//!     fn step(
//!         &self, system: &Y, stride: &Y::Stride, t: Y::Scalar, [q, v, before]: &mut Self::Memory, room: &mut Y::Room,
//!     ) -> Result<Effort<Y::Scalar>, NotConverged> {
//!         let half = Y::Scalar::from_f64(0.5) * Y::dt(stride);
//!         core::mem::swap(v, before);
//!         Y::drift(q, half, before);
//!         system.kick(room, stride, Kick { t: t + half, b: Y::Scalar::ONE, e: 0.0 }, q, before, v);
//!         Y::drift(q, half, v);
//!         Ok(Effort::of(1))
//!     }
//!
//!     fn position<'m>(&self, [q, _, _]: &'m Self::Memory) -> &'m Y::Vector {
//!         q
//!     }
//!
//!     fn velocity(&self, _: &Y, _: &Y::Stride, _: Y::Scalar, [_, v, _]: &Self::Memory) -> Y::Vector {
//!         v.clone()
//!     }
//!
//!     fn finite(&self, [q, v, _]: &Self::Memory) -> bool {
//!         Y::is_finite(q) && Y::is_finite(v)
//!     }
//!
//!     fn kinetic_energy(&self, system: &Y, [_, v, _]: &Self::Memory) -> Y::Scalar {
//!         system.kinetic_energy(v)
//!     }
//!
//!     fn work(&self, system: &Y, _: &Y::Stride, _: &Self::Memory, [_, v, before]: &Self::Memory) -> Y::Scalar {
//!         let mut work = system.no_work();
//!         system.add_work(&mut work, before, v);
//!         system.total(&work)
//!     }
//! }
#![doc = include_str!("examples/quartic.md")]
//!
//! // It runs and is watched like any other.
//! let (law, start) = (Quartic { k: 1.7 }, State::new([1.0], [0.3]));
//! let run = Simulation::new(law, start).scheme(DriftKickDrift).dt(0.01).run_until(50.0)?;
//! assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-3);
//! assert!(run.drift(Invariant::WorkEnergy).unwrap().max_relative() < 1e-13);
//!
//! // Its step depends on the state alone: it can be composed to a higher order.
//! impl OneStep for DriftKickDrift {}
//! let run = Simulation::new(law, start).scheme(Composed::order6(Steps(DriftKickDrift))).dt(0.05).run_until(50.0)?;
//! assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-6);
//!
//! // Bodies of a scene move by it as well.
//! # #[cfg(feature = "scene")]
//! # {
//! let scene = Scene::new().body(1.3, [0.4], [0.0]).body(0.7, [-0.6], [0.1]).field(law);
//! let run = Simulation::scene(scene).scheme(DriftKickDrift).dt(0.01).run(1000)?;
//! assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-3);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! `dmech::verify_scheme(DriftKickDrift).assert()` in a test measures that it has the order, keeps the invariants and finds the
//! way back that it claims, on laws and on a scene. Where the steps leave nothing but rounding, as beyond order 6, the order is
//! *n/a*; `dmech::Study` measures it in steps of your choice, and compares the scheme with others.
//!
//! An implicit scheme asks for [`ImplicitSteps`] in place of [`System`], for one of its three equations, and settles what was
//! found; its workspace is the solver of the system. A splitting needs no code: [`Nystrom::new`](crate::Nystrom::new) and
//! [`ForceGradient::new`](crate::ForceGradient::new) take lengths of your own, [`Composed::new`](crate::Composed::new) stages.
//!
//! # A law by hand
//!
//! A [`Potential`] with `impl Conservative for MyLaw {}` is a [`Law`]; [`Field`] says what acts
//! at one moment, and a [`PairLaw`] what acts between two bodies.

#[cfg(feature = "nalgebra")]
pub use crate::algebra::OfVectors;
pub use crate::changes::{Holds, LawMut};
#[cfg(feature = "serde")]
pub use crate::checkpoint::{Carried, Saved};
pub use crate::drift::{Drifts, MAX_OWN, OwnDrifts};
#[cfg(feature = "store")]
pub use crate::ensemble::InFile;
pub use crate::ensemble::{
    Block, Checksum, Companies, Company, EachAlone, End, InLanes, Joined, Keeps, LANES, LawOf, Members, NoCompany,
    NoLaw, NoStart, Nowhere, Outcome, Rides, Starts, Together, With,
};
#[cfg(feature = "ranks")]
pub use crate::ensemble::{Ranked, Ranks, Travels};
#[cfg(feature = "serde")]
pub use crate::error::Difference;
pub use crate::error::{Disagreement, Place};
#[cfg(feature = "store")]
pub use crate::error::{Reach, StoreError};
#[cfg(any(feature = "ranks", feature = "store"))]
pub use crate::flat::Flat;
pub use crate::invariant::Kept;
#[cfg(feature = "scene")]
pub use crate::law::LinkLaw;
pub use crate::law::{Between, Numbers, PairFields, PairLaw, Reads, Symmetric, radial};
pub use crate::law::{
    Conservative, Derivation, Field, Fields, Force, Law, LinearInVelocity, MassIndependent, Potential,
    VelocityIndependent,
};
pub use crate::law::{Masses, Numbered};
pub use crate::name::Name;
pub use crate::newton::{self, Equation, Increment, NotConverged};
pub use crate::run::{
    After, Attend, Attended, Bounce, Change, Changed, Columns, Observer, Passage, Quantity, Sink, Stream, Watch, Within,
};
#[cfg(feature = "scene")]
pub use crate::scene::{Collision, Encounter, Met};
pub use crate::scheme::{
    Adaptable, Adaptive, Effort, LinearVelocities, Method, OneStep, Reached, Scheme, Steps, WithoutVelocities,
};
pub use crate::scheme::{ByLane, NoScheme};
pub use crate::setup::Setup;
pub use crate::snapshot::Snapshot;
pub use crate::span::steps_until;
pub use crate::system::{
    Ahead, AtStages, Beginning, ImplicitSteps, Kick, Particle, Staged, Step, Stride, System, TimeScale,
};
pub use crate::vector;
pub use dmech_scalar::{Count, DoubleDouble, Exact, Lanes, Mask, Real, Rows};
