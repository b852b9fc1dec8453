//! Products over sums, multiplied out.

use crate::expression::{Expr, Graph, Node, Number};

/// a (b + c) = a b + a c, where a sum stands to the first power; only to recognise a zero.
///
/// A product of many sums has more terms than anyone wants to store: past a bound it stays as it is, and the zero unseen.
pub(super) fn expand(graph: &mut Graph, e: Expr) -> Expr {
    const MOST: usize = 1 << 14;
    let bound = graph.len() + MOST;
    expand_below(graph, e, bound)
}

fn expand_below(graph: &mut Graph, e: Expr, bound: usize) -> Expr {
    const LARGEST: usize = 4096;
    if graph.len() > bound {
        return e;
    }
    match graph.node(e).clone() {
        Node::Sum { constant, terms } => {
            let mut summands = vec![graph.number(constant.value())];
            for &(c, t) in &terms {
                let t = expand_below(graph, t, bound);
                summands.push(graph.scale(c.value(), t));
            }
            graph.add(&summands)
        }
        Node::Product { coefficient, factors } => {
            let sum = factors.iter().position(|&(f, n)| n == 1 && matches!(graph.node(f), Node::Sum { .. }));
            let Some(i) = sum else { return e };
            let Node::Sum { constant, terms } = graph.node(factors[i].0).clone() else { return e };
            if terms.len() * factors.len() > LARGEST {
                return e;
            }
            let mut rest = factors.to_vec();
            rest.remove(i);
            let rest = graph.product_of(coefficient, rest);
            let one = graph.one();
            let parts: Vec<_> = terms
                .iter()
                .copied()
                .chain([(constant, one)])
                .filter(|(c, _)| *c != Number::ZERO)
                .map(|(c, t)| {
                    let product = graph.mul(&[t, rest]);
                    let product = graph.scale(c.value(), product);
                    expand_below(graph, product, bound)
                })
                .collect();
            graph.add(&parts)
        }
        _ => e,
    }
}
