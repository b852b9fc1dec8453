//! Secants of functions of two arguments: powers and angles.

use crate::expression::{Binary, Condition, Expr, Graph, Node, Number, Unary};

use super::divided_difference::{of_exponential, of_logarithm, or_zero};

/// Two points are opposite to each other where the sine of what is between them is no more than this part of the cosine.
const STRAIGHT: f64 = 1.0 / (1_u64 << 40) as f64;

/// The angle of the point (w, u), with its values at the ends.
pub(super) fn of_angle(
    graph: &mut Graph,
    (u, ua, ub): (Expr, Expr, Expr),
    (w, wa, wb): (Expr, Expr, Expr),
) -> Vec<(Expr, Expr)> {
    // With the point (w, u): Δangle = K (mean(w) Δu − mean(u) Δw), K = Δangle/cross. Below 45° the angle between the
    // two points serves; above it, and where the segment crosses the cut, the difference of their angles, which
    // does not cancel there.
    let products = [graph.mul(&[wa, ub]), graph.mul(&[ua, wb]), graph.mul(&[wa, wb]), graph.mul(&[ua, ub])];
    let cross = graph.sub(products[0], products[1]);
    let dot = graph.add(&products[2..]);
    let t = graph.div(cross, dot);
    let cardinal = graph.unary(Unary::Atanc, t);
    let acute = graph.div(cardinal, dot);
    let angles = [graph.binary(Binary::Atan2, ua, wa), graph.binary(Binary::Atan2, ub, wb)];
    let turn = graph.sub(angles[1], angles[0]);
    let other = graph.div(turn, cross);
    let (width, swing) = (graph.unary(Unary::Abs, cross), graph.unary(Unary::Abs, turn));
    let half_turn = graph.number(std::f64::consts::PI);
    let near = Condition::less_or_equal(width, dot).and(Condition::less_or_equal(swing, half_turn));
    let k = graph.select(near, acute, other);
    // From or to the origin, where no angle is, and through it, along the way.
    let gaps = [graph.sub(ub, ua), graph.sub(wb, wa)];
    let squares = gaps.map(|gap| graph.square(gap));
    let (zero, length2) = (graph.zero(), graph.add(&squares));
    let opposite = graph.scale(-STRAIGHT, dot);
    let origin = Condition::less_or_equal(width, opposite);
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

/// Whether u, with a root in it, stays on one side of 0: what moves in it are roots.
pub(super) fn one_sided(graph: &Graph, u: Expr, moves: &dyn Fn(Expr) -> bool) -> bool {
    let (_, factors) = graph.factors(u);
    let is_root = |f: Expr| matches!(graph.node(f), Node::Unary(Unary::Sqrt, _));
    factors.iter().all(|&(f, _)| !moves(f) || is_root(f))
}

/// A secant toward u as one toward u², with (u²)[a, b] = a + b; between 0 and 0 it is 0 where the whole
/// rises faster than u.
pub(super) fn unless_vanishing(graph: &mut Graph, toward_u: Expr, [a, b]: [Expr; 2], rises: Condition) -> Expr {
    // Halves, as in even functions of a root.
    let halves = [a, b].map(|u| graph.scale(0.5, u));
    let (zero, middle) = (graph.zero(), graph.add(&halves));
    let secant = graph.div(toward_u, middle);
    let secant = graph.scale(0.5, secant);
    // Its derivative divides by the square, and by that of the root.
    let power = graph.powi(middle, 4);
    let vanishes = Condition::lost(graph, power).and(rises);
    graph.select(vanishes, zero, secant)
}

/// u^w = exp(w ln u): with δ = (w_b ln u_b − w_a ln u_a)/2 the factor of exp is √(u_a^w_a u_b^w_b) sinhc δ. The powers
/// are taken as powers, because exp(w ln u) would be |w ln u| times less accurate.
pub(super) fn of_powf(
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
    let order = graph.own_order(u);
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
