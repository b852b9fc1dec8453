//! Discrete gradients by reverse accumulation.
//!
//! The walk is that of reverse-mode differentiation; the local factor of a node is its divided difference in place of
//! its derivative. Because the secant identity holds at every node, Δnode = Σ factor·Δchild, it holds for the whole:
//! ∇̄Φ(a, b)·(b − a) = Φ(b) − Φ(a). Because every factor is symmetric in a and b, so is ∇̄Φ.
//!
//! A choice has the discrete gradients of its branches, in which there may be choices: this file and [`piecewise`] call each
//! other, as far down as choices are nested.

use std::rc::Rc;

use crate::expression::{Binary, Condition, Expr, Graph, Node, Number, Square, Substitution, Symbol, Unary};
use crate::hash::Map;

use super::divided_difference::{divided_difference, of_exponential, of_logarithm, of_part_of_root, of_power, of_root};
use super::piecewise::{self, Placed, or_zero};

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
        let adjoint = graph.add(&summands);
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
        let flat = graph.order(adjoint) + graph.order(node) > 1.0;
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

/// A root in what is of a higher order than the first; √a + √b may be among the factors that it comes times, and cancels.
fn of_flat_root(graph: &mut Graph, node: Expr, adjoint: Expr, ends: &mut TwoPoints) -> Option<(Expr, Expr)> {
    let root = graph.root(node).filter(|_| graph.order(node) > 0.0)?;
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
        let root = graph.root(f).filter(|root| n > root.degree || (0 < n && n < root.degree && flat));
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
        Binary::Atan2 => {
            // With the point (w, u): Δangle = K (mean(w) Δu − mean(u) Δw), K = Δangle/cross. Below 45° the angle between the
            // two points serves; above it, and where the segment crosses the cut, the difference of their angles, which
            // does not cancel there.
            let products = [graph.mul(&[wa, ub]), graph.mul(&[ua, wb]), graph.mul(&[wa, wb]), graph.mul(&[ua, ub])];
            let cross = graph.sub(products[0], products[1]);
            let dot = graph.add(&products[2..]);
            let t = graph.div(cross, dot);
            let cardinal = graph.unary(Unary::Atanc, t);
            let acute = graph.div(cardinal, dot);
            let angles = [graph.binary(f, ua, wa), graph.binary(f, ub, wb)];
            let turn = graph.sub(angles[1], angles[0]);
            let other = graph.div(turn, cross);
            let (width, swing) = (graph.unary(Unary::Abs, cross), graph.unary(Unary::Abs, turn));
            let half_turn = graph.number(std::f64::consts::PI);
            let near = Condition::less_or_equal(width, dot).and(Condition::less_or_equal(swing, half_turn));
            let k = graph.select(near, acute, other);
            // From or to the origin, where no angle is, along the way.
            let gaps = [graph.sub(ub, ua), graph.sub(wb, wa)];
            let squares = gaps.map(|gap| graph.square(gap));
            let (zero, length2) = (graph.zero(), graph.add(&squares));
            let origin = Condition::equal(width, zero).and(Condition::equal(dot, zero));
            let k = graph.select(origin.clone(), zero, k);
            let along = gaps.map(|gap| {
                let rise = graph.mul(&[turn, gap]);
                let along = or_zero(graph, rise, length2);
                graph.select(origin.clone(), along, zero)
            });
            let (mean_u, mean_w) = (graph.mean(ua, ub), graph.mean(wa, wb));
            let toward_w = graph.mul(&[mean_u, k]);
            vec![(u, graph.mul(&[mean_w, k])), (w, graph.neg(toward_w)), (u, along[0]), (w, along[1])]
        }
        Binary::Min | Binary::Max => unreachable!("choices are taken as a whole"),
    }
}

/// Whether u, with a root in it, stays on one side of 0: what moves in it are roots.
fn one_sided(graph: &Graph, u: Expr, moves: &dyn Fn(Expr) -> bool) -> bool {
    let (_, factors) = graph.factors(u);
    let is_root = |f: Expr| matches!(graph.node(f), Node::Unary(Unary::Sqrt, _));
    factors.iter().all(|&(f, _)| !moves(f) || is_root(f))
}

/// A secant toward u as one toward u², with (u²)[a, b] = a + b; between 0 and 0 it is 0 where the whole
/// rises faster than u.
fn unless_vanishing(graph: &mut Graph, toward_u: Expr, [a, b]: [Expr; 2], rises: Condition) -> Expr {
    // Halves, as in even functions of a root.
    let halves = [a, b].map(|u| graph.scale(0.5, u));
    let (zero, middle) = (graph.zero(), graph.add(&halves));
    let secant = graph.div(toward_u, middle);
    let secant = graph.scale(0.5, secant);
    // Its derivative divides by the square.
    let square = graph.square(middle);
    let vanishes = Condition::lost(graph, square).and(rises);
    graph.select(vanishes, zero, secant)
}

/// u^w = exp(w ln u): with δ = (w_b ln u_b − w_a ln u_a)/2 the factor of exp is √(u_a^w_a u_b^w_b) sinhc δ. The powers
/// are taken as powers, because exp(w ln u) would be |w ln u| times less accurate.
fn of_powf(
    graph: &mut Graph,
    (u, ua, ub): (Expr, Expr, Expr),
    (w, wa, wb): (Expr, Expr, Expr),
    exponent_moves: bool,
) -> Vec<(Expr, Expr)> {
    if exponent_moves {
        let ln = of_logarithm(graph, ua, ub);
        let (ln_a, ln_b) = (graph.unary(Unary::Ln, ua), graph.unary(Unary::Ln, ub));
        let (half_a, half_b) = (graph.scale(0.5, wa), graph.scale(0.5, wb));
        let (log_a, log_b) = (graph.mul(&[half_a, ln_a]), graph.mul(&[half_b, ln_b]));
        let delta = graph.sub(log_b, log_a);
        let roots = [graph.binary(Binary::Powf, ua, half_a), graph.binary(Binary::Powf, ub, half_b)];
        let middle = graph.mul(&roots);
        let values = [graph.binary(Binary::Powf, ua, wa), graph.binary(Binary::Powf, ub, wb)];
        let exp = of_exponential(graph, middle, delta, values);
        let (mean_w, mean_ln) = (graph.mean(wa, wb), graph.mean(ln_a, ln_b));
        return vec![(u, graph.mul(&[exp, mean_w, ln])), (w, graph.mul(&[exp, mean_ln]))];
    }
    // An exponent that is not known may be an integer, and u on either side of 0: then by the sizes |u|.
    let known = graph.as_number(wa).is_some();
    let (one, sum) = (graph.one(), graph.add(&[ua, ub]));
    let side = if known { one } else { graph.unary(Unary::Signum, sum) };
    let sizes = [ua, ub].map(|u| if known { u } else { graph.unary(Unary::Abs, u) });
    let ln = of_logarithm(graph, sizes[0], sizes[1]);
    let growth = graph.sub(sizes[1], sizes[0]);
    let log_ratio = graph.mul(&[wa, ln, growth]);
    let delta = graph.scale(0.5, log_ratio);
    let roots = sizes.map(|size| graph.unary(Unary::Sqrt, size));
    let middle = graph.mul(&[side, roots[0], roots[1]]);
    let (power, cardinal) = (graph.binary(Binary::Powf, middle, wa), graph.unary(Unary::Sinhc, delta));
    let closed = graph.mul(&[side, power, wa, ln, cardinal]);
    let gap = graph.sub(ub, ua);
    // Far apart the powers do not cancel; and at u = 0 the logarithm is not finite but the power may be.
    let (value_a, value_b) = (graph.binary(Binary::Powf, ua, wa), graph.binary(Binary::Powf, ub, wb));
    let rise = graph.sub(value_b, value_a);
    // Halves, as in even functions of a root.
    let halves = [ua, ub].map(|u| graph.scale(0.5, u));
    let half_gap = graph.sub(halves[1], halves[0]);
    let quotient = graph.div(rise, half_gap);
    let quotient = graph.scale(0.5, quotient);
    let lowered = graph.sub(wa, one);
    // At each end by itself: their mean may be rounded to below 0. With derivative 0 where that of the limit is infinite.
    // It is 0 where the whole is of an order above 1, as that of the [gradient](super::gradient) is.
    let order = graph.order(u);
    let (zero, least) = (graph.zero(), graph.number(if order > 0.0 { order.recip() - 1.0 } else { 0.0 }));
    let limits = [ua, ub].map(|u| {
        let vanishes = Condition::equal(u, zero).and(Condition::less(least, lowered));
        let power = graph.binary(Binary::Powf, u, lowered);
        graph.select(vanishes, zero, power)
    });
    let limit = graph.mean(limits[0], limits[1]);
    let limit = graph.mul(&[wa, limit]);
    // The derivative of the quotient divides by the square of the gap.
    let square = graph.square(gap);
    let at_one = Condition::lost(graph, square);
    let far = graph.select(at_one, limit, quotient);
    // That of the closed form divides by the fourth power of the sum.
    let (distance, product) = (graph.unary(Unary::Abs, delta), graph.mul(&[ua, ub]));
    // The square of the product, below 0 where the ends lie on two sides.
    let size = graph.unary(Unary::Abs, product);
    let (square, least) = (graph.mul(&[product, size]), graph.number(Number::LEAST.value()));
    let near = Condition::less(least, square).and(Condition::less_or_equal(distance, one));
    vec![(u, graph.select(near, closed, far))]
}
