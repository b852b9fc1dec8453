//! Ensembles: every member is, to the bit, what it is alone.

mod as_alone;
mod edges;
mod laws;
mod output;
mod store;
