//! Well-known laws, each with its formula, domain, invariants, source and, where one is known, its exact solution.
//!
//! Parameters are public fields and [`Default`] gives values to begin with. Units are whatever set is consistent; the
//! tables name the dimension of each parameter in terms of energy E, mass M, length L and time T. Closed forms are for
//! unit mass: a particle of mass m under Φ moves as one of unit mass under Φ/m.
//!
//! | law | coordinates | acts | exact solution |
//! |---|---|---|---|
//! | [`Pendulum`] | 1 | potential | elliptic functions |
//! | [`DampedPendulum`] | 1 | potential, friction | |
//! | [`DrivenPendulum`] | 1 | potential, friction, driving | |
//! | [`Kepler`], [`Kepler3`] | 2, 3 | central potential | conic section, Kepler's equation |
//! | [`HenonHeiles`] | 2 | potential | none: chaotic |
//! | [`Duffing`] | 1 | potential, friction, driving | elliptic functions, where free |
//! | [`VanDerPol`] | 1 | force | series of the period |
//! | [`Morse`] | 1 | potential | elementary functions |
//! | [`Quartic`] | 1 | potential | elliptic functions |
//! | [`Anharmonic`] | 3 | potential | |
//! | [`MagneticField`] | 3 | v × B, which does no work | helix |
//! | [`Wall`] | 1 | piecewise potential | period |
//! | [`LennardJones`] | 1 | potential | period of small vibrations |
//!
//! Elements of orbits are in [`kepler`], constants of nature and units in [`units`].
//! Laws between two bodies are in [`pairs`]: gravity, charges, atoms, springs, chains, contacts.
//!
//! ```
//! use dmech::{models::Pendulum, prelude::*};
//!
//! let law = Pendulum { k: 2.0 };
//! let period = law.period(1.2);
//! let run = Simulation::new(law, State::new([1.2], [0.0])).scheme(DiscreteGradient).dt(period / 1000.0).run(1000)?;
//! assert!((run.last().q[0] - 1.2).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod anharmonic;
mod damped_pendulum;
mod driven_pendulum;
mod duffing;
mod elliptic;
mod henon_heiles;
mod lennard_jones;
mod magnetic_field;
mod morse;
mod pendulum;
mod quartic;
mod van_der_pol;
mod wall;

pub mod kepler;
pub mod pairs;
pub mod units;

pub use anharmonic::Anharmonic;
pub use damped_pendulum::DampedPendulum;
pub use driven_pendulum::DrivenPendulum;
pub use duffing::Duffing;
pub use henon_heiles::HenonHeiles;
pub use kepler::{Kepler, Kepler3};
pub use lennard_jones::LennardJones;
pub use magnetic_field::MagneticField;
pub use morse::Morse;
pub use pendulum::Pendulum;
pub use quartic::Quartic;
pub use van_der_pol::VanDerPol;
pub use wall::Wall;
