//! Gradients by reverse accumulation.

use crate::expression::{Binary, Choice, Condition, Expr, Graph, Node, Number, Square, Symbol, Unary};
use crate::hash::Map;

use super::centre::{Distance, by_the_square};
use super::slopes::{
    binary_slopes, inverse_cosh_slope, is_cardinal_slope, power_slope, power_slope_by, slope, unless_vanishing,
};

/// ∂e/∂xᵢ for each symbol: one walk from the expression down to the symbols.
pub fn gradient(graph: &mut Graph, e: Expr, symbols: &[Symbol]) -> Vec<Expr> {
    Walk::new(symbols, false).gradient(graph, e)
}

/// As [`gradient`], of an expression that is a slope itself: where a root in it vanishes and has no slope, 0 stands for that.
///
/// Newton's method then makes a plain iteration there, where ∞·0 would end it; and where the product does have a limit, as
/// r·x has at the origin, it is this one.
pub fn tangent(graph: &mut Graph, e: Expr, symbols: &[Symbol]) -> Vec<Expr> {
    Walk::new(symbols, true).gradient(graph, e)
}

struct Walk<'a> {
    symbols: &'a [Symbol],
    /// The expression is a slope.
    of_slope: bool,
    /// The slopes of the branches of a choice, which may be wanted in many places.
    choices: Map<Expr, [Vec<Expr>; 2]>,
    /// Which expressions contain a symbol, as far as they have been looked at.
    depends: Vec<bool>,
    /// Which are made with a choice: the place where a step crosses a seam is.
    chosen: Vec<bool>,
}

impl<'a> Walk<'a> {
    fn new(symbols: &'a [Symbol], of_slope: bool) -> Self {
        Self { symbols, of_slope, choices: Map::default(), depends: vec![], chosen: vec![] }
    }

    fn gradient(&mut self, graph: &mut Graph, e: Expr) -> Vec<Expr> {
        let symbols = self.symbols;
        graph.extend_dependence(&mut self.depends, symbols);
        graph.extend_choosing(&mut self.chosen);
        let order = graph.reachable(&[e]);
        // What arrives at a node: the derivative of e with respect to its value, as a list of summands. Nested choices have
        // many small walks in one large store.
        let mut arriving: Map<Expr, Vec<Expr>> = Map::default();
        arriving.insert(e, vec![graph.one()]);
        let mut found = vec![graph.zero(); symbols.len()];
        for &node in order.iter().rev() {
            if !self.depends[node.index()] {
                continue;
            }
            let Some(summands) = arriving.remove(&node) else { continue };
            let adjoint = if self.of_slope { graph.add(&summands) } else { graph.add_fractions(&summands) };
            if graph.is_zero(adjoint) {
                continue;
            }
            if let Node::Symbol(symbol) = graph.node(node) {
                if let Some(i) = symbols.iter().position(|s| s == symbol) {
                    found[i] = adjoint;
                }
                continue;
            }
            if let Some(Choice { condition, yes, no }) = graph.choice(node) {
                // Straight to the symbols, the adjoint within the branches: 0·∞ of the branch not taken must not arise.
                let slopes = match self.choices.get(&node) {
                    Some(slopes) => slopes.clone(),
                    None => {
                        let slopes = [yes, no].map(|branch| self.gradient(graph, branch));
                        self.choices.insert(node, slopes.clone());
                        slopes
                    }
                };
                for (i, (&yes, &no)) in slopes[0].iter().zip(&slopes[1]).enumerate() {
                    let (yes, no) = (graph.mul_within(adjoint, yes), graph.mul_within(adjoint, no));
                    let share = graph.select(condition.clone(), yes, no);
                    if !graph.is_zero(share) {
                        let symbol = graph.symbol(symbols[i]);
                        arriving.entry(symbol).or_default().push(share);
                    }
                }
                continue;
            }
            // 1/√s times √s cancels.
            let cancels = graph.has_factor(adjoint, node);
            let distance = if self.of_slope { None } else { Distance::of(graph, node) };
            // Another root has a slope of 0 where all of it is of an order above the first.
            let flat = !cancels && distance.is_none() && graph.is_flat(adjoint, node);
            if let Some(distance) = distance.filter(|_| !cancels) {
                let below = distance.below;
                if let Some(share) = by_the_square(graph, adjoint, &[(node, distance)]) {
                    arriving.entry(below).or_default().push(share);
                    continue;
                }
            }
            graph.extend_dependence(&mut self.depends, symbols);
            let alone = !self.depends[adjoint.index()];
            for (child, partial) in self.partials(graph, node, &|c: Expr| self.depends[c.index()], flat, alone) {
                // A slope of a cardinal function g′(u)/u stands beside a factor u, and its own derivative divides by u: taken
                // summand by summand the two cancel, and nothing is left that is 0/0 at u = 0.
                let summands = if is_cardinal_slope(graph, node) { &summands[..] } else { &[adjoint] };
                let shares: Vec<_> = summands.iter().map(|&summand| graph.mul(&[summand, partial])).collect();
                arriving.entry(child).or_default().push(graph.add(&shares));
            }
        }
        found
    }

    /// The children that depend on a symbol, each with ∂node/∂child; of roots that may vanish, what is below them.
    fn partials(
        &self,
        graph: &mut Graph,
        node: Expr,
        depends: &dyn Fn(Expr) -> bool,
        flat: bool,
        alone: bool,
    ) -> Vec<(Expr, Expr)> {
        match graph.node(node).clone() {
            Node::Number(_) | Node::Symbol(_) => Vec::new(),
            Node::Sum { terms, .. } => {
                let moving = terms.iter().filter(|(_, t)| depends(*t));
                let partial = |&(c, t): &(Number, Expr)| match graph.root(t) {
                    Some(root) if self.of_slope && c.value().abs() != 1.0 => {
                        let slope = unless_vanishing(graph, &root, t, 1);
                        (root.below, graph.scale(c.value(), slope))
                    }
                    _ => (t, graph.number(c.value())),
                };
                moving.map(partial).collect()
            }
            Node::Product { coefficient, factors } => {
                self.product_partials(graph, coefficient, &factors, depends, flat)
            }
            Node::Unary(f, u) => match (graph.even_of_root(node), graph.root(node)) {
                (Some(even), _) => {
                    let slope = graph.unary(even.cardinal, even.argument);
                    let slope = graph.scale(even.half, slope);
                    self.square_partials(graph, slope, &even.square, depends, flat)
                }
                // A root alone, or in a sum, vanishes where the ends do; on a seam, where a step only passes.
                (_, Some(root))
                    if flat && graph.own_order(node) > 0.0
                        || self.of_slope && (alone || self.chosen[root.below.index()] || graph.has_centre()) =>
                {
                    vec![(root.below, unless_vanishing(graph, &root, node, 1))]
                }
                // A function of a root, as it would be of −√s or k √s.
                _ if self.of_slope && graph.root(u).is_some() => {
                    let slope = slope(graph, f, u);
                    let partials = self.product_partials(graph, Number::ONE, &[(u, 1)], depends, flat);
                    partials.into_iter().map(|(child, partial)| (child, graph.mul(&[slope, partial]))).collect()
                }
                _ => vec![(u, slope(graph, f, u))],
            },
            Node::Binary(f, u, w) => {
                let mut both = binary_slopes(graph, f, u, w);
                if f == Binary::Atan2 && self.of_slope {
                    // None at the origin, as of a root that vanishes.
                    let squares = [graph.square(u), graph.square(w)];
                    let (zero, r2) = (graph.zero(), graph.add(&squares));
                    let origin = Condition::lost(graph, r2);
                    both = (graph.select(origin.clone(), zero, both.0), graph.select(origin, zero, both.1));
                }
                let square = graph.square_without_root(u).filter(|_| f == Binary::Powf);
                if f == Binary::Powf {
                    // By u² where u has a root: u^w may be smooth where the root is not.
                    let degree = if square.is_some() { 2.0 } else { 1.0 };
                    let slope = power_slope_by(graph, u, w, degree);
                    both.0 = self.unless_infinite(graph, slope, (u, w), degree);
                }
                let mut found = match square {
                    Some(square) => self.square_partials(graph, both.0, &square, depends, flat),
                    None => vec![(u, both.0)],
                };
                found.push((w, both.1));
                found.retain(|(c, _)| depends(*c));
                found
            }
            Node::Select(..) => unreachable!("choices are taken as a whole"),
        }
    }

    /// As [`product_partials`](Self::product_partials), of what depends on u² by a slope.
    fn square_partials(
        &self,
        graph: &mut Graph,
        slope: Expr,
        square: &Square,
        depends: &dyn Fn(Expr) -> bool,
        flat: bool,
    ) -> Vec<(Expr, Expr)> {
        let coefficient = graph.number(square.coefficient.value());
        let outside = graph.product_of(Number::ONE, vec![(slope, 1), (coefficient, 2)]);
        let partials = self.product_partials(graph, Number::ONE, &square.factors, depends, flat);
        partials.into_iter().map(|(child, partial)| (child, graph.mul(&[outside, partial]))).collect()
    }

    /// The slope of u^w by uⁿ, 0 where it is infinite but u^w is not: at u = 0 for 0 < w < n. Of a law only where it is of an
    /// order above 1: then it is the limit.
    fn unless_infinite(&self, graph: &mut Graph, slope: Expr, (u, w): (Expr, Expr), n: f64) -> Expr {
        let (zero, most) = (graph.zero(), graph.number(n));
        let least = if self.of_slope { 0.0 } else { graph.own_order(u).recip() };
        let vanishes = Condition::equal(u, zero);
        let condition = match graph.as_number(w) {
            _ if least >= n => return slope,
            Some(w) if w <= least || w >= n => return slope,
            Some(_) => vanishes,
            None if self.of_slope => vanishes.and(Condition::less(w, most)),
            None => {
                let least = graph.number(least);
                vanishes.and(Condition::less(w, most)).and(Condition::less(least, w))
            }
        };
        graph.select(condition, zero, slope)
    }

    /// The children of c Π fᵢ^nᵢ that depend on a symbol, each with its partial derivative.
    fn product_partials(
        &self,
        graph: &mut Graph,
        coefficient: Number,
        factors: &[(Expr, i32)],
        depends: &dyn Fn(Expr) -> bool,
        flat: bool,
    ) -> Vec<(Expr, Expr)> {
        let mut found = vec![];
        let (moving, fixed): (Vec<_>, Vec<_>) = factors.iter().copied().partition(|&(f, _)| depends(f));
        for (i, &(f, n)) in moving.iter().enumerate() {
            let mut rest = moving.clone();
            rest.remove(i);
            rest.extend(&fixed);
            if let Some(even) = graph.even_of_root(f).filter(|even| even.cardinal == Unary::Sinhc && n < 0) {
                rest.extend([(inverse_cosh_slope(graph, &even, f, n), 1)]);
                let outside = graph.product_of(coefficient, rest);
                found.extend(self.square_partials(graph, outside, &even.square, depends, flat));
                continue;
            }
            let (child, order, slope) = match graph.root(f) {
                Some(root)
                    if (1..root.degree).contains(&n) && (self.of_slope || flat && Distance::of(graph, f).is_none()) =>
                {
                    (root.below, 1.0, vec![(unless_vanishing(graph, &root, f, n), 1)])
                }
                _ => power_slope(graph, f, n),
            };
            rest.extend(slope);
            let rest = graph.product_of(coefficient, rest);
            found.push((child, graph.scale(order, rest)));
        }
        found
    }
}

/// ∂e/∂x.
pub fn derivative(graph: &mut Graph, e: Expr, symbol: Symbol) -> Expr {
    gradient(graph, e, &[symbol])[0]
}

/// ∂eᵢ/∂xⱼ of components that are slopes: see [`tangent`].
pub fn jacobian(graph: &mut Graph, components: &[Expr], symbols: &[Symbol]) -> Vec<Vec<Expr>> {
    let mut walk = Walk::new(symbols, true);
    components.iter().map(|&e| walk.gradient(graph, e)).collect()
}

/// ∂²e/∂xᵢ∂xⱼ; both halves are the same expressions.
pub fn hessian(graph: &mut Graph, e: Expr, symbols: &[Symbol]) -> Vec<Vec<Expr>> {
    let first = gradient(graph, e, symbols);
    let mut second = jacobian(graph, &first, symbols);
    for i in 0..symbols.len() {
        for j in 0..i {
            second[j][i] = second[i][j];
        }
    }
    second
}
