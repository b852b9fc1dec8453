//! Ensembles: every member is, to the bit, what it is alone.

mod as_alone;
mod company;
mod each;
mod edges;
mod laws;
mod occupancy;
mod optional;
mod output;
mod ranks;
mod same;
mod scalars;
mod store;
mod work;
