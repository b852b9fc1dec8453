//! Kernels → tokens: the implementation of `Potential` for the user's type.

mod author;
mod body;
mod document;
mod implementation;
mod kernels;
mod middle;
mod names;
mod operation;
mod pair;
mod pair_document;
mod region;
mod withheld;

pub(crate) use implementation::{implementation, stub};
pub(crate) use pair::{pair_implementation, pair_stub};
pub(crate) use withheld::withheld;
