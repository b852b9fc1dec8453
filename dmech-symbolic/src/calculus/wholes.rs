//! Choices by a distance that stand beside functions of it: (1 − r)₊⁴ (1 + 4 r) has a slope of 0 where r vanishes, and neither of its
//! factors has one. The choice is put around the whole, whose branches have it.

use crate::expression::{Expr, Graph, Node, Number, Substitution, Symbol, Variable};

use super::centre::{Distance, value};
use super::derivative::derivative;

/// The expression with choices around wholes that are smooth at a centre where the choices are not.
pub fn with_whole_choices(graph: &mut Graph, e: Expr) -> Expr {
    let mut wholes = Substitution::default();
    for node in graph.reachable(&[e]) {
        if let Some(whole) = whole(graph, node) {
            let whole = wholes.apply(graph, whole);
            wholes.remember(node, whole);
        }
    }
    wholes.apply(graph, e)
}

fn whole(graph: &mut Graph, product: Expr) -> Option<Expr> {
    let Node::Product { coefficient, factors } = graph.node(product).clone() else { return None };
    let mut chosen = factors.iter().filter_map(|&(f, n)| Some((f, n, graph.choice(f)?)));
    let (Some((own, n, choice)), None) = (chosen.next(), chosen.next()) else { return None };
    let (root, distance) = only_distance(graph, own)?;
    let of_distance = |graph: &Graph, f: Expr| graph.reachable(&[f]).contains(&root);
    let others = factors.iter().copied().filter(|&(f, _)| f != own);
    let (beside, mut outside): (Vec<_>, Vec<_>) = others.partition(|&(f, _)| of_distance(graph, f));
    if beside.is_empty() {
        return None;
    }
    let alone = [choice.yes, choice.no].map(|branch| graph.powi(branch, n));
    let together = alone.map(|branch| graph.product_of(Number::ONE, [vec![(branch, 1)], beside.clone()].concat()));
    let symbol = graph.coordinate("r");
    let r = graph.symbol(symbol);
    let square = graph.square(r);
    let mut along = Substitution::of_expressions([(root, r), (distance.below, square)]);
    let mut are_flat = |branches: [Expr; 2]| branches.iter().all(|&branch| is_flat(graph, branch, symbol, &mut along));
    if are_flat(alone) || !are_flat(together) {
        return None;
    }
    outside.push((graph.select(choice.condition, together[0], together[1]), 1));
    Some(graph.product_of(coefficient, outside))
}

/// The distance that an expression is made of, if it is one.
fn only_distance(graph: &mut Graph, e: Expr) -> Option<(Expr, Distance)> {
    let below = graph.reachable(&[e]);
    let mut distances = below.into_iter().filter_map(|u| Some((u, Distance::of(graph, u)?)));
    distances.next().filter(|_| distances.next().is_none())
}

/// Whether a function of a distance alone has a slope of 0 where that vanishes.
fn is_flat(graph: &mut Graph, e: Expr, symbol: Symbol, along: &mut Substitution) -> bool {
    let e = along.apply(graph, e);
    let moves = |e: Expr| match graph.node(e) {
        Node::Symbol(other) => *other != symbol && graph.variable(*other) != Variable::Parameter,
        _ => false,
    };
    if graph.reachable(&[e]).into_iter().any(moves) {
        return false;
    }
    let slope = derivative(graph, e, symbol);
    let centre = (graph.symbol(symbol), graph.zero());
    let there = value(graph, slope, &mut Substitution::of_expressions([centre]));
    there.is_some_and(|there| graph.is_zero(there))
}
