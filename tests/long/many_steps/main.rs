//! Motions of many steps or of many bodies.

#[path = "../../../examples/hard_cases/cases/mod.rs"]
mod cases;
#[path = "../../../examples/shared/gyration.rs"]
mod gyration;

mod bonds;
mod boris;
mod chains;
mod closed;
mod hard_cases;
mod magnetic;
mod memory;
mod passing;
mod periodic;
mod random;
mod round_off;
