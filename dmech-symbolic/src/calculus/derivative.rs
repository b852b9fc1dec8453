//! Gradients by reverse accumulation.

use crate::expression::{
    Binary, Choice, Condition, EvenOfRoot, Expr, Graph, Node, Number, Root, Square, Symbol, Unary,
};
use crate::hash::Map;

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
            let adjoint = graph.add(&summands);
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
            // A root has a slope of 0 where all of it is of an order above the first; 1/√s times √s cancels anyhow.
            let flat = graph.is_flat(adjoint, node) && !graph.has_factor(adjoint, node);
            let alone = graph.as_number(adjoint).is_some();
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
                        || self.of_slope && (alone || self.chosen[root.below.index()]) =>
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
                Some(root) if (1..root.degree).contains(&n) && (self.of_slope || flat) => {
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

fn is_cardinal_slope(graph: &Graph, e: Expr) -> bool {
    use Unary::*;
    matches!(graph.node(e), Node::Unary(SincSlope | SinhcSlope | AtancSlope | AtanhcSlope, _))
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

/// The slope of a power of a root, 0 where the root vanishes: with the rest of a product that is often the limit.
fn unless_vanishing(graph: &mut Graph, root: &Root, f: Expr, n: i32) -> Expr {
    let (_, order, factors) = root.power_slope(graph, f, n);
    let slope = graph.product_of(Number::ONE, factors);
    let (zero, slope) = (graph.zero(), graph.scale(order, slope));
    // A square root is of nothing negative.
    let vanishes =
        if root.degree == 3 { Condition::equal(root.below, zero) } else { Condition::lost(graph, root.below) };
    graph.select(vanishes, zero, slope)
}

impl Root {
    /// (n/degree) fⁿ⁻ᵈᵉᵍʳᵉᵉ, with what is below the root.
    fn power_slope(&self, graph: &mut Graph, f: Expr, n: i32) -> (Expr, f64, Vec<(Expr, i32)>) {
        let mut factors = vec![(f, n - self.degree)];
        let mut order = f64::from(n);
        if self.degree == 3 {
            factors.push((graph.number(3.0), -1));
        } else {
            order /= f64::from(self.degree);
        }
        (self.below, order, factors)
    }
}

/// The slope of u^w by uⁿ: (w/n) u^(w − n).
fn power_slope_by(graph: &mut Graph, u: Expr, w: Expr, n: f64) -> Expr {
    let degree = graph.number(n);
    let lowered = graph.sub(w, degree);
    let power = graph.binary(Binary::Powf, u, lowered);
    let slope = graph.mul(&[w, power]);
    graph.scale(n.recip(), slope)
}

/// The slope of coshⁿ u by u² for n < 0: near the root of u it is regular, and far out it is not ∞·0.
fn inverse_cosh_slope(graph: &mut Graph, even: &EvenOfRoot, f: Expr, n: i32) -> Expr {
    let (one, square, cardinal) = (graph.one(), graph.square(even.argument), graph.unary(even.cardinal, even.argument));
    let tanh = graph.unary(Unary::Tanh, even.argument);
    let near = graph.product_of(Number::ONE, vec![(f, n - 1), (cardinal, 1)]);
    let far = graph.product_of(Number::ONE, vec![(f, n), (tanh, 1), (even.argument, -1)]);
    let slope = graph.select(Condition::less_or_equal(square, one), near, far);
    graph.scale(even.half * f64::from(n), slope)
}

/// The derivative of fⁿ as a number and factors, and the expression by which it is taken.
///
/// Powers of roots are powers of what is below the root: taken by the root and then by what is below, the derivative
/// would be 0/0 where that vanishes. So would that of sechⁿ far out, ∞·0.
fn power_slope(graph: &mut Graph, f: Expr, n: i32) -> (Expr, f64, Vec<(Expr, i32)>) {
    if let Some(root) = graph.root(f).filter(|root| n > root.degree) {
        return root.power_slope(graph, f, n);
    }
    match *graph.node(f) {
        Node::Unary(Unary::Cosh, u) if n < 0 => {
            let tanh = graph.unary(Unary::Tanh, u);
            (u, f64::from(n), vec![(f, n), (tanh, 1)])
        }
        _ => (f, f64::from(n), vec![(f, n - 1)]),
    }
}

/// f′(u).
pub(super) fn slope(g: &mut Graph, f: Unary, u: Expr) -> Expr {
    use Unary::*;
    let value = g.unary(f, u);
    let one = g.one();
    match f {
        Sqrt => {
            let inverse = g.recip(value);
            g.scale(0.5, inverse)
        }
        Cbrt => {
            let three = g.number(3.0);
            let square = g.square(value);
            let below = g.mul(&[three, square]);
            g.recip(below)
        }
        Exp => value,
        Exp2 => {
            let ln_2 = logarithm(g, 2.0);
            g.mul(&[ln_2, value])
        }
        ExpM1 => g.unary(Exp, u),
        Ln => g.recip(u),
        Ln1p => {
            let shifted = g.add(&[one, u]);
            g.recip(shifted)
        }
        Log2 | Log10 => {
            let ln_base = logarithm(g, if f == Log2 { 2.0 } else { 10.0 });
            let below = g.mul(&[ln_base, u]);
            g.recip(below)
        }
        Sin => g.unary(Cos, u),
        Cos => {
            let sine = g.unary(Sin, u);
            g.neg(sine)
        }
        Tan => {
            let square = g.square(value);
            g.add(&[one, square])
        }
        Asin | Acos => {
            let root = leg(g, u);
            let inverse = g.recip(root);
            if f == Asin { inverse } else { g.neg(inverse) }
        }
        Atan => {
            let square = g.square(u);
            let below = g.add(&[one, square]);
            g.recip(below)
        }
        Sinh => g.unary(Cosh, u),
        Cosh => g.unary(Sinh, u),
        Tanh => {
            // Not 1 − tanh²: it loses all digits where tanh is nearly 1.
            let cosh = g.unary(Cosh, u);
            g.powi(cosh, -2)
        }
        Asinh => {
            let square = g.square(u);
            let sum = g.add(&[one, square]);
            let root = g.unary(Sqrt, sum);
            g.recip(root)
        }
        Acosh => {
            let square = beyond_one(g, u, u);
            let root = g.unary(Sqrt, square);
            g.recip(root)
        }
        Atanh => {
            let below = below_one(g, u, u);
            g.recip(below)
        }
        Abs => g.unary(Signum, u),
        Signum | Round | Floor | Trunc => g.zero(),
        Sinc => even_slope(g, SincSlope, u),
        Sinhc => even_slope(g, SinhcSlope, u),
        Atanc => even_slope(g, AtancSlope, u),
        Atanhc => even_slope(g, AtanhcSlope, u),
        SincSlope | SinhcSlope => {
            // From the series of f₀ = sinc, f = f₀′/x: f′ = −(3 f ± f₀)/x. Near 0 it cancels; where it is wanted, for the
            // second derivatives of central steps, it comes times x.
            let base = g.unary(if f == SincSlope { Sinc } else { Sinhc }, u);
            let triple = g.scale(3.0, value);
            let sum = if f == SincSlope { g.add(&[triple, base]) } else { g.sub(triple, base) };
            let quotient = g.div(sum, u);
            g.neg(quotient)
        }
        AtancSlope | AtanhcSlope => {
            // (k − T)/x² with k = 1/(1 ± x²): the derivative is (∓2 k² − 3 T₁)/x.
            let square = g.square(u);
            let below = if f == AtancSlope { g.add(&[one, square]) } else { g.sub(one, square) };
            let k2 = g.powi(below, -2);
            let twice = g.scale(if f == AtancSlope { -2.0 } else { 2.0 }, k2);
            let triple = g.scale(3.0, value);
            let difference = g.sub(twice, triple);
            g.div(difference, u)
        }
    }
}

fn even_slope(g: &mut Graph, f: Unary, u: Expr) -> Expr {
    let ratio = g.unary(f, u);
    g.mul(&[u, ratio])
}

/// √(1 − u²), the other leg of the triangle with hypotenuse 1.
pub(super) fn leg(g: &mut Graph, u: Expr) -> Expr {
    let square = below_one(g, u, u);
    g.unary(Unary::Sqrt, square)
}

/// 1 − uw; by the distances from the ends ±1 where u and w are near them, as these have all their digits there. Elsewhere they
/// have not, nor has the derivative of what is made of them.
pub(super) fn below_one(g: &mut Graph, u: Expr, w: Expr) -> Expr {
    let (one, quarter, product) = (g.one(), g.number(0.25), g.mul(&[u, w]));
    let inside = g.sub(one, product);
    let beyond = beyond_one(g, u, w);
    let near_the_ends = g.neg(beyond);
    g.select(Condition::less_or_equal(product, quarter), inside, near_the_ends)
}

/// uw − 1 as ((u − 1)(w + 1) + (u + 1)(w − 1))/2
pub(super) fn beyond_one(g: &mut Graph, u: Expr, w: Expr) -> Expr {
    let one = g.one();
    let [above_u, above_w] = [u, w].map(|u| g.sub(u, one));
    let [over_u, over_w] = [u, w].map(|u| g.add(&[u, one]));
    let (first, second) = (g.mul(&[above_u, over_w]), g.mul(&[over_u, above_w]));
    g.mean(first, second)
}

/// ln of a number, kept as an expression so that it is as accurate as the scalar type.
pub(super) fn logarithm(g: &mut Graph, base: f64) -> Expr {
    let base = g.number(base);
    g.unary(Unary::Ln, base)
}

/// (∂f/∂u, ∂f/∂w).
fn binary_slopes(g: &mut Graph, f: Binary, u: Expr, w: Expr) -> (Expr, Expr) {
    let one = g.one();
    match f {
        Binary::Powf => {
            let lowered = g.sub(w, one);
            let power = g.binary(Binary::Powf, u, lowered);
            let value = g.binary(Binary::Powf, u, w);
            let ln = g.unary(Unary::Ln, u);
            (g.mul(&[w, power]), g.mul(&[ln, value]))
        }
        Binary::Atan2 => {
            let squares = [g.square(u), g.square(w)];
            let r2 = g.add(&squares);
            let toward_w = g.div(u, r2);
            (g.div(w, r2), g.neg(toward_w))
        }
        Binary::Min | Binary::Max => unreachable!("choices are taken as a whole"),
    }
}
