//! Distances in what is of an order above the first only as a whole: eʳ − r − 1 has a slope of 0 where r vanishes, and r has none there.
//!
//! What its slope comes to there is a derivative again: this file and [`derivative`](super::derivative) call each other, as far down as
//! roots are nested.

use crate::expression::{Binary, Condition, Expr, Graph, Node, Number, Substitution, Unary, Variable};
use crate::hash::Map;

use super::derivative::derivative;

/// A distance √Σx², or √Σ(x − c)².
pub(super) struct Distance {
    pub(super) below: Expr,
    /// The coordinates where it vanishes.
    place: Vec<(Expr, Expr)>,
}

impl Distance {
    /// The root as a distance.
    pub(super) fn of(graph: &mut Graph, root: Expr) -> Option<Self> {
        let below = graph.root(root).filter(|root| root.degree == 2)?.below;
        if graph.own_order(root) != 1.0 {
            return None;
        }
        let place = place(graph, below)?;
        Some(Distance { below, place })
    }

    /// The kind of variable that an expression is: the square of a distance is one.
    pub(super) fn variable(graph: &mut Graph, e: Expr) -> Variable {
        if place(graph, e).is_some() { Variable::SquaredDistance } else { Variable::Coordinate }
    }
}

/// A slope or secant A toward a root r as one toward r²: A/(r + r′) with r and r′ at the two ends, or A/2r where these are one, and its
/// limit A′/2 where that is 0/0. Where parts of A cancel, the quotient has no digits near there, and the limit is taken wherever A is its
/// linear part to rounding.
///
/// None unless A is seen to vanish where the root does: then the law has no slope there.
pub(super) fn by_the_square(graph: &mut Graph, slope: Expr, ends: &[(Expr, Distance)]) -> Option<Expr> {
    let mut centre = Substitution::default();
    for (root, distance) in ends {
        let (zero, opposite) = (graph.zero(), graph.neg(distance.below));
        [*root, distance.below, opposite].into_iter().for_each(|vanishing| centre.remember(vanishing, zero));
        distance.place.iter().for_each(|&(coordinate, place)| centre.remember(coordinate, place));
    }
    if value(graph, slope, &mut centre).is_none_or(|there| !graph.is_zero(there)) {
        return None;
    }
    graph.remember_centre();
    // A factor that is 0 on a line through the centre says nothing of the distance: what comes times it is looked at by itself.
    let mut quotients = vec![];
    for (factor, rest) in by_vanishing_factors(graph, slope, ends, &mut centre) {
        let quotient = half_over(graph, rest, ends, &mut centre);
        quotients.push(graph.mul(&[factor, quotient]));
    }
    Some(graph.add(&quotients))
}

/// A/2r of an A that vanishes with r, and its limit.
fn half_over(graph: &mut Graph, slope: Expr, ends: &[(Expr, Distance)], centre: &mut Substitution) -> Expr {
    let limit = rise(graph, slope, ends);
    let roots: Vec<_> = ends.iter().map(|&(root, _)| root).collect();
    let part = 1.0 / roots.len() as f64;
    let sum = graph.add(&roots);
    let sum = graph.scale(2.0 * part, sum);
    if !cancels(graph, slope, ends, centre) {
        // Halves in the sums: the [tangent](super::tangent) of a root that vanishes is then 0.
        let parts: Vec<_> = roots.iter().map(|&root| graph.scale(part, root)).collect();
        let middle = graph.add(&parts);
        let (square, quotient) = (graph.square(middle), divided(graph, slope, sum));
        let lost = Condition::lost(graph, square);
        return graph.select(lost, limit, quotient);
    }
    let (quotient, linear) = (graph.div(slope, sum), graph.mul(&[limit, sum]));
    let rest = graph.sub(slope, linear);
    let size = size(graph, slope, ends, centre);
    // Without a number before it, which would be multiplied with that for a rounding.
    let (number, _) = graph.factors(size);
    let [rest, size] = [rest, size].map(|e| graph.scale(number.value().recip(), e));
    let (rest, rounding) = (graph.unary(Unary::Abs, rest), graph.number(Number::ROUNDING.value()));
    let rounding = graph.mul(&[rounding, size]);
    graph.select(Condition::less_or_equal(rest, rounding), limit, quotient)
}

/// An expression that vanishes at the centre, as Σ factor · rest with rests that vanish there and factors that do so without a distance.
fn by_vanishing_factors(
    graph: &mut Graph,
    e: Expr,
    ends: &[(Expr, Distance)],
    centre: &mut Substitution,
) -> Vec<(Expr, Expr)> {
    let one = graph.one();
    let summands: Vec<_> = match graph.node(e).clone() {
        _ if !cancels(graph, e, ends, centre) => return vec![(one, e)],
        Node::Sum { constant, terms } => {
            let mut summands = vec![graph.number(constant.value())];
            summands.extend(terms.iter().map(|&(c, term)| graph.scale(c.value(), term)));
            summands
        }
        _ => vec![e],
    };
    // (x − c) eʳ − x + c is (x − c) (eʳ − 1).
    let (of, free): (Vec<_>, Vec<_>) = summands.into_iter().partition(|&summand| is_of(graph, summand, ends));
    let free = graph.add(&free);
    let mut sums: Vec<(Expr, Expr)> = vec![];
    for summand in of.into_iter().chain([free]) {
        let (_, factors) = graph.factors(summand);
        let apart = factors.into_iter().filter(|&(f, n)| n > 0 && !is_of(graph, f, ends) && vanishes(graph, f, centre));
        let apart = apart.collect();
        let factor = graph.product_of(Number::ONE, apart);
        let rest = graph.div(summand, factor);
        let [opposite, turned] = [factor, rest].map(|e| graph.neg(e));
        let known = sums.iter_mut().find(|(other, _)| [factor, opposite].contains(other));
        match known {
            Some((other, sum)) => *sum = graph.add(&[*sum, if *other == factor { rest } else { turned }]),
            None => sums.push((factor, rest)),
        }
    }
    // What does not vanish by itself, x eʳ beside x, stays with all else.
    let (mut sums, others): (Vec<_>, Vec<_>) =
        sums.into_iter().partition(|&(factor, rest)| factor != one && vanishes(graph, rest, centre));
    let others: Vec<_> = others.into_iter().map(|(factor, rest)| graph.mul(&[factor, rest])).collect();
    sums.push((one, graph.add(&others)));
    sums
}

/// Whether a distance is in an expression.
fn is_of(graph: &Graph, e: Expr, ends: &[(Expr, Distance)]) -> bool {
    graph.reachable(&[e]).iter().any(|e| ends.iter().any(|(root, distance)| e == root || *e == distance.below))
}

/// A quotient, summand by summand: r f(r)/r is f(r).
fn divided(graph: &mut Graph, e: Expr, by: Expr) -> Expr {
    let Node::Sum { constant, terms } = graph.node(e).clone() else { return graph.div(e, by) };
    let constant = graph.number(constant.value());
    let mut summands = vec![graph.div(constant, by)];
    for (c, term) in terms {
        let quotient = graph.div(term, by);
        summands.push(graph.scale(c.value(), quotient));
    }
    graph.add(&summands)
}

/// Whether what vanishes is a sum of parts that do not. In x − c nothing is lost: the distance is made of it.
fn cancels(graph: &mut Graph, e: Expr, ends: &[(Expr, Distance)], centre: &mut Substitution) -> bool {
    match graph.node(e).clone() {
        Node::Sum { terms, .. } => {
            is_of(graph, e, ends) && !terms.iter().all(|&(_, term)| vanishes(graph, term, centre))
        }
        Node::Product { factors, .. } => {
            factors.iter().any(|&(f, _)| vanishes(graph, f, centre) && cancels(graph, f, ends, centre))
        }
        _ => false,
    }
}

/// Whether an expression is the number 0 after a replacement.
fn vanishes(graph: &mut Graph, e: Expr, replacement: &mut Substitution) -> bool {
    let image = replacement.apply(graph, e);
    graph.is_zero(image)
}

/// A′/2 at 0, of A with the roots at all ends the same; 0 if that is not finite.
fn rise(graph: &mut Graph, slope: Expr, ends: &[(Expr, Distance)]) -> Expr {
    let symbol = graph.coordinate("r");
    let (zero, r) = (graph.zero(), graph.symbol(symbol));
    let along = Substitution::of_expressions(ends.iter().map(|&(root, _)| (root, r))).apply(graph, slope);
    let rise = derivative(graph, along, symbol);
    let rise = value(graph, rise, &mut Substitution::of_expressions([(r, zero)]));
    rise.map_or(zero, |rise| graph.scale(0.5, rise))
}

/// How large the parts are that cancel in what vanishes.
fn size(graph: &mut Graph, e: Expr, ends: &[(Expr, Distance)], centre: &mut Substitution) -> Expr {
    match graph.node(e).clone() {
        Node::Sum { constant, terms } => {
            let mut sizes = vec![graph.number(constant.value().abs())];
            for &(c, term) in &terms {
                let size = graph.unary(Unary::Abs, term);
                sizes.push(graph.scale(c.value().abs(), size));
            }
            graph.add(&sizes)
        }
        Node::Product { coefficient, factors } => {
            let factors = factors.iter().map(|&(f, n)| {
                let parts = n > 0 && is_of(graph, f, ends) && vanishes(graph, f, centre);
                (if parts { size(graph, f, ends, centre) } else { graph.unary(Unary::Abs, f) }, n)
            });
            let factors = factors.collect();
            graph.product_of(Number::new(coefficient.value().abs()), factors)
        }
        _ => graph.unary(Unary::Abs, e),
    }
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
        let mut is_zero = |u: Expr| vanishes(graph, u, replacement);
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
                let branches = [(yes, second), (no, first)];
                let taken = branches.into_iter().filter(|&(_, other)| taken != other || first == second);
                open.extend(taken.map(|(branch, _)| branch));
            }
            _ => open.extend(graph.children(e)),
        }
    }
    Some(image)
}

/// Where a sum of squares vanishes: at 0 in a coordinate that is squared by itself, at c in one that x − c is squared of. Whatever else is
/// squared has to vanish there too.
fn place(graph: &mut Graph, squares: Expr) -> Option<Vec<(Expr, Expr)>> {
    let (mut found, mut others, mut open) = (vec![], vec![], vec![squares]);
    while let Some(e) = open.pop() {
        match graph.node(e).clone() {
            Node::Symbol(_) if graph.order(e) == 2.0 => {}
            Node::Sum { constant: Number::ZERO, terms } if terms.iter().all(|&(c, _)| c.value() > 0.0) => {
                open.extend(terms.iter().map(|&(_, term)| term));
            }
            Node::Product { coefficient, factors } if coefficient.value() > 0.0 => match factors[..] {
                [(base, n)] if n > 0 && n % 2 == 0 => match zero_of(graph, base) {
                    Some(zero) => found.push(zero),
                    None => others.push(base),
                },
                [(squares, 1)] => open.push(squares),
                _ => return None,
            },
            _ => return None,
        }
    }
    let mut there = Substitution::of_expressions(found.iter().copied());
    others.into_iter().all(|base| vanishes(graph, base, &mut there)).then_some(found)
}

/// The coordinate in x or x − c, and where that is 0.
fn zero_of(graph: &mut Graph, e: Expr) -> Option<(Expr, Expr)> {
    if graph.is_coordinate(e) {
        return Some((e, graph.zero()));
    }
    let Node::Sum { terms, .. } = graph.node(e) else { return None };
    let &(c, term) = terms.iter().find(|&&(_, term)| graph.is_coordinate(term))?;
    let own = graph.scale(c.value(), term);
    let rest = graph.sub(e, own);
    let alone = !graph.reachable(&[rest]).contains(&term);
    alone.then(|| (term, graph.scale(-c.value().recip(), rest)))
}
