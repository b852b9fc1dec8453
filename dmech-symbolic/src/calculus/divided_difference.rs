//! Divided differences f[a, b] = (f(b) − f(a))/(b − a), written so that they have no 0/0.
//!
//! With m = (a + b)/2 and δ = (b − a)/2:
//!
//! | f | f\[a, b\] | origin |
//! |---|---|---|
//! | uⁿ | by squaring and multiplying; −1/(a b) for 1/u | (u w)[a, b] = mean(w) u[a, b] + mean(u) w[a, b] |
//! | √u, ∛u | 1/(√a + √b), 1/(∛a² + ∛a∛b + ∛b²) | difference of squares, of cubes |
//! | eᵘ | e^m sinhc δ | e^b − e^a = 2 e^m sinh δ |
//! | ln u | atanhc(δ/m)/m | ln(b/a) = 2 artanh(δ/m) |
//! | sin u, cos u | cos m sinc δ, −sin m sinc δ | sum to product |
//! | tan u | sinc(2δ)/(cos a cos b) | |
//! | sinh, cosh, tanh | cosh m sinhc δ, sinh m sinhc δ, sinhc(2δ)/(cosh a cosh b) | |
//! | asin u | 2 atanc(t)/(cₐ + c_b), t = (b − a)/(cₐ + c_b), c = √(1 − u²) | half angle of the difference |
//! | atan u | atanc(t)/(1 + ab), t = (b − a)/(1 + ab) | difference of angles |
//! | asinh u | 2 atanhc(t)/(rₐ + r_b), t = (b − a)/(rₐ + r_b), r = √(1 + u²); acosh with √(u² − 1) | |
//! | atanh u | atanhc(t)/(1 − ab), t = (b − a)/(1 − ab) | |
//! | \|u\| | (a + b)/(\|a\| + \|b\|), 0 at 0 | |
//! | sign, round, floor, trunc | 0 on one step, the plain quotient across | |
//!
//! artanh loses digits near 1, that is when a and b are far apart. There artanh t = arsinh(t/√(1 − t²)) takes over in the
//! logarithms and inverse hyperbolic functions, with t/√(1 − t²) in closed form: (b − a)/(2√a√b) for ln. The difference of the
//! logarithms themselves would cancel, ln 1e22 and ln 4e22 are nearly equal. In atan (beyond a right angle) and atanh
//! the plain quotient serves, and so it does in eᵘ, where sinhc δ may overflow while eᵇ does not.

use crate::expression::{Condition, Expr, Graph, Number, Unary};

use super::slopes::{below_one, beyond_one, leg, logarithm, slope};

/// f[a, b], symmetric in a and b, equal to f′(a) at a = b.
pub fn divided_difference(g: &mut Graph, f: Unary, a: Expr, b: Expr) -> Expr {
    use Unary::*;
    match f {
        Sqrt => {
            let roots = [g.unary(Sqrt, a), g.unary(Sqrt, b)];
            let sum = g.add(&roots);
            g.recip(sum)
        }
        Cbrt => {
            let (a, b) = (g.unary(Cbrt, a), g.unary(Cbrt, b));
            let terms = [g.square(a), g.mul(&[a, b]), g.square(b)];
            let sum = g.add(&terms);
            g.recip(sum)
        }
        Exp | ExpM1 => {
            let (m, delta) = midpoint_and_half_gap(g, a, b);
            let (middle, values) = (g.unary(Exp, m), [g.unary(Exp, a), g.unary(Exp, b)]);
            of_exponential(g, middle, delta, values)
        }
        Exp2 => {
            let ln_2 = logarithm(g, 2.0);
            let (m, delta) = midpoint_and_half_gap(g, a, b);
            let scaled = g.mul(&[ln_2, delta]);
            let (middle, values) = (g.unary(Exp2, m), [g.unary(Exp2, a), g.unary(Exp2, b)]);
            let natural = of_exponential(g, middle, scaled, values);
            g.mul(&[ln_2, natural])
        }
        Ln | Log2 | Log10 => {
            let natural = of_logarithm(g, a, b);
            match f {
                Ln => natural,
                _ => {
                    let ln_base = logarithm(g, if f == Log2 { 2.0 } else { 10.0 });
                    g.div(natural, ln_base)
                }
            }
        }
        Ln1p => {
            let one = g.one();
            let above = [g.add(&[one, a]), g.add(&[one, b])];
            logarithm_of(g, above, [a, b])
        }
        Sin | Cos => {
            let (m, delta) = midpoint_and_half_gap(g, a, b);
            let turned = g.unary(if f == Sin { Cos } else { Sin }, m);
            let cardinal = g.unary(Sinc, delta);
            let product = g.mul(&[turned, cardinal]);
            if f == Sin { product } else { g.neg(product) }
        }
        Tan => {
            let gap = g.sub(b, a);
            let (cos_a, cos_b, cardinal) = (g.unary(Cos, a), g.unary(Cos, b), g.unary(Sinc, gap));
            let below = g.mul(&[cos_a, cos_b]);
            g.div(cardinal, below)
        }
        Sinh | Cosh => {
            let (m, delta) = midpoint_and_half_gap(g, a, b);
            let factors = [g.unary(if f == Sinh { Cosh } else { Sinh }, m), g.unary(Sinhc, delta)];
            g.mul(&factors)
        }
        Tanh => {
            let gap = g.sub(b, a);
            let (cosh_a, cosh_b, cardinal) = (g.unary(Cosh, a), g.unary(Cosh, b), g.unary(Sinhc, gap));
            let below = g.mul(&[cosh_a, cosh_b]);
            let closed = g.div(cardinal, below);
            // Far apart sinh and cosh overflow (in binary32 beyond 88) where their quotient does not.
            let bound = g.number(64.0);
            let quotient = plain_quotient(g, Tanh, a, b);
            unless_far(g, a, b, bound, closed, quotient)
        }
        Asin | Acos => {
            let legs = [leg(g, a), leg(g, b)];
            let sum = g.add(&legs);
            let half = of_quotient(g, Atanc, [a, b], sum);
            let closed = g.scale(if f == Asin { 2.0 } else { -2.0 }, half);
            // From one end of the domain to the other both legs are 0.
            let (one, quotient) = (g.one(), plain_quotient(g, f, a, b));
            unless_far(g, a, b, one, closed, quotient)
        }
        Atan => {
            let (one, product) = (g.one(), g.mul(&[a, b]));
            let below = g.add(&[one, product]);
            let closed = of_quotient(g, Atanc, [a, b], below);
            // Beyond ab = −1 the difference of the angles exceeds a right angle.
            let quotient = plain_quotient(g, Atan, a, b);
            let bound = g.number(-0.5);
            g.select(Condition::less(bound, product), closed, quotient)
        }
        Asinh | Acosh => {
            let mut beside_one = |u: Expr, w: Expr| match f {
                Acosh => beyond_one(g, u, w),
                _ => {
                    let (one, product) = (g.one(), g.mul(&[u, w]));
                    g.add(&[one, product])
                }
            };
            let (squares, between) = ([beside_one(a, a), beside_one(b, b)], beside_one(a, b));
            let radii = squares.map(|square| g.unary(Sqrt, square));
            let sum = g.add(&radii);
            let (product, product_of_radii) = (g.mul(&[a, b]), g.mul(&radii));
            let square = g.add(&[between, product_of_radii]);
            let twice = g.scale(2.0, square);
            let width = g.unary(Sqrt, twice);
            let mut far = half_arsinh(g, a, b, width);
            if f == Asinh {
                // On both sides of 0 the width cancels, and the plain quotient does not.
                let (zero, quotient) = (g.zero(), plain_quotient(g, f, a, b));
                far = g.select(Condition::less(zero, product), far, quotient);
            }
            half_artanh(g, a, b, sum, far)
        }
        Atanh => {
            let below = below_one(g, a, b);
            let closed = of_quotient(g, Atanhc, [a, b], below);
            let half = g.scale(0.5, below);
            let quotient = plain_quotient(g, Atanh, a, b);
            unless_far(g, a, b, half, closed, quotient)
        }
        Abs => abs_secant(g, a, b),
        // What it is a part of is continuous: where it jumps, the rest of the rise goes the other way by as much.
        Signum | Round | Floor | Trunc => {
            let (zero, step_a, step_b) = (g.zero(), g.unary(f, a), g.unary(f, b));
            let quotient = plain_quotient(g, f, a, b);
            g.select(Condition::equal(step_a, step_b), zero, quotient)
        }
        // The engine's own primitives never stand in a potential.
        Sinc | SincSlope | Sinhc | SinhcSlope | Atanc | AtancSlope | Atanhc | AtanhcSlope => {
            let middle = g.mean(a, b);
            let (limit, quotient) = (slope(g, f, middle), plain_quotient(g, f, a, b));
            g.select(Condition::equal(a, b), limit, quotient)
        }
    }
}

/// (uⁿ)[a, b]: a + b for the square; even powers as squares, odd ones by the product rule, negative ones by
/// (1/u)[a, b] = −1/(a b).
pub(super) fn of_power(g: &mut Graph, a: Expr, b: Expr, n: i32) -> Expr {
    match n {
        i32::MIN..0 => {
            let difference = of_power(g, a, b, -n);
            let (below_a, below_b) = (g.powi(a, n), g.powi(b, n));
            let product = g.mul(&[difference, below_a, below_b]);
            g.neg(product)
        }
        0 => g.zero(),
        1 => g.one(),
        _ if n % 2 == 0 => {
            let (half_a, half_b) = (g.powi(a, n / 2), g.powi(b, n / 2));
            let sum = g.add(&[half_a, half_b]);
            let difference = of_power(g, a, b, n / 2);
            g.mul(&[sum, difference])
        }
        _ => {
            let (even_a, even_b) = (g.powi(a, n - 1), g.powi(b, n - 1));
            let (mean_even, mean) = (g.mean(even_a, even_b), g.mean(a, b));
            let difference = of_power(g, a, b, n - 1);
            let product = g.mul(&[mean, difference]);
            g.add(&[mean_even, product])
        }
    }
}

/// A power of a root, fⁿ between the values a and b of what is below it, where its exponent there is above 1.
///
/// Formed of roots it would divide by them where one end is 0, and its derivative even where none is. Where the ends are
/// that far apart the powers themselves do not cancel; between 0 and 0 it is 0, and so it is where both are so small that
/// what the derivative divides by would be lost.
pub(super) fn of_root(g: &mut Graph, degree: i32, a: Expr, b: Expr, n: i32) -> Expr {
    let (root, times) = if degree == 3 { (Unary::Cbrt, 1) } else { (Unary::Sqrt, degree.trailing_zeros()) };
    let mut closed = vec![];
    let first = [g.unary(root, a), g.unary(root, b)];
    let mut roots = [a, b];
    for _ in 0..times {
        closed.push(divided_difference(g, root, roots[0], roots[1]));
        roots = roots.map(|u| g.unary(root, u));
    }
    closed.push(of_power(g, roots[0], roots[1], n));
    let closed = g.mul(&closed);
    let values = roots.map(|root| g.powi(root, n));
    let (rise, gap) = (g.sub(values[1], values[0]), g.sub(b, a));
    let far = g.div(rise, gap);
    // By the roots, which are 0 where a and b are: a sum of these may be rounded otherwise.
    let (between, sum) = (g.sub(first[1], first[0]), g.add(&first));
    let (distance, size) = (g.unary(Unary::Abs, between), g.unary(Unary::Abs, sum));
    let half = g.scale(0.5, size);
    let secant = g.select(Condition::less(distance, half), closed, far);
    // Ends that are sums may differ where their difference, another sum, is 0: then the mean of the slopes.
    let whole = g.number(f64::from(degree));
    let halves = roots.map(|root| {
        let (power, half) = (g.powi(root, n - degree), g.number(0.5 * f64::from(n)));
        let slope = g.mul(&[half, power]);
        g.div(slope, whole)
    });
    let (limit, square) = (g.add(&halves), g.square(gap));
    let at_one = Condition::lost(g, square);
    let secant = g.select(at_one, limit, secant);
    let magnitudes = if degree == 3 { first.map(|root| g.unary(Unary::Abs, root)) } else { first };
    let reach = g.add(&magnitudes);
    // The square of what is below the root, or what more the derivative divides by.
    let times = if degree == 2 { 4 } else { 6 };
    let (zero, reach) = (g.zero(), g.powi(reach, times));
    let nothing = Condition::lost(g, reach);
    g.select(nothing, zero, secant)
}

/// A power of a root, fⁿ between the values a and b of what is below it, where its exponent there is below 1 and the whole
/// vanishes with it: 0 between 0 and 0.
pub(super) fn of_part_of_root(g: &mut Graph, degree: i32, a: Expr, b: Expr, n: i32) -> Expr {
    let (root, times) = if degree == 3 { (Unary::Cbrt, 1) } else { (Unary::Sqrt, degree.trailing_zeros()) };
    let (mut roots, mut closed, mut nothing) = ([a, b], vec![], None);
    for _ in 0..times {
        // Halves in the sums: the tangent of a root that vanishes is then 0.
        let halves = roots.map(|u| {
            let root = g.unary(root, u);
            g.scale(0.5, root)
        });
        let sum = if degree == 3 {
            let terms = [g.square(halves[0]), g.mul(&halves), g.square(halves[1])];
            let sum = g.add(&terms);
            g.scale(2.0, sum)
        } else {
            g.add(&halves)
        };
        closed.push((sum, -1));
        nothing.get_or_insert(sum);
        roots = roots.map(|u| g.unary(root, u));
    }
    let halves = roots.map(|u| g.scale(0.5, u));
    let power = of_power(g, halves[0], halves[1], n);
    closed.push((power, 1));
    let closed = g.product_of(Number::ONE, closed);
    let secant = g.scale(2f64.powi(n - 1 - times as i32), closed);
    // Its derivative divides by the square.
    let square = g.square(nothing.unwrap_or(a));
    let (zero, nothing) = (g.zero(), Condition::lost(g, square));
    g.select(nothing, zero, secant)
}

/// (eᵝ − eᵅ)/(β − α) = e^m sinhc δ, given e^m, δ = (β − α)/2 and the values at the ends, which do not cancel where δ is
/// so large that sinhc δ overflows.
pub(super) fn of_exponential(g: &mut Graph, middle: Expr, delta: Expr, values: [Expr; 2]) -> Expr {
    let cardinal = g.unary(Unary::Sinhc, delta);
    let closed = g.mul(&[middle, cardinal]);
    let rise = g.sub(values[1], values[0]);
    let quotient = g.div(rise, delta);
    let quotient = g.scale(0.5, quotient);
    let (distance, bound) = (g.unary(Unary::Abs, delta), g.number(8.0));
    g.select(Condition::less_or_equal(distance, bound), closed, quotient)
}

/// (a + b)/(|a| + |b|), 0 at 0: the divided difference of |u|. On one side of 0 it is ±1, and chosen rather than divided,
/// because a + b is flattened where a and b are sums and may round otherwise than |a| + |b|.
fn abs_secant(g: &mut Graph, a: Expr, b: Expr) -> Expr {
    let magnitudes = [g.unary(Unary::Abs, a), g.unary(Unary::Abs, b)];
    let below = g.add(&magnitudes);
    let sum = g.add(&[a, b]);
    let (zero, quotient) = (g.zero(), g.div(sum, below));
    // Its derivative divides by the square.
    let square = g.square(below);
    let nothing = Condition::lost(g, square);
    let across = g.select(nothing, zero, quotient);
    // The sign of the sum: where rounding leaves a and b no certain sign, that of the larger.
    let sides = [a, b].map(|u| g.unary(Unary::Signum, u));
    let (sides, sign) = (g.mul(&sides), g.unary(Unary::Signum, sum));
    let on_one_side = Condition::less(zero, sides).and(Condition::less(zero, below));
    g.select(on_one_side, sign, across)
}

/// (f(b) − f(a))/(b − a).
pub(super) fn plain_quotient(g: &mut Graph, f: Unary, a: Expr, b: Expr) -> Expr {
    let (value_a, value_b) = (g.unary(f, a), g.unary(f, b));
    let (rise, run) = (g.sub(value_b, value_a), g.sub(b, a));
    g.div(rise, run)
}

fn midpoint_and_half_gap(g: &mut Graph, a: Expr, b: Expr) -> (Expr, Expr) {
    let gap = g.sub(b, a);
    (g.mean(a, b), g.scale(0.5, gap))
}

/// ln[a, b].
pub(super) fn of_logarithm(g: &mut Graph, a: Expr, b: Expr) -> Expr {
    logarithm_of(g, [a, b], [a, b])
}

/// The same, where a and b are the numbers less one, or themselves: their difference is that of the numbers.
fn logarithm_of(g: &mut Graph, numbers: [Expr; 2], [a, b]: [Expr; 2]) -> Expr {
    let sum = g.add(&numbers);
    let roots = numbers.map(|u| g.unary(Unary::Sqrt, u));
    let mean = g.mul(&roots);
    let width = g.scale(2.0, mean);
    let far = half_arsinh(g, a, b, width);
    half_artanh(g, a, b, sum, far)
}

/// 2 arsinh((b − a)/w)/(b − a), w = √(s² − (b − a)²): the same as `half_artanh`, without its loss of digits near 1 but
/// with a 0/0.
fn half_arsinh(g: &mut Graph, a: Expr, b: Expr, w: Expr) -> Expr {
    let gap = g.sub(b, a);
    let ratio = g.div(gap, w);
    let half = g.unary(Unary::Asinh, ratio);
    let quotient = g.div(half, gap);
    g.scale(2.0, quotient)
}

/// 2 atanhc((b − a)/s)/s while |b − a| ≤ s/2.
fn half_artanh(g: &mut Graph, a: Expr, b: Expr, s: Expr, far: Expr) -> Expr {
    let closed = of_quotient(g, Unary::Atanhc, [a, b], s);
    let closed = g.scale(2.0, closed);
    let half = g.scale(0.5, s);
    unless_far(g, a, b, half, closed, far)
}

/// f((b − a)/s)/s.
fn of_quotient(g: &mut Graph, f: Unary, [a, b]: [Expr; 2], s: Expr) -> Expr {
    let gap = g.sub(b, a);
    let t = g.div(gap, s);
    let cardinal = g.unary(f, t);
    g.div(cardinal, s)
}

/// `closed` while |b − a| ≤ bound, the plain quotient beyond.
fn unless_far(g: &mut Graph, a: Expr, b: Expr, bound: Expr, closed: Expr, quotient: Expr) -> Expr {
    let gap = g.sub(b, a);
    let distance = g.unary(Unary::Abs, gap);
    g.select(Condition::less_or_equal(distance, bound), closed, quotient)
}

/// The quotient, 0 where the denominator is, or nearly: where rounding puts ends on two sides of a seam that are one point.
pub(super) fn or_zero(graph: &mut Graph, above: Expr, below: Expr) -> Expr {
    // Its derivative divides by the square.
    let (zero, square, quotient) = (graph.zero(), graph.square(below), graph.div(above, below));
    let nothing = Condition::lost(graph, square);
    graph.select(nothing, zero, quotient)
}
