//! Roots in what is of an order above the first only as a whole: in eʳ − r − 1 the distance r has a slope of 0 where it vanishes.
//!
//! What its slope comes to there is a derivative again: this file and [`derivative`](super::derivative) call each other, as far down as
//! roots are nested.

use crate::expression::{Binary, Expr, Graph, Node, Number, Substitution, Unary};
use crate::hash::Map;

use super::derivative::derivative;

/// What is below a square root that vanishes to the first order or above.
pub(super) fn distance_below(graph: &Graph, root: Expr) -> Option<Expr> {
    let below = graph.root(root).filter(|root| root.degree == 2)?.below;
    (graph.own_order(root) >= 1.0).then_some(below)
}

/// A′(0)/2 of a slope or secant A in which a root stands, at each of its ends, if A is seen to vanish where all of them do; 0 where A has
/// no such derivative.
pub(super) fn limit(graph: &mut Graph, slope: Expr, ends: &[(Expr, Expr)]) -> Option<Expr> {
    let zero = graph.zero();
    let mut centre = Substitution::default();
    for &(root, below) in ends {
        let opposite = graph.neg(below);
        [root, below, opposite].into_iter().for_each(|vanishing| centre.remember(vanishing, zero));
        for (coordinate, place) in place(graph, below) {
            centre.remember(coordinate, place);
        }
    }
    if value(graph, slope, &mut centre).is_none_or(|there| !graph.is_zero(there)) {
        return None;
    }
    let symbol = graph.coordinate("r");
    let r = graph.symbol(symbol);
    let along = Substitution::of_expressions(ends.iter().map(|&(root, _)| (root, r))).apply(graph, slope);
    let rise = derivative(graph, along, symbol);
    let rise = value(graph, rise, &mut Substitution::of_expressions([(r, zero)]));
    Some(rise.map_or(zero, |rise| graph.scale(0.5, rise)))
}

/// An expression after a replacement, if it does not divide by the number 0 then: 0·∞ would be taken for 0.
pub(super) fn value(graph: &mut Graph, e: Expr, replacement: &mut Substitution) -> Option<Expr> {
    let image = replacement.apply(graph, e);
    let (mut seen, mut open) = (Map::default(), vec![e]);
    while let Some(e) = open.pop() {
        if seen.insert(e, ()).is_some() {
            continue;
        }
        let node = graph.node(e).clone();
        let mut is_zero = |u: Expr| {
            let image = replacement.apply(graph, u);
            graph.is_zero(image)
        };
        let has_pole = match &node {
            Node::Product { factors, .. } => factors.iter().any(|&(f, n)| n < 0 && is_zero(f)),
            Node::Unary(Unary::Ln | Unary::Log2 | Unary::Log10, u) | Node::Binary(Binary::Powf, u, _) => is_zero(*u),
            _ => false,
        };
        if has_pole {
            return None;
        }
        match node {
            Node::Select(_, yes, no) => {
                let [taken, first, second] = [e, yes, no].map(|e| replacement.apply(graph, e));
                open.extend(
                    [(yes, second), (no, first)]
                        .map(|(branch, other)| (taken != other || first == second).then_some(branch))
                        .into_iter()
                        .flatten(),
                );
            }
            _ => open.extend(graph.children(e)),
        }
    }
    Some(image)
}

/// Where a sum of squares vanishes: at 0 in a coordinate that is squared by itself, at c in one that x − c is squared of.
fn place(graph: &mut Graph, squares: Expr) -> Vec<(Expr, Expr)> {
    let Node::Sum { constant: Number::ZERO, terms } = graph.node(squares).clone() else { return vec![] };
    let mut found = vec![];
    for (c, term) in terms {
        let base = match graph.node(term) {
            Node::Product { factors, .. } if c.value() > 0.0 => match factors[..] {
                [(base, n)] if n > 0 && n % 2 == 0 => base,
                _ => return vec![],
            },
            _ => return vec![],
        };
        let at = match graph.node(base).clone() {
            Node::Symbol(_) => Some((base, graph.zero())),
            Node::Sum { terms, .. } => terms.iter().find(|&&(_, term)| graph.is_coordinate(term)).map(|&(c, term)| {
                let moving = graph.scale(c.value(), term);
                let rest = graph.sub(base, moving);
                (term, graph.scale(-c.value().recip(), rest))
            }),
            _ => None,
        };
        found.extend(at);
    }
    found
}
