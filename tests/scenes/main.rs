//! Many bodies.

mod closed;
mod degree;
mod driven;
mod few;
mod magnetic;
mod optional;
mod own_laws;
mod pair_models;
mod restricted;
mod stops;
mod test_bodies;
