//! Discrete gradients across the seam of a piecewise expression.
//!
//! Where both ends lie in one branch, that branch's own form; otherwise a form that still satisfies the secant
//! identity exactly: if everything depends on the coordinates through one inner expression u (a distance, a
//! coordinate), the plain quotient in u, which keeps central laws central; else Gonzalez' correction of the gradient at
//! the midpoint (J. Nonlinear Sci. 6 (1996) 449).

use crate::expression::{Condition, Expr, Graph, Node, Substitution};

use super::derivative::gradient;
use super::discrete_gradient::{TwoPoints, discrete_gradient};

/// The coordinates, each with its factor in Δ{yes if condition, else no}.
pub(super) fn secants(
    graph: &mut Graph,
    condition: &Condition,
    yes: Expr,
    no: Expr,
    ends: &mut TwoPoints,
) -> Vec<(Expr, Expr)> {
    let in_yes = discrete_gradient(graph, yes, ends);
    let in_no = discrete_gradient(graph, no, ends);
    let whole = graph.select(condition.clone(), yes, no);
    let (at_a, at_b) = ends.conditions(graph, condition);
    let across = if at_a == at_b { in_no.clone() } else { across(graph, condition, whole, ends) };
    let coordinates = ends.coordinates.clone();
    let mut found = vec![];
    for (i, &coordinate) in coordinates.iter().enumerate() {
        let neither = at_a.clone().or(at_b.clone());
        let not_both_yes = graph.select(neither, across[i], in_no[i]);
        let secant = graph.select(at_a.clone().and(at_b.clone()), in_yes[i], not_both_yes);
        found.push((graph.symbol(coordinate), secant));
    }
    found
}

/// A discrete gradient for ends on different sides of the seam.
fn across(graph: &mut Graph, condition: &Condition, whole: Expr, ends: &mut TwoPoints) -> Vec<Expr> {
    let (value_a, value_b) = ends.values(graph, whole);
    let rise = graph.sub(value_b, value_a);
    if let Some(gateway) = gateway(graph, condition, whole, ends) {
        let (u_a, u_b) = ends.values(graph, gateway);
        let run = graph.sub(u_b, u_a);
        let quotient = graph.div(rise, run);
        let toward_u = discrete_gradient(graph, gateway, ends);
        return toward_u.into_iter().map(|secant| graph.mul(&[quotient, secant])).collect();
    }
    let (a, b): (Vec<_>, Vec<_>) =
        (ends.a.iter().map(|&s| graph.symbol(s)).collect(), ends.b.iter().map(|&s| graph.symbol(s)).collect());
    let midpoint: Vec<_> = a.iter().zip(&b).map(|(&a, &b)| graph.mean(a, b)).collect();
    let gap: Vec<_> = a.iter().zip(&b).map(|(&a, &b)| graph.sub(b, a)).collect();
    let mut at_midpoint = Substitution::new(graph, ends.coordinates.iter().copied().zip(midpoint));
    let slopes: Vec<_> =
        gradient(graph, whole, &ends.coordinates).into_iter().map(|slope| at_midpoint.apply(graph, slope)).collect();
    let along: Vec<_> = slopes.iter().zip(&gap).map(|(&s, &d)| graph.mul(&[s, d])).collect();
    let along = graph.add(&along);
    let squares: Vec<_> = gap.iter().map(|&d| graph.square(d)).collect();
    let length2 = graph.add(&squares);
    let missing = graph.sub(rise, along);
    let missing = graph.div(missing, length2);
    slopes
        .iter()
        .zip(&gap)
        .map(|(&slope, &d)| {
            let correction = graph.mul(&[missing, d]);
            graph.add(&[slope, correction])
        })
        .collect()
}

/// The outermost inner expression through which condition and value depend on the coordinates.
fn gateway(graph: &Graph, condition: &Condition, whole: Expr, ends: &TwoPoints) -> Option<Expr> {
    let moves = graph.dependence(&ends.coordinates);
    let operands = condition.operands();
    let inner = graph.reachable(&[whole]);
    let candidates = inner.iter().rev().filter(|c| **c != whole && moves[c.index()]);
    candidates.copied().find(|&candidate| {
        let roots = operands.iter().copied().chain(graph.children(whole));
        roots.into_iter().all(|root| only_through(graph, root, candidate, &moves))
    })
}

/// Whether every way from the root to a coordinate passes the candidate.
fn only_through(graph: &Graph, root: Expr, candidate: Expr, moves: &[bool]) -> bool {
    let mut stack = vec![root];
    let mut seen = vec![false; graph.len()];
    while let Some(e) = stack.pop() {
        if e == candidate || !moves[e.index()] || std::mem::replace(&mut seen[e.index()], true) {
            continue;
        }
        if matches!(graph.node(e), Node::Symbol(_)) {
            return false;
        }
        stack.extend(graph.children(e));
    }
    true
}
