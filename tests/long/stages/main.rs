//! Gauss's method and line integrals: eight stages of a step side by side.

mod edges;
mod energies;
mod laws;
mod orders;
mod published;
mod rounding;
mod runs;
mod scenes;
mod symplectic;
