//! Runs: recorded, seen, changed, saved, resumed, shown.

mod bounces;
mod changes;
mod checkpoint;
mod events;
mod history;
mod kept;
mod output;
mod own_invariants;
mod plots;
mod progress;
mod resumed;
mod streams;
mod studies;
mod walls;
