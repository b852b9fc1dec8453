//! The language of a law, and what is generated from one.

mod as_written;
mod degree;
mod derivation;
mod forces;
mod generated;
mod guide;
mod language;
mod many_coordinates;
mod masses;
mod models;
mod orbits;
mod pair_models;
mod pairs;
mod random;
mod readme;
mod verify;
mod verify_seams;
