//! Many bodies.

mod bonds;
mod chains;
mod closed;
mod granular;
mod memory;
mod random;
