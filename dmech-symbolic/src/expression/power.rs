//! Reading a product as a power.

use super::{Expr, Graph, Node, Number};

impl Graph {
    /// Splits a product into its coefficient and its factors; anything else is its own only factor.
    pub(crate) fn factors(&self, e: Expr) -> (Number, Vec<(Expr, i32)>) {
        match self.node(e) {
            Node::Product { coefficient, factors } => (*coefficient, factors.to_vec()),
            _ => (Number::ONE, vec![(e, 1)]),
        }
    }
}
