//! What is 0 once it is multiplied out.

use crate::expression::{Condition, Expr, Graph, Node, Number, Substitution};

/// Whether an expression is seen to be 0, on either side of every choice in it.
pub(super) fn vanishes(graph: &mut Graph, e: Expr) -> bool {
    /// Conditions of one expression.
    const MOST: u32 = 6;
    vanishes_within(graph, e, MOST)
}

fn vanishes_within(graph: &mut Graph, e: Expr, conditions: u32) -> bool {
    let e = expand(graph, e);
    if graph.is_zero(e) {
        return true;
    }
    let inside = graph.reachable(&[e]);
    let Some(question) = inside.iter().find_map(|&e| Question::of(graph, e)) else { return false };
    conditions > 0
        && [true, false].into_iter().all(|answer| {
            let branches = inside.iter().filter_map(|&e| Some((e, question.branch(graph, e, answer)?)));
            let branch = Substitution::of_expressions(branches).apply(graph, e);
            vanishes_within(graph, branch, conditions - 1)
        })
}

/// What a choice asks.
enum Question {
    /// Whether this holds.
    Holds(Condition),
    /// Which of two is the smaller: `min` and `max` do not ask which comes first.
    Smaller([Expr; 2]),
}

impl Question {
    fn of(graph: &Graph, e: Expr) -> Option<Self> {
        match graph.node(e) {
            Node::Select(condition, ..) => Some(Self::Holds(condition.clone())),
            &Node::Binary(f, u, w) if f.is_extremum() => Some(Self::Smaller([u.min(w), u.max(w)])),
            _ => None,
        }
    }

    /// The side that a choice takes by the answer to this, if that is what it asks.
    fn branch(&self, graph: &Graph, e: Expr, answer: bool) -> Option<Expr> {
        match (self, graph.node(e)) {
            (Self::Holds(condition), Node::Select(asked, yes, no)) if asked == condition => {
                Some(if answer { *yes } else { *no })
            }
            (Self::Smaller(two), &Node::Binary(f, u, w)) if f.is_extremum() && [u.min(w), u.max(w)] == *two => {
                Some(two[usize::from(answer == f.is_least())])
            }
            _ => None,
        }
    }
}

/// a (b + c) = a b + a c, where a sum stands to the first power.
///
/// A product of many sums has more terms than anyone wants to store: past a bound it stays as it is, and the zero unseen.
fn expand(graph: &mut Graph, e: Expr) -> Expr {
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
