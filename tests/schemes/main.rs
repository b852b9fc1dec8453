//! What every scheme promises, over laws.

mod adaptive;
mod allocation;
mod at_rest;
mod bodies;
mod compensated;
mod composed;
mod continued;
mod double_double;
mod hills;
mod hills_beside;
mod order;
mod published;
mod quadratic;
mod relaxed;
mod runge_kutta_nystrom;
mod splittings;
mod walls;
