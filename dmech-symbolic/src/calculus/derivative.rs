//! Gradients by reverse accumulation.

use crate::expression::{Binary, Condition, Expr, Graph, Node, Symbol, Unary};

/// ∂e/∂xᵢ for each symbol: one walk from the expression down to the symbols.
pub fn gradient(graph: &mut Graph, e: Expr, symbols: &[Symbol]) -> Vec<Expr> {
    let depends = graph.dependence(symbols);
    let order = graph.reachable(&[e]);
    // What arrives at a node: the derivative of e with respect to its value, as a list of summands.
    let mut arriving: Vec<Vec<Expr>> = vec![Vec::new(); depends.len()];
    let one = graph.one();
    arriving[e.index()].push(one);
    let mut found = vec![graph.zero(); symbols.len()];
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
            if let Some(i) = symbols.iter().position(|s| s == symbol) {
                found[i] = adjoint;
            }
            continue;
        }
        if let Node::Select(condition, yes, no) = graph.node(node).clone() {
            // Straight to the symbols: 0 times the slope of the branch not taken might be 0·∞.
            let (yes, no) = (gradient(graph, yes, symbols), gradient(graph, no, symbols));
            for (i, (&yes, &no)) in yes.iter().zip(&no).enumerate() {
                let chosen = graph.select(condition.clone(), yes, no);
                let share = graph.mul(&[adjoint, chosen]);
                if !graph.is_zero(share) {
                    let symbol = graph.symbol(symbols[i]);
                    arriving[symbol.index()].push(share);
                }
            }
            continue;
        }
        for (child, partial) in partials(graph, node, &|c: Expr| depends[c.index()]) {
            // A slope of a cardinal function g′(u)/u stands beside a factor u, and its own derivative divides by u: taken
            // summand by summand the two cancel, and nothing is left that is 0/0 at u = 0.
            let summands = if is_cardinal_slope(graph, node) { &summands[..] } else { &[adjoint] };
            let shares: Vec<_> = summands.iter().map(|&summand| graph.mul(&[summand, partial])).collect();
            arriving[child.index()].push(graph.add(&shares));
        }
    }
    found
}

fn is_cardinal_slope(graph: &Graph, e: Expr) -> bool {
    use Unary::*;
    matches!(graph.node(e), Node::Unary(SincSlope | SinhcSlope | AtancSlope | AtanhcSlope, _))
}

/// ∂e/∂x.
pub fn derivative(graph: &mut Graph, e: Expr, symbol: Symbol) -> Expr {
    gradient(graph, e, &[symbol])[0]
}

/// ∂eᵢ/∂xⱼ.
pub fn jacobian(graph: &mut Graph, components: &[Expr], symbols: &[Symbol]) -> Vec<Vec<Expr>> {
    components.iter().map(|&e| gradient(graph, e, symbols)).collect()
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

/// The children that depend on a symbol, each with ∂node/∂child.
fn partials(graph: &mut Graph, node: Expr, depends: &dyn Fn(Expr) -> bool) -> Vec<(Expr, Expr)> {
    match graph.node(node).clone() {
        Node::Number(_) | Node::Symbol(_) => Vec::new(),
        Node::Sum { terms, .. } => {
            let moving = terms.iter().filter(|(_, t)| depends(*t));
            moving.map(|&(c, t)| (t, graph.number(c.value()))).collect()
        }
        Node::Product { coefficient, factors } => {
            let mut found = vec![];
            for (i, &(f, n)) in factors.iter().enumerate().filter(|(_, (f, _))| depends(*f)) {
                let mut rest = factors.to_vec();
                rest[i].1 -= 1;
                let rest = graph.product_of(coefficient, rest);
                found.push((f, graph.scale(f64::from(n), rest)));
            }
            found
        }
        Node::Unary(f, u) => vec![(u, slope(graph, f, u))],
        Node::Binary(f, u, w) => {
            let both = binary_slopes(graph, f, u, w);
            [(u, both.0), (w, both.1)].into_iter().filter(|(c, _)| depends(*c)).collect()
        }
        Node::Select(..) => unreachable!("handled by the walk itself"),
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
            let square = g.square(u);
            let difference = g.sub(square, one);
            let root = g.unary(Sqrt, difference);
            g.recip(root)
        }
        Atanh => {
            let square = g.square(u);
            let below = g.sub(one, square);
            g.recip(below)
        }
        Abs => g.unary(Signum, u),
        Signum => g.zero(),
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
    let one = g.one();
    let square = g.square(u);
    let difference = g.sub(one, square);
    g.unary(Unary::Sqrt, difference)
}

/// ln of a number, kept as an expression so that it is as accurate as the scalar type.
pub(super) fn logarithm(g: &mut Graph, base: f64) -> Expr {
    let base = g.number(base);
    g.unary(Unary::Ln, base)
}

/// (∂f/∂u, ∂f/∂w).
pub(super) fn binary_slopes(g: &mut Graph, f: Binary, u: Expr, w: Expr) -> (Expr, Expr) {
    let (zero, one) = (g.zero(), g.one());
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
        Binary::Min => {
            let condition = Condition::less_or_equal(u, w);
            (g.select(condition.clone(), one, zero), g.select(condition, zero, one))
        }
        Binary::Max => {
            let condition = Condition::less_or_equal(w, u);
            (g.select(condition.clone(), one, zero), g.select(condition, zero, one))
        }
    }
}
