//! Every scheme on every system: one law, a law with a mass for each coordinate, bodies in pairs, chains, bonds, fields.

mod adaptive;
mod chains;
mod matrix;
mod own;
mod same;
mod setups;
mod verified;
mod wrapped;
