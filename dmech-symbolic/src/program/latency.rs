//! When a value can be ready, in cycles of a recent processor: enough to put the slow operand last.

use crate::expression::{Expr, Graph, Node, Unary};

pub(super) const ADD: u32 = 4;
pub(super) const MUL: u32 = 4;
pub(super) const DIV: u32 = 13;
const SQRT: u32 = 21;
const FUNCTION: u32 = 50;

/// The earliest time at which each of the expressions, children before parents, is known, symbols being known at 0.
pub(super) fn ready(graph: &Graph, order: &[Expr]) -> Vec<u32> {
    let mut ready = vec![0; graph.len()];
    for &e in order {
        let of = |c: &Expr| ready[c.index()];
        ready[e.index()] = match graph.node(e) {
            Node::Number(_) | Node::Symbol(_) => 0,
            Node::Sum { terms, .. } => ADD + terms.iter().map(|(_, t)| of(t)).max().unwrap_or(0),
            Node::Product { factors, .. } => factors.iter().map(|(f, n)| power(of(f), *n)).max().unwrap_or(0) + MUL,
            Node::Unary(Unary::Sqrt, u) => of(u) + SQRT,
            Node::Unary(Unary::Abs | Unary::Signum, u) => of(u) + 1,
            Node::Unary(Unary::Round | Unary::Floor | Unary::Trunc, u) => of(u) + 2 * ADD,
            Node::Unary(_, u) => of(u) + FUNCTION,
            Node::Binary(_, u, w) => of(u).max(of(w)) + FUNCTION,
            Node::Select(_, yes, no) => of(yes).max(of(no)) + ADD,
        };
    }
    ready
}

/// When baseⁿ is known.
pub(super) fn power(base: u32, n: i32) -> u32 {
    let squarings = MUL * (31 - (n.unsigned_abs().max(1)).leading_zeros());
    base + squarings + if n < 0 { DIV } else { 0 }
}
