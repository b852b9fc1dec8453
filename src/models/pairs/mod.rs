//! Well-known laws between two bodies, for scenes.
//!
//! a and b are the two bodies, r is their distance, d = q_a − q_b their separation. Laws of the distance act in any number of
//! dimensions and wherever a scene lets a law act: `.pairs`, `.chain`, `.bonds`. Laws of a separation on a line tell the
//! first body from the second and act along a `.chain` or `.bonds`, where the order is known. Of two bodies alone the
//! distance moves as one body of the reduced mass μ = m_a m_b/(m_a + m_b), which closed forms ask for.
//!
//! A closed scene, one of these laws and no pinned body, keeps its energy and its momenta: linear, and beyond one dimension
//! angular. `DiscreteGradient` and its compositions keep both to rounding; what more a law has is said with it.
//!
//! | law | of | reads of a body | closed form |
//! |---|---|---|---|
//! | [`Gravity`] | distance | mass | period of an ellipse |
//! | [`Coulomb`] | distance | [`Charge`] | period of an ellipse, closest approach |
//! | [`LennardJones`] | distance | | period of small vibrations |
//! | [`Morse`] | distance | | period of the vibration |
//! | [`Spring`] | distance | | period of the vibration |
//! | [`FermiPastaUlamTsingou`] | separation on a line | | frequencies of small vibrations |
//! | [`Toda`] | separation on a line | | soliton |
//! | [`Hertz`] | separation on a line | | duration of an impact |
//! | [`HertzSpheres`] | distance | [`Sphere`] | duration of a head-on impact |
//!
//! ```
//! use dmech::{models::pairs::Gravity, prelude::*};
//!
//! // Two stars of masses 3 and 1 at the pericentre of ellipses of eccentricity 0.5 about their common centre.
//! let (law, speed) = (Gravity { g: 1.0 }, 12.0_f64.sqrt());
//! let stars = Scene::new().body(3.0, [-0.125, 0.0], [0.0, -0.25 * speed]).body(1.0, [0.375, 0.0], [0.0, 0.75 * speed]);
//! let period = law.period(1.0, 4.0);
//! let run = Simulation::scene(stars.pairs(law)).scheme(Nystrom::order6()).dt(period / 500.0).run(500)?;
//! assert!((run.last().q[1][0] - 0.375).abs() < 1e-9 && run.last().q[1][1].abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod coulomb;
mod fermi_pasta_ulam_tsingou;
mod gravity;
mod hertz;
mod lennard_jones;
mod morse;
mod spring;
mod toda;

pub use coulomb::{Charge, Coulomb};
pub use fermi_pasta_ulam_tsingou::FermiPastaUlamTsingou;
pub use gravity::Gravity;
pub use hertz::{Hertz, HertzSpheres, Sphere};
pub use lennard_jones::LennardJones;
pub use morse::Morse;
pub use spring::Spring;
pub use toda::Toda;
