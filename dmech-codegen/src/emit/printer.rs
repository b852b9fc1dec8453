//! What all functions of an implementation share.

use dmech_symbolic::expression::Graph;
use dmech_symbolic::kernel::Variables;
use proc_macro2::{Ident, TokenStream};

use super::names::Names;
use crate::lower::{Parameter, Read};

/// How a function reaches what it reads of the law.
pub(super) enum Reached {
    /// By the law, which is this.
    Law(TokenStream),
    /// As numbers, in the order of the parameters: `self.law[2]`.
    Numbers,
}

/// Names, variables and ways to what is read.
pub(super) struct Printer<'a> {
    pub(super) graph: &'a Graph,
    pub(super) names: Names,
    pub(super) variables: &'a Variables,
    pub(super) parameters: &'a [Parameter],
    pub(super) scalar: Ident,
    /// The hidden module of the facade.
    pub(super) runtime: TokenStream,
    /// D, as it is to be printed.
    pub(super) dimension: TokenStream,
    /// The law is one between two bodies.
    pub(super) between: bool,
    /// What is read of a body, in order.
    pub(super) layout: &'a [Read],
    /// How a method of the implementation reaches what it reads of the law.
    pub(super) law: Reached,
}
