//! Random laws with choices, and what the engine promises of them.
//!
//! | module | what it does |
//! |---|---|
//! | `tree`, `text` | a law as it was written: its value in any scalar, its words in Rust |
//! | `grow` | random laws, beginning with the edges |
//! | `points` | pairs of points, generic and special |
//! | `scale`, `analysis`, `branches`, `forms`, `jet` | how far rounding may move what is computed of a law, in the forms that it may take |
//! | `engine`, `promise`, `trial`, `differences` | the engine's programs, and every promise at a pair of points |
//! | `campaign`, `finding`, `shrink` | many laws; the smallest that fails |
#![forbid(unsafe_code)]

mod analysis;
mod branches;
mod campaign;
mod differences;
mod engine;
mod finding;
mod forms;
mod grow;
mod jet;
mod points;
mod promise;
mod random;
mod scale;
mod shrink;
mod text;
mod tree;
mod trial;

pub use campaign::{Tally, campaign};
pub use engine::{Engine, Second};
pub use finding::Finding;
pub use grow::{FUNCTIONS, Law};
pub use points::{Place, pairs};
pub use promise::{Failure, Promise, ULPS};
pub use random::Random;
pub use scale::{ROUNDING, Scale};
pub use shrink::is_continuous;
pub use text::{COORDINATES, FIELDS};
pub use tree::{Comparison, PARAMETERS, Test, Tree};
pub use trial::{Outcome, try_pair};
