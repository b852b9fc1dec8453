//! What every scheme promises, over laws.

#[path = "../../examples/hard_cases/cases/mod.rs"]
mod cases;

mod adaptive;
mod allocation;
mod bodies;
mod compensated;
mod composed;
mod double_double;
mod hard_cases;
mod order;
mod published;
mod relaxed;
mod round_off;
mod runge_kutta_nystrom;
mod splittings;
