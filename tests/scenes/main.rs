//! Many bodies.

mod bonds;
mod chains;
mod closed;
mod degree;
mod driven;
mod few;
mod memory;
mod optional;
mod pair_models;
mod passing;
mod periodic;
mod random;
mod test_bodies;
