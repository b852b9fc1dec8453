//! Discrete gradients by reverse accumulation.
//!
//! The walk is that of reverse-mode differentiation; the local factor of a node is its divided difference in place of
//! its derivative. Because the secant identity holds at every node, Δnode = Σ factor·Δchild, it holds for the whole:
//! ∇̄Φ(a, b)·(b − a) = Φ(b) − Φ(a). Because every factor is symmetric in a and b, so is ∇̄Φ.
//!
//! A choice has the discrete gradients of its branches, in which there may be choices: this file and [`piecewise`] call each
//! other, as far down as choices are nested.

use std::rc::Rc;

use crate::expression::{Binary, Condition, Expr, Graph, Node, Number, Square, Substitution, Symbol};
use crate::hash::Map;

use super::centre::{Distance, by_the_square};
use super::divided_difference::{divided_difference, of_part_of_root, of_power, of_root};
use super::piecewise::{self, Placed};
use super::two_arguments::{of_angle, of_powf, one_sided, unless_vanishing};

/// The two ends of a step: what the coordinates become at each.
pub struct TwoPoints {
    /// The coordinates that the potential is written in.
    pub coordinates: Vec<Symbol>,
    /// Their names at the one end.
    pub a: Vec<Symbol>,
    /// Their names at the other.
    pub b: Vec<Symbol>,
    at_a: Substitution,
    at_b: Substitution,
    /// Choices that have been taken apart before.
    pub(super) choices: Map<Expr, Rc<Placed>>,
}

impl TwoPoints {
    /// Replaces coordinate i by aᵢ at the one end, by bᵢ at the other.
    pub fn new(graph: &mut Graph, coordinates: &[Symbol], a: &[Symbol], b: &[Symbol]) -> Self {
        let mut end = |names: &[Symbol]| {
            let pairs: Vec<_> = coordinates.iter().zip(names).map(|(&q, &name)| (q, graph.symbol(name))).collect();
            Substitution::new(graph, pairs)
        };
        let (at_a, at_b) = (end(a), end(b));
        let choices = Map::default();
        Self { coordinates: coordinates.to_vec(), a: a.to_vec(), b: b.to_vec(), at_a, at_b, choices }
    }

    /// The values of an expression at the two ends.
    pub fn values(&mut self, graph: &mut Graph, e: Expr) -> (Expr, Expr) {
        (self.at_a.apply(graph, e), self.at_b.apply(graph, e))
    }

    /// The mean of the two values.
    pub(super) fn mean(&mut self, graph: &mut Graph, e: Expr) -> Expr {
        let (a, b) = self.values(graph, e);
        graph.mean(a, b)
    }

    /// A condition at the two ends.
    pub(super) fn conditions(&mut self, graph: &mut Graph, condition: &Condition) -> (Condition, Condition) {
        (condition.map(&mut |e| self.at_a.apply(graph, e)), condition.map(&mut |e| self.at_b.apply(graph, e)))
    }
}

/// ∇̄e(a, b), one component for each coordinate.
pub fn discrete_gradient(graph: &mut Graph, e: Expr, ends: &mut TwoPoints) -> Vec<Expr> {
    let depends = graph.dependence(&ends.coordinates);
    let order = graph.reachable(&[e]);
    let mut arriving: Vec<Vec<Expr>> = vec![Vec::new(); depends.len()];
    let one = graph.one();
    arriving[e.index()].push(one);
    let mut found = vec![graph.zero(); ends.coordinates.len()];
    for &node in order.iter().rev() {
        if !depends[node.index()] {
            continue;
        }
        let summands = std::mem::take(&mut arriving[node.index()]);
        let adjoint = graph.add_fractions(&summands);
        if graph.is_zero(adjoint) {
            continue;
        }
        if let Node::Symbol(symbol) = graph.node(node) {
            if let Some(i) = ends.coordinates.iter().position(|s| s == symbol) {
                found[i] = adjoint;
            }
            continue;
        }
        if graph.choice(node).is_some() {
            for (i, share) in piecewise::shares(graph, node, adjoint, ends).into_iter().enumerate() {
                if !graph.is_zero(share) {
                    let coordinate = graph.symbol(ends.coordinates[i]);
                    arriving[coordinate.index()].push(share);
                }
            }
            continue;
        }
        let distance = Distance::of(graph, node);
        if let Some(Distance { below, .. }) = distance
            && let Some(share) = by_what_is_below(graph, node, adjoint, ends)
        {
            arriving[below.index()].push(share);
            continue;
        }
        let flat = distance.is_none() && graph.is_flat(adjoint, node);
        let of_root = if flat { of_flat_root(graph, node, adjoint, ends) } else { None };
        let factors = match of_root {
            Some(factor) => vec![factor],
            None => secants(graph, node, ends, &|c: Expr| depends[c.index()], flat),
        };
        for (child, secant) in factors {
            let share = graph.mul(&[adjoint, secant]);
            arriving[child.index()].push(share);
        }
    }
    found
}

/// The share of what is below a distance in the discrete gradient of what vanishes with the distance.
fn by_what_is_below(graph: &mut Graph, distance: Expr, adjoint: Expr, ends: &mut TwoPoints) -> Option<Expr> {
    let (a, b) = ends.values(graph, distance);
    let sum = graph.add(&[a, b]);
    if graph.has_factor(adjoint, sum) {
        return None;
    }
    let ends = [(a, Distance::of(graph, a)?), (b, Distance::of(graph, b)?)];
    by_the_square(graph, adjoint, &ends)
}

/// A root in what is of a higher order than the first; √a + √b may be among the factors that it comes times, and cancels.
fn of_flat_root(graph: &mut Graph, node: Expr, adjoint: Expr, ends: &mut TwoPoints) -> Option<(Expr, Expr)> {
    let root = graph.root(node).filter(|_| graph.own_order(node) > 0.0)?;
    let (a, b) = ends.values(graph, node);
    let sum = graph.add(&[a, b]);
    let (a, b) = ends.values(graph, root.below);
    (!graph.has_factor(adjoint, sum)).then(|| (root.below, of_part_of_root(graph, root.degree, a, b, 1)))
}

/// The moving children of a node, each with its factor in Δnode = Σ factor·Δchild.
fn secants(
    graph: &mut Graph,
    node: Expr,
    ends: &mut TwoPoints,
    moves: &dyn Fn(Expr) -> bool,
    flat: bool,
) -> Vec<(Expr, Expr)> {
    match graph.node(node).clone() {
        Node::Number(_) | Node::Symbol(_) | Node::Select(..) => Vec::new(),
        Node::Sum { terms, .. } => {
            let moving = terms.iter().filter(|(_, t)| moves(*t));
            moving.map(|&(c, t)| (t, graph.number(c.value()))).collect()
        }
        Node::Product { coefficient, factors } => {
            let (moving, fixed): (Vec<_>, Vec<_>) = factors.iter().copied().partition(|&(f, _)| moves(f));
            let fixed = graph.product_of(coefficient, fixed);
            of_product(graph, fixed, &moving, ends, flat)
        }
        Node::Unary(f, u) => {
            let (a, b) = ends.values(graph, u);
            let Some(even) = graph.even_of_root(node) else { return vec![(u, divided_difference(graph, f, a, b))] };
            // 2 sin m sin δ/(b² − a²) = sinc m sinc δ/2. Halves in the sums: the [tangent](super::tangent) of a root that vanishes
            // is then 0, as that of the whole is even in each root.
            let halves = [a, b].map(|root| graph.scale(0.5, root));
            let (middle, delta) = (graph.add(&halves), graph.sub(halves[1], halves[0]));
            let factors = [graph.unary(even.cardinal, middle), graph.unary(even.cardinal, delta)];
            let secant = graph.mul(&factors);
            let secant = graph.scale(even.half, secant);
            of_square(graph, secant, &even.square, ends, moves, flat)
        }
        Node::Binary(f, u, w) => {
            let both = of_binary(graph, f, (u, w), ends, moves, flat);
            both.into_iter().filter(|(c, _)| moves(*c)).collect()
        }
    }
}

/// u² toward what it is made of, each with its factor.
fn of_square(
    graph: &mut Graph,
    secant: Expr,
    square: &Square,
    ends: &mut TwoPoints,
    moves: &dyn Fn(Expr) -> bool,
    flat: bool,
) -> Vec<(Expr, Expr)> {
    let (moving, mut fixed): (Vec<_>, Vec<_>) = square.factors.iter().copied().partition(|&(f, _)| moves(f));
    fixed.extend([(secant, 1), (graph.number(square.coefficient.value()), 2)]);
    let outside = graph.product_of(Number::ONE, fixed);
    of_product(graph, outside, &moving, ends, flat)
}

/// u·w: mean(w) toward u, mean(u) toward w; longer products factor by factor.
fn of_product(
    graph: &mut Graph,
    fixed: Expr,
    moving: &[(Expr, i32)],
    ends: &mut TwoPoints,
    flat: bool,
) -> Vec<(Expr, Expr)> {
    let mut found = vec![];
    let mut outside = fixed;
    for (i, &(f, n)) in moving.iter().enumerate() {
        let as_part = flat && n > 0 && Distance::of(graph, f).is_none();
        let root = graph.root(f).filter(|root| n > root.degree || (n < root.degree && as_part));
        let target = root.map_or(f, |root| root.below);
        let (a, b) = ends.values(graph, target);
        let secant = match root {
            Some(root) if n > root.degree => of_root(graph, root.degree, a, b, n),
            Some(root) => of_part_of_root(graph, root.degree, a, b, n),
            None => of_power(graph, a, b, n),
        };
        let rest: Vec<_> = moving[i + 1..].iter().map(|&(f, n)| graph.powi(f, n)).collect();
        let rest = graph.mul(&rest);
        let mean_of_rest = ends.mean(graph, rest);
        found.push((target, graph.mul(&[outside, secant, mean_of_rest])));
        let power = graph.powi(f, n);
        let mean = ends.mean(graph, power);
        outside = graph.mul(&[outside, mean]);
    }
    found
}

fn of_binary(
    graph: &mut Graph,
    f: Binary,
    (u, w): (Expr, Expr),
    ends: &mut TwoPoints,
    moves: &dyn Fn(Expr) -> bool,
    flat: bool,
) -> Vec<(Expr, Expr)> {
    let ((ua, ub), (wa, wb)) = (ends.values(graph, u), ends.values(graph, w));
    let square = graph.square_without_root(u).filter(|_| f == Binary::Powf && !moves(w));
    if let Some(square) = square.filter(|_| one_sided(graph, u, moves)) {
        let toward_u = of_powf(graph, (u, ua, ub), (w, wa, wb), false)[0].1;
        let rises = Condition::less(graph.one(), wa);
        let secant = unless_vanishing(graph, toward_u, [ua, ub], rises);
        return of_square(graph, secant, &square, ends, moves, flat);
    }
    match f {
        Binary::Powf => of_powf(graph, (u, ua, ub), (w, wa, wb), moves(w)),
        Binary::Atan2 => of_angle(graph, (u, ua, ub), (w, wa, wb)),
        Binary::Min | Binary::Max | Binary::AtMost | Binary::AtLeast => unreachable!("choices are taken as a whole"),
    }
}
