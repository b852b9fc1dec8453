//! Runs: saved, resumed, shown.

mod checkpoint;
mod progress;
mod resumed;
