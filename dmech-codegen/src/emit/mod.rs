//! Kernels → tokens: the traits of mechanics for the user's type.

mod author;
mod block;
mod body;
mod constants;
mod document;
mod function;
mod generics;
mod implementation;
mod invariant;
mod kernels;
mod marker;
mod middle;
mod names;
mod numbers;
mod operation;
mod pair;
mod pair_document;
mod pointwise;
mod printer;
mod rank;
mod region;
mod rotation;
mod shared_test;
mod stand_in;
mod step;
mod withheld;

pub(crate) use implementation::implementation;
pub(crate) use pair::pair_implementation;
pub(crate) use stand_in::stand_in;
pub(crate) use withheld::withheld;
