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
//! The [`guide`] goes from a first motion to a scheme of one's own, and says where each thing is found.
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
//! The macro sees the method as text. Before a law is stepped the method itself is called, and [`Error::NotAsWritten`] refuses
//! a law that is not what it computes, because a name in it stands for something else than its text says.
//! The generated code computes what the method computes, with one exception: `x.clamp(low, high)` panics in Rust where `low`
//! lies above `high` or one of them is NaN. Bounds that the macro can see are checked when the program is compiled; for fields of
//! the law, the generated code computes `x.max(low).min(high)`.
//!
//! An `#[invariant]`, a number of `q` and `v`, is watched in runs beside energy and momenta: [`Run::drift_of`].
//! A `#[force]` may depend on the position `q`, the velocity `v`, `m` and `t`, alone or beside a potential; it brings
//! [`Force`] with its analytic Jacobians. What a law can be stepped by follows from its expression: `Leapfrog`,
//! `CompensatedLeapfrog`, `Nystrom`, `RungeKuttaNystrom`, `Relaxed`, `ForceGradient` and `Kanatani` refuse a force that depends on the
//! velocity when the program is compiled, and `Boris` one that is not linear in it.
//! [`Derivation::derivation`] shows everything that was derived in readable mathematics.
//!
//! # Bodies and the laws between them
//!
//! A `#[pair]` is the potential energy of two bodies a and b, in the distance `r: f64` or the separation `d: [f64; D]`,
//! which is q_a − q_b; where the law needs them it names the masses `ma` and `mb`, the data that the bodies carry, `a: &P`
//! and `b: &P`, and the time `t`. A `#[pair_force]` is the force on a from b, in `d`, the velocities `va` and `vb`, and
//! the same others. A [`Scene`] holds bodies and says where laws act:
//!
//! | method | the law acts |
//! |---|---|
//! | [`.field(law)`](Scene::field) | on each body by itself: a `#[potential]` or a `#[force]` |
//! | [`.field_of(\|i, data\| law)`](Scene::field_of) | on each body by itself, on each its own: charges in a magnetic field |
//! | [`.pairs(law)`](Scene::pairs) | between any two bodies; its energy does not depend on which comes first |
//! | [`.chain(law)`](Scene::chain) | between consecutive bodies: a is body j, b is body j + 1 |
//! | [`.bonds(law, list)`](Scene::bonds) | between the bodies of each `(a, b)` in a list |
//!
//! [`.pin(i)`](Scene::pin) fixes body i. Well-known laws are in [`models`] and, between two bodies, in [`models::pairs`].
//! Schemes, adaptive steps, invariants, reports and checkpoints are those of one body:
//!
//! ```
//! use dmech::prelude::*;
//!
//! /// k (r − ℓ)²/2
//! #[derive(Clone, Copy, Debug)]
//! struct Spring { k: f64, length: f64 }
//!
//! #[dmech::law]
//! impl Spring {
//!     #[pair]
//!     fn energy(&self, r: f64) -> f64 {
//!         0.5 * self.k * (r - self.length).powi(2)
//!     }
//! }
//!
//! /// m g y
//! #[derive(Clone, Copy, Debug)]
//! struct Weight { g: f64 }
//!
//! #[dmech::law]
//! impl Weight {
//!     #[potential]
//!     fn energy(&self, q: [f64; 2], m: f64) -> f64 {
//!         m * self.g * q[1]
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // Two weights on springs, one below the other, hung from body 0.
//! let scene = Scene::new()
//!     .body(1.0, [0.0, 0.0], [0.0, 0.0])
//!     .body(0.5, [0.0, -1.1], [0.3, 0.0])
//!     .body(2.0, [0.4, -2.0], [0.0, 0.0])
//!     .pin(0)
//!     .chain(Spring { k: 70.0, length: 1.0 })
//!     .field(Weight { g: 9.81 });
//! let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.01).run(1000)?;
//! assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12);
//! # Ok(())
//! # }
//! ```
//!
//! # The schemes
//!
//! | scheme | order | keeps | costs |
//! |---|---|---|---|
//! | [`Explicit`] | 1 | work | one force |
//! | [`Leapfrog`] | 2 | angular momentum; energy bounded | one force |
//! | [`CompensatedLeapfrog`] | 2 | the same, with sums that lose nothing: for very long runs or very short steps | one force |
//! | [`Boris`] | 2 | energy in a magnetic field alone exactly; beside a potential bounded, or a walk if the field is not uniform: for forces linear in the velocity | one force |
//! | [`Implicit`](struct@Implicit) | 2 | work with the mean force; energy bounded | one or a few forces and Jacobians |
//! | [`DiscreteGradient`](struct@DiscreteGradient) | 2 | energy and angular momentum exactly | one or a few discrete gradients and Jacobians |
//! | [`Kanatani`](struct@Kanatani) | 2 | its discrete energy and angular momentum exactly | the same |
//! | [`Composed`] | 4, 6, 8 | what the scheme keeps that it is composed of | 7, 13, 21 of its steps |
//! | [`Nystrom`] | 4, 6, 8 | angular momentum; energy bounded | 6, 14, 19 forces |
//! | [`Relaxed`] | 6, 8 | energy exactly; no momentum | 15, 20 forces |
//! | [`RungeKuttaNystrom`] | 12 | nothing but linear momentum: for members of ensembles whose position is wanted to many digits | 17 forces |
//! | [`ForceGradient`] | 4, 6, 8 | angular momentum; energy bounded | 5, 5, 14 forces, and the change of 2, 3, 14 along themselves |
//! | [`Gauss`] | 16 | angular momentum; energy bounded, mostly to rounding | 4 to 15 sweeps of 8 forces side by side |
//! | [`LineIntegral`] | 4, 6, 8, 10 | energy exactly where the potential is a polynomial | the same |
//!
//! # Steps that follow the motion
//!
//! On an orbit of eccentricity 0.99 equal steps must be as short everywhere as the pericentre asks. `.adaptive(tolerance)` in
//! place of `.dt(h)` takes steps in proportion to the time scale that the law itself has where the motion is, by a reversible
//! rule: what the schemes keep, they keep, `DiscreteGradient` and its compositions the energy exactly, others to and fro once the steps
//! are short enough to see the motion change. `Gauss` is the fast one for
//! many digits, `Nystrom` for few (see [`Simulation::adaptive`]):
//!
//! ```
//! use dmech::{models::Kepler, prelude::*};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let law = Kepler { gm: 1.0 };
//! let (comet, end) = (law.pericentre(1.0, 0.99), 10.0 * law.period(1.0));
//! let scheme = Composed::order6(DiscreteGradient);
//! let run = Simulation::new(law, comet).scheme(scheme).adaptive(1e-8).run_until(end)?;
//! assert_eq!(run.last().t, end);
//! assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12);
//! let [shortest, longest] = run.report().dt_range().unwrap();
//! assert!(longest > 1000.0 * shortest);
//! # Ok(())
//! # }
//! ```
//!
//! Scenes take them too: their time scale is that of all links and fields together, and steps shorten before two bodies that pull on
//! each other pass. Contacts can be stepped over: `.dt(h)` beside it is the longest step.
//!
//! # Which scheme for which error
//!
//! A [`Study`] runs schemes on a law, or on a scene, over a ladder of steps, and tells what each needs for an error, in time
//! and in forces:
//!
//! ```
//! use dmech::{StudyError, models::Pendulum, prelude::*};
//!
//! # fn main() -> Result<(), StudyError> {
//! let law = Pendulum { k: 1.0 };
//! let report = Study::new(law, State::new([1.2], [0.0]), 30.0)
//!     .scheme(Leapfrog)
//!     .scheme(Composed::order4(Leapfrog))
//!     .ladder([0.4, 0.2, 0.1, 0.05, 0.025])
//!     .exact(|t| [law.exact(1.2, t)])
//!     .run()?;
//! println!("{report}");
//! let forces = report.evaluations_at(1e-3);
//! assert!(forces[1].1 < forces[0].1);
//! # Ok(())
//! # }
//! ```
//!
//! # Many motions at once
//!
//! An [`Ensemble`] moves members with a law and a start each, side by side in the lanes of the registers and over all cores; each is, to
//! the bit, what it is alone:
//!
//! ```
//! use dmech::{models::Kepler, prelude::*};
//!
//! # fn main() -> Result<(), dmech::Error> {
//! let law = |k: usize| Kepler { gm: 1.0 + 1e-3 * k as f64 };
//! let start = |k: usize| law(k).pericentre(1.0, 0.9 * k as f64 / 100.0);
//! let run = Ensemble::of(100).law(law).start(start).scheme(Nystrom::order6()).adaptive(1e-6).run_until(10.0)?;
//! let alone = Simulation::new(law(70), start(70)).scheme(Nystrom::order6()).adaptive(1e-6).run_until(10.0);
//! assert_eq!(run.last(70).unwrap(), *alone.unwrap().last());
//! # Ok(())
//! # }
//! ```
//!
//! # Thirty-one digits
//!
//! A declared law runs with any scalar: [`DoubleDouble`] numbers have 31 digits, at 9 to 40 times the cost of a step. Errors of
//! a scheme can so be told from rounding, and [`Study::precise`] measures errors in `f64` to the last digit:
//!
//! ```
//! use dmech::{models::Kepler, prelude::*};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let start = State::of([0.5, 0.0].map(DoubleDouble::from), [0.0, 1.63].map(DoubleDouble::from));
//! let kepler = Simulation::new(Kepler { gm: 1.0 }, start).scheme(Composed::order8(DiscreteGradient));
//! let run = kepler.dt(0.02).run_until(4.0)?;
//! assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-30);
//! println!("{:.28}", run.last().q[0]);
//! # Ok(())
//! # }
//! ```
//!
//! Parameters and numbers written in a law are those of `f64`, and so is the time, t₀ + k h: a law that names it knows it to 16
//! digits.
//!
//! # Features
//!
//! | feature | default | what |
//! |---|---|---|
//! | `scene` | yes | scenes of many bodies |
//! | `parallel` | no | pair loops of large scenes on all cores, equal to the bit for any number of threads |
//! | `sparse` | no | sparse Newton matrices for the implicit schemes on listed bonds, through faer; dense without |
//! | `serde` | no | `Checkpoint`: runs that are saved and resumed bit for bit; states, runs and reports in other formats |
//! | `approx` | no | states and drifts in `assert_abs_diff_eq!` and its kin |
//! | `nalgebra` | no | states, gradients and Hessians as its vectors and matrices |
//! | `progress` | no | `Simulation::with_progress`, `Ensemble::with_progress`: a bar on the terminal during long runs, through indicatif |
//! | `store` | no | `Ensemble::store`: a sweep in a database of SQLite, which goes on from it bit for bit after it was killed; SQLite comes along |
//! | `ranks` | no | `Ensemble::ranks`: several processes move an ensemble together, those of MPI by the crate `dmech-mpi` |
//! | `plot` | no | `Run::plot`, `Run::plot_energy`, `StudyReport::plot`: motions, invariants and studies as pictures (SVG), through plotters; `dmech::plot` is what they are drawn with |
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

pub use dmech_macros::{Law, law};

// Texts: nothing of it is compiled into a program.
#[cfg(any(doc, doctest))]
pub mod guide;
pub mod models;

// What a program declares, sets up and gets back.
#[cfg(feature = "serde")]
#[doc(inline)]
pub use dmech_core::Checkpoint;
#[cfg(feature = "store")]
#[doc(inline)]
pub use dmech_core::StoreError;
#[doc(inline)]
pub use dmech_core::{
    Conservative, Crossing, Csv, Derivation, DoubleDouble, Drift, Ensemble, EnsembleRun, Error, Event, Force, History,
    HistoryPart, Interrupted, Invariant, Kept, Law, Npy, Potential, Report, Run, Simulation, State, Stepper,
};
#[cfg(feature = "scene")]
#[doc(inline)]
pub use dmech_core::{Scene, SceneError, SceneState};
#[doc(inline)]
#[cfg(feature = "plot")]
pub use dmech_plot as plot;
pub use dmech_study::{Study, StudyError, StudyReport, verify, verify_scheme};

// The schemes.
#[doc(inline)]
pub use dmech_core::{
    Boris, CompensatedLeapfrog, Composed, DiscreteGradient, Explicit, ForceGradient, Gauss, Implicit, Kanatani,
    Leapfrog, LineIntegral, Nystrom, Relaxed, RungeKuttaNystrom, coefficients,
};

// For those who look closer.
#[cfg(feature = "scene")]
#[doc(inline)]
pub use dmech_core::scene;
#[doc(inline)]
pub use dmech_core::{extend, scheme};
#[doc(inline)]
pub use dmech_study::study;

/// What `use dmech::prelude::*;` brings: traits, schemes, simulations and what they return.
pub mod prelude {
    pub use dmech_core::prelude::*;
    pub use dmech_study::{Study, verify, verify_scheme};
}

/// What generated code refers to; not for use by hand.
#[doc(hidden)]
pub mod __private {
    pub mod v1 {
        pub use dmech_core::extend::{
            Between, Conservative, Derivation, Field, Fields, Force, Law, LinearInVelocity, Mask, MassIndependent,
            PairFields, PairLaw, Potential, Reads, Real, Symmetric, VelocityIndependent, newton, radial,
        };
        pub use dmech_core::written::fresh;
        pub use dmech_core::{rotation, written};
    }
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
