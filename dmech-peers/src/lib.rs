//! Time against error on five motions, for the schemes of dmech, loops written by hand, and any other solver.
//!
//! The other crates are dependencies of the program only, which is a bench; heyoka it finds in a Python that has it:
//!
//! ```text
//! pip install heyoka
//! export RUSTFLAGS="-C target-cpu=native"
//! cargo bench -p dmech-peers --bench peers --features solvers
//! cargo bench -p dmech-peers --bench outer_ss -- 1e6
//! cargo bench -p dmech-peers --bench batch
//! ```
//!
//! An [`Entrant`] runs a motion once for a knob, which is the number of steps or the tolerance. All entrants of a motion
//! are measured together by [`measure`], in rounds, so that other load on the machine hits all alike; every run counts
//! from before its solver is made until the position at the end is known.

mod ends;
mod entrant;
mod gauss;
mod laws;
mod measure;
mod motion;
mod orbits;
mod outer;
mod problem;
mod recommended;
mod report;
mod schemes;
mod sine;
mod twins;

pub use entrant::{Crate, Entrant, Finish, distance, tolerances};
pub use laws::{ThreeBodies, three_bodies};
pub use measure::{Line, measure};
pub use motion::{Eight, Fput, Motion, Planet, Swing};
pub use orbits::{ORBITS, ORBITS_END, orbit_end, orbit_law, orbit_start};
pub use outer::{OuterPlanets, outer_angular_momentum, outer_energy, outer_gauss, outer_scene, outer_start};
pub use problem::{Problem, eccentric, eight, fput, orbit, pendulum};
pub use recommended::{Kind, recommended};
pub use report::{GOALS, Report};
pub use schemes::{chain_schemes, law_schemes};
pub use twins::{planet_twin, twins};
