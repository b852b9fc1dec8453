//! Declare a potential as ordinary Rust; get time steps made for exactly that law.
//!
//! ```
//! use dmech::prelude::*;
//!
//! #[derive(Clone, Copy, Debug)]
//! struct Kepler { gm: f64 }
//!
//! #[dmech::law]
//! impl Kepler {
//!     #[potential]
//!     fn energy(&self, q: [f64; 2]) -> f64 {
//!         let [x, y] = q;
//!         -self.gm / (x * x + y * y).sqrt()
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let planet = State::new([0.5, 0.0], [0.0, 1.63]);
//! let run = Simulation::new(Kepler { gm: 1.0 }, planet).scheme(DiscreteGradient).dt(0.01).run_until(350.0)?;
//! assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12);
//! println!("{run}");
//! # Ok(())
//! # }
//! ```
//!
//! # The law
//!
//! `#[dmech::law]` stands on an inherent `impl` block, `#[potential]` on the method that returns the potential energy.
//! Arguments are known by name: the position `q` (`f64`, `[f64; D]` or a vector of nalgebra), and where the law needs
//! them the mass `m` and the time `t`. The method stays as it is written and can be called and tested; beside it the
//! macro implements [`Potential`] with the gradient, the Hessian, the discrete gradient and its Jacobian, and the
//! implicit steps in the form that the structure of the law allows. [`macro@Law`] is the short form for a law of one line:
//!
//! ```
//! use dmech::prelude::*;
//!
//! #[derive(Clone, Copy, Debug, dmech::Law)]
//! #[potential(|q: [f64; 1]| 0.5 * self.k * q[0] * q[0])]
//! struct Spring { k: f64 }
//!
//! assert_eq!(Spring { k: 4.0 }.gradient([0.5]), [2.0]);
//! ```
//!
//! A `#[force]` may depend on the position `q`, the velocity `v`, `m` and `t`, alone or beside a potential; it brings
//! [`Force`] with its analytic Jacobians. What a law can be stepped by follows from its expression: `Leapfrog` and
//! `Kanatani` refuse a force that depends on the velocity when the program is compiled. [`Derivation::derivation`] shows
//! everything that was derived in readable mathematics.
//!
//! # The schemes
//!
//! | scheme | order | keeps | costs |
//! |---|---|---|---|
//! | [`Explicit`] | 1 | work | one force |
//! | [`Leapfrog`] | 2 | angular momentum; energy bounded | one force |
//! | [`Implicit`](struct@Implicit) | 2 | work with the mean force; energy bounded | one or a few forces and Jacobians |
//! | [`DiscreteGradient`](struct@DiscreteGradient) | 2 | energy and angular momentum exactly | one or a few discrete gradients and Jacobians |
//! | [`Kanatani`](struct@Kanatani) | 2 | its discrete energy and angular momentum exactly | the same |
//!
//! # Features
//!
//! | feature | default | what |
//! |---|---|---|
//! | `scene` | yes | scenes of many bodies |
//! | `parallel` | no | pair loops of large scenes on all cores, equal to the bit for any number of threads |
//! | `sparse` | no | sparse Newton matrices for the implicit schemes on listed bonds, through faer; dense without |
//! | `serde` | no | `Checkpoint`: runs that are saved and resumed bit for bit |
//! | `progress` | no | `Simulation::with_progress`: a bar on the terminal during long runs, through indicatif |
#![forbid(unsafe_code)]

pub use dmech_core::*;
pub use dmech_macros::{Law, law};

pub mod models;

/// What `use dmech::prelude::*;` brings: traits, schemes, simulations and what they return.
pub mod prelude {
    pub use dmech_core::prelude::*;
}

/// What generated code refers to; not for use by hand.
#[doc(hidden)]
pub mod __private {
    pub mod v1 {
        pub use dmech_core::{
            Between, Conservative, Derivation, Field, Force, Law, Mask, MassIndependent, PairLaw, Potential, Reads,
            Real, Symmetric, VelocityIndependent, newton, radial,
        };
    }
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
