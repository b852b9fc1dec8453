//! The degree of an expression as a polynomial.

use crate::expression::{Expr, Graph, Node, Symbol};

/// A degree that the expression does not exceed as a polynomial in the symbols, each with a degree of its own; none where it is
/// not written as one.
///
/// What holds no symbol has degree 0: numbers, parameters, the time. It is read from the expression as it stands: terms that
/// cancel as they are built are gone, and the square of a root is what was below it, but nothing is expanded, so that
/// (x + 1)² − x² has degree 2, and r (r³ + r) with r = √s none. A choice is none either, whatever its branches are.
pub fn degree(graph: &Graph, e: Expr, symbols: &[(Symbol, u32)]) -> Option<u32> {
    let mut degrees = vec![Some(0); e.index() + 1];
    for node in graph.reachable(&[e]) {
        degrees[node.index()] = of_node(graph, node, symbols, &degrees);
    }
    degrees[e.index()]
}

/// The same of one node, with those of its children; 0 just where it holds no symbol.
fn of_node(graph: &Graph, e: Expr, symbols: &[(Symbol, u32)], degrees: &[Option<u32>]) -> Option<u32> {
    let of = |e: Expr| degrees[e.index()];
    match graph.node(e) {
        Node::Number(_) => Some(0),
        Node::Symbol(symbol) => {
            Some(symbols.iter().find(|(known, _)| known == symbol).map_or(0, |&(_, degree)| degree))
        }
        Node::Sum { terms, .. } => terms.iter().try_fold(0, |most, &(_, term)| Some(most.max(of(term)?))),
        Node::Product { factors, .. } => factors.iter().try_fold(0_u32, |sum, &(factor, n)| match of(factor)? {
            0 => Some(sum),
            degree => sum.checked_add(degree.checked_mul(u32::try_from(n).ok()?)?),
        }),
        Node::Unary(..) | Node::Binary(..) | Node::Select(..) => {
            graph.children(e).into_iter().all(|child| of(child) == Some(0)).then_some(0)
        }
    }
}
