//! The interpreter of expressions: the oracle that everything else is held against.

use dmech_scalar::Real;

use super::{Expr, Graph, Node, Symbol};

/// The value of one expression, given those of the symbols.
pub fn evaluate<R: Real>(graph: &Graph, e: Expr, symbol: impl Fn(Symbol) -> R) -> R {
    evaluate_all(graph, &[e], symbol)[0]
}

/// The values of several expressions.
pub fn evaluate_all<R: Real>(graph: &Graph, roots: &[Expr], symbol: impl Fn(Symbol) -> R) -> Vec<R> {
    let mut values = vec![R::ZERO; graph.len()];
    for e in graph.reachable(roots) {
        let value = |c: Expr| values[c.index()];
        values[e.index()] = match graph.node(e) {
            Node::Number(n) => n.of(),
            Node::Symbol(s) => symbol(*s),
            Node::Sum { constant, terms } => {
                terms.iter().fold(R::from_f64(constant.value()), |sum, &(c, t)| sum + R::from_f64(c.value()) * value(t))
            }
            Node::Product { coefficient, factors } => {
                factors.iter().fold(R::from_f64(coefficient.value()), |product, &(f, n)| match n {
                    ..0 => product / value(f).powi(-n),
                    _ => product * value(f).powi(n),
                })
            }
            Node::Unary(f, u) => f.apply(value(*u)),
            Node::Binary(f, u, w) => f.apply(value(*u), value(*w)),
            Node::Select(condition, yes, no) => R::select(condition.mask(&value), || value(*yes), || value(*no)),
        };
    }
    roots.iter().map(|r| values[r.index()]).collect()
}
