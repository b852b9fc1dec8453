//! Reading a product as a power.

use super::{Expr, Graph, Node, Number, Unary};

impl Graph {
    /// Splits a product into its coefficient and its factors; anything else is its own only factor.
    pub(crate) fn factors(&self, e: Expr) -> (Number, Vec<(Expr, i32)>) {
        match self.node(e) {
            Node::Product { coefficient, factors } => (*coefficient, factors.to_vec()),
            _ => (Number::ONE, vec![(e, 1)]),
        }
    }

    /// The root and what is below it, if fⁿ is a power of a root with an exponent above 1: it and its slope vanish with
    /// what is below.
    pub(crate) fn vanishing_root(&self, f: Expr, n: i32) -> Option<(Unary, Expr)> {
        let degree = |root| if root == Unary::Sqrt { 2 } else { 3 };
        self.root(f).filter(|&(root, _)| n > degree(root))
    }

    /// The root and what is below it.
    pub(crate) fn root(&self, f: Expr) -> Option<(Unary, Expr)> {
        match *self.node(f) {
            Node::Unary(root @ (Unary::Sqrt | Unary::Cbrt), u) => Some((root, u)),
            _ => None,
        }
    }
}
