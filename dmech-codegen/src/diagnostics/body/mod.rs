//! About the body of a potential: what it cannot contain, and what to write instead.

mod flow;
mod helpers;
mod names;
mod numbers;
mod sequences;
mod vectors;

pub(crate) use flow::*;
pub(crate) use helpers::*;
pub(crate) use names::*;
pub(crate) use numbers::*;
pub(crate) use sequences::*;
pub(crate) use vectors::*;
