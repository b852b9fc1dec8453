//! What lowering hands to the engine and to the printer.

use dmech_symbolic::expression::{Expr, Graph, Symbol};
use dmech_symbolic::kernel::Variables;
use proc_macro2::TokenStream;

/// A law as expressions.
pub struct Lowered {
    /// The store of the expressions.
    pub graph: Graph,
    /// Position, velocity, ends of a step …
    pub variables: Variables,
    /// Φ in `variables.q`; 0 where the law is a force and nothing else.
    pub potential: Expr,
    /// F in `variables.q` and `variables.v`.
    pub force: Option<Vec<Expr>>,
    /// What else the potential reads, in order of first use.
    pub parameters: Vec<Parameter>,
}

/// Something that the potential reads beside the position.
pub struct Parameter {
    /// Its symbol in the graph, named as it is to be shown (`gm`, `k_0`, `m`).
    pub symbol: Symbol,
    /// Where its value comes from.
    pub source: Source,
}

/// Where the value of a parameter comes from.
pub enum Source {
    /// An `f64` of the law: `self.gm`, `self.k[2]`, `Self::G`, with the user's spans.
    Law(TokenStream),
    /// The mass of the particle, the argument `m`.
    Mass,
    /// The time, the argument `t`.
    Time,
}
