//! Runs: saved, resumed, shown.

mod checkpoint;
mod own_invariants;
mod progress;
mod resumed;
