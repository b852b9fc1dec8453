//! What lowering hands to the engine and to the printer.

use dmech_symbolic::expression::{Expr, Graph, Symbol};
use dmech_symbolic::kernel::{PairVariables, Variables};
use proc_macro2::TokenStream;

use crate::model::Body;

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
    /// What the law says it keeps, in `variables.q` and `variables.v`.
    pub invariants: Vec<Expr>,
    /// What else these read, in order of first use.
    pub parameters: Vec<Parameter>,
    /// What only a law between two bodies has.
    pub pair: Option<LoweredPair>,
}

/// A law between two bodies, beside its expressions.
pub struct LoweredPair {
    /// Velocities, squared distances.
    pub variables: PairVariables,
    /// What is read of a body, in order: the same for a and b.
    pub layout: Vec<Read>,
    /// What is read of a, each with the same of b.
    pub exchange: Vec<(Symbol, Symbol)>,
}

/// Something that the potential reads beside the position.
pub struct Parameter {
    /// Its symbol in the graph, named as it is to be shown (`gm`, `k_0`, `m`).
    pub symbol: Symbol,
    /// The same, also where something else has that name in the graph.
    pub name: String,
    /// Where its value comes from.
    pub source: Source,
}

/// Where the value of a parameter comes from.
pub enum Source {
    /// An `f64` of the law: `self.gm`, `self.k[2]`, `Self::G`, with the user's spans.
    Law(TokenStream),
    /// A number of one of two bodies.
    Body(Body, Read),
    /// The mass of the particle, the argument `m`.
    Mass,
    /// The time, the argument `t`.
    Time,
}

/// What is read of a body.
#[derive(Clone)]
pub enum Read {
    /// Its mass, the argument `ma` or `mb`.
    Mass,
    /// A number of its data, `data.q`, with the user's spans.
    Data(TokenStream),
}

impl Read {
    /// Whether both are the same number of a body.
    pub fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Mass, Self::Mass) => true,
            (Self::Data(one), Self::Data(two)) => one.to_string() == two.to_string(),
            _ => false,
        }
    }
}
