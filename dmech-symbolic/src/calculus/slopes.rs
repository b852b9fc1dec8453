//! Slopes of functions and of powers, each in the form that is regular where its function is.

use crate::expression::{Binary, Condition, EvenOfRoot, Expr, Graph, Node, Number, Root, Unary};

/// The slope of a power of a root, 0 where the root vanishes: with the rest of a product that is often the limit.
pub(super) fn unless_vanishing(graph: &mut Graph, root: &Root, f: Expr, n: i32) -> Expr {
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
pub(super) fn power_slope_by(graph: &mut Graph, u: Expr, w: Expr, n: f64) -> Expr {
    let degree = graph.number(n);
    let lowered = graph.sub(w, degree);
    let power = graph.binary(Binary::Powf, u, lowered);
    let slope = graph.mul(&[w, power]);
    graph.scale(n.recip(), slope)
}

/// The slope of coshⁿ u by u² for n < 0: near the root of u it is regular, and far out it is not ∞·0.
pub(super) fn inverse_cosh_slope(graph: &mut Graph, even: &EvenOfRoot, f: Expr, n: i32) -> Expr {
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
pub(super) fn power_slope(graph: &mut Graph, f: Expr, n: i32) -> (Expr, f64, Vec<(Expr, i32)>) {
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
pub(super) fn binary_slopes(g: &mut Graph, f: Binary, u: Expr, w: Expr) -> (Expr, Expr) {
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
        Binary::Min | Binary::Max | Binary::AtMost | Binary::AtLeast => unreachable!("choices are taken as a whole"),
    }
}

/// Whether e is the slope of a cardinal function, g′(u)/u.
pub(super) fn is_cardinal_slope(graph: &Graph, e: Expr) -> bool {
    use Unary::*;
    matches!(graph.node(e), Node::Unary(SincSlope | SinhcSlope | AtancSlope | AtanhcSlope, _))
}
