//! Every divided difference against 77 digits, over the domain of its function: far apart, nearly equal, equal, and on
//! both sides of 0.

use crate::common::algebra::{Algebra, Big, big, narrow};
use crate::common::laws::Law;
use crate::common::notation::{E, within};
use crate::common::{U, Worst};
use dmech_symbolic::calculus::{self, TwoPoints};
use dmech_symbolic::expression::{Expr, Graph, Symbol, Unary, evaluate};

/// A function of one argument, and where to try it.
struct Function {
    name: String,
    build: Box<dyn Fn(E) -> E>,
    exact: Box<dyn Fn(&Big) -> Big>,
    points: Vec<f64>,
}

fn unary(f: Unary, points: &[f64]) -> Function {
    Function {
        name: f.method().to_owned(),
        build: Box::new(move |u| u.of(f)),
        exact: Box::new(move |x| x.unary(f)),
        points: points.to_vec(),
    }
}

fn power(p: f64, points: &[f64]) -> Function {
    Function {
        name: format!("u^{p}"),
        build: Box::new(move |u| u.powf(p)),
        exact: Box::new(move |x| x.powf(&big(p))),
        points: points.to_vec(),
    }
}

fn integer_power(n: i32, points: &[f64]) -> Function {
    Function {
        name: format!("u^{n}"),
        build: Box::new(move |u| u.powi(n)),
        exact: Box::new(move |x| x.power(n)),
        points: points.to_vec(),
    }
}

fn functions() -> Vec<Function> {
    use Unary::*;
    let positive = [1e-12, 3e-5, 0.07, 0.4, 0.9, 1.0, 1.3, 2.7, 31.0, 4.1e3, 7e9, 2.9e10, 3e20];
    let real = [-4e5, -52.0, -3.3, -1.1, -0.6, -2e-4, 1e-9, 0.02, 0.5, 1.7, 4.4, 60.0, 2e7, 9e7];
    let narrow = [-21.0, -5.2, -1.7, -0.8, -0.03, -1e-7, 2e-11, 0.004, 0.3, 1.1, 2.9, 7.3, 26.0];
    let within = [-0.9999, -0.97, -0.7, -0.3, -0.01, -1e-8, 1e-10, 0.002, 0.2, 0.55, 0.88, 0.999, 0.999999];
    let quarter = [-1.55, -1.2, -0.7, -0.02, 1e-9, 0.3, 0.9, 1.4, 1.57];
    let shifted = [-0.99999, -0.9, -0.5, -0.01, -1e-9, 1e-12, 0.003, 0.2, 0.8, 3.0, 55.0, 1e4, 6e11, 5e12];
    let above = [1.0 + 1e-9, 1.0003, 1.02, 1.4, 2.2, 7.0, 110.0, 5e4, 3e12, 2e13];
    let mut list = vec![unary(Ln1p, &shifted), unary(Acosh, &above), unary(Tan, &quarter)];
    list.extend([Sqrt, Ln, Log2, Log10].map(|f| unary(f, &positive)));
    list.extend([Cbrt, Atan, Asinh, Abs].map(|f| unary(f, &real)));
    list.extend([Exp, Exp2, ExpM1, Sin, Cos, Sinh, Cosh, Tanh].map(|f| unary(f, &narrow)));
    list.extend([Asin, Acos, Atanh].map(|f| unary(f, &within)));
    list.extend([2.7, -1.3, 0.2, 0.5, -1.5, 0.75, -0.25, 1.0 / 3.0].map(|p| power(p, &positive)));
    list.extend([1, 2, 3, 4, 5, 6, 7, 9, 12].map(|n| integer_power(n, &real)));
    list.extend([-1, -2, -3, -6, -7].map(|n| integer_power(n, &real)));
    list
}

/// All pairs of points, and each point with its near neighbours on both sides and itself.
fn pairs(points: &[f64]) -> Vec<(f64, f64)> {
    let mut pairs = vec![];
    for (i, &a) in points.iter().enumerate() {
        pairs.extend(points[..i].iter().map(|&b| (a, b)));
        for k in [1, 4, 10, 20, 30, 40, 48, 52] {
            let toward = if a.abs() < 1.0 {
                a * (1.0 - 2f64.powi(-k))
            } else {
                a - a.signum() * 2f64.powi(-k).min(a.abs() - 1.0)
            };
            pairs.push((a, toward));
        }
        pairs.push((a, a));
    }
    pairs
}

/// f[a, b] exactly; f′ as its value for neighbours that no other arithmetic here can tell apart.
fn exact(f: &dyn Fn(&Big) -> Big, a: &Big, b: &Big) -> Big {
    if a == b {
        let step = a.times(&big(2f64.powi(-80)));
        let (low, high) = (a.minus(&step), a.plus(&step));
        return f(&high).minus(&f(&low)).over(&high.minus(&low));
    }
    f(b).minus(&f(a)).over(&b.minus(a))
}

/// 1 + |a ∂ₐ log s| + |b ∂_b log s|: by how much s changes, relatively, when s, a and b do.
fn condition(f: &dyn Fn(&Big) -> Big, a: f64, b: f64, s: &Big) -> f64 {
    let wider = |x: f64| big(x).times(&big(1.0 + 2f64.powi(-40)));
    let moved = [exact(f, &wider(a), &big(b)), exact(f, &big(a), &wider(b))];
    let scale = 2f64.powi(40);
    1.0 + moved.iter().map(|m| (narrow(&m.minus(s).over(s)) * scale).abs()).sum::<f64>()
}

struct Ends {
    graph: Graph,
    secant: Expr,
    a: Symbol,
    b: Symbol,
}

impl Ends {
    fn new(build: &dyn Fn(E) -> E) -> Self {
        let mut graph = Graph::new();
        let [x, a, b] = ["x", "a", "b"].map(|name| graph.coordinate(name));
        let u = E(graph.symbol(x));
        let phi = within(&mut graph, || build(u)).0;
        let mut ends = TwoPoints::new(&mut graph, &[x], &[a], &[b]);
        let secant = calculus::discrete_gradient(&mut graph, phi, &mut ends)[0];
        Self { graph, secant, a, b }
    }

    fn at(&self, a: f64, b: f64) -> f64 {
        evaluate(&self.graph, self.secant, |s| {
            if s == self.a {
                a
            } else {
                assert!(s == self.b);
                b
            }
        })
    }
}

/// Within 5 ulp of the exact value, times its condition: what rounding a, b and the result alone may do.
#[test]
fn divided_differences_are_accurate_over_the_domain() {
    println!("{:>8}  {:>10} {:>10}  worst at", "f", "ulp", "ulp/cond");
    let mut failures = vec![];
    for function in functions() {
        let ends = Ends::new(&function.build);
        let (raw, scaled) = (Worst::new(), Worst::new());
        for (a, b) in pairs(&function.points) {
            let s = exact(&function.exact, &big(a), &big(b));
            let computed = ends.at(a, b);
            let magnitude = narrow(&s).abs();
            let error = if computed.is_finite() { narrow(&big(computed).minus(&s)).abs() } else { f64::INFINITY };
            let place = || format!("a = {a:e}, b = {b:e}: {computed:e}");
            let (error, condition) = if magnitude > f64::MIN_POSITIVE {
                (error / (2.0 * U * magnitude), condition(&function.exact, a, b, &s))
            } else {
                (if error == 0.0 { 0.0 } else { error / f64::MIN_POSITIVE }, 1.0)
            };
            raw.see(error, place);
            scaled.see(error / condition, place);
        }
        println!(
            "{:>8}  {:>10.1} {:>10.2}  {} ({} pairs)",
            function.name,
            raw.figure(),
            scaled.figure(),
            scaled.place(),
            scaled.seen()
        );
        if scaled.figure() > 5.0 {
            failures.push(function.name);
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}

/// Where the domain of a function ends its slope is infinite, and 1 − u has all its digits: so has the secant between two places
/// next to that end, whatever rounding them would do.
#[test]
fn ends_of_a_domain_take_no_digits() {
    let worst = Worst::new();
    for (f, side) in [(Unary::Asin, -1.0), (Unary::Acos, -1.0), (Unary::Atanh, -1.0), (Unary::Acosh, 1.0)] {
        let ends = Ends::new(&|u| u.of(f));
        for gap in (0..44).map(|k| 2f64.powi(-k - 4)) {
            for part in [0.3, 0.7, 0.999, 1.0] {
                let [a, b] = [gap, part * gap].map(|gap| 1.0 + side * gap);
                let s = exact(&|x| x.unary(f), &big(a), &big(b));
                let error = narrow(&big(ends.at(a, b)).minus(&s)).abs() / (2.0 * U * narrow(&s).abs());
                worst.see(error, || format!("{f:?}[{a}, {b}]"));
            }
        }
    }
    // Between places of which one is much nearer to the end atanh has the quotient of its values.
    worst.at_most(16.0, "ulp of a secant next to an end");
}

/// A power whose exponent is a parameter may be an integer: then u may be negative, and its secant has its digits there too.
#[test]
fn powers_of_parameters_keep_their_digits_on_both_sides() {
    let worst = Worst::new();
    for (k, n) in [(0, 1), (1, 2), (2, 3)] {
        let mut law = Law::build(1, |q, p| q[0].powf(p[k].of(Unary::Round)));
        let kernels = law.kernels();
        for (a, b) in pairs(&[-31.0, -2.7, -0.4, -1e-7, 1e-9, 0.07, 1.3, 4.1e3]) {
            let s = exact(&|x| x.power(n), &big(a), &big(b));
            let computed = kernels.pointwise.discrete_gradient.run(law.at(&[a], &[b]))[0];
            let turned = kernels.pointwise.discrete_gradient.run(law.at(&[b], &[a]))[0];
            assert_eq!(computed, turned, "{a} and {b}");
            // Between places of which one is nearly the opposite of the other it is a difference.
            let size = narrow(&s).abs().max(a.abs().max(b.abs()).powi(n - 1));
            worst.see(narrow(&big(computed).minus(&s)).abs() / (2.0 * U * size), || format!("u^{n} at {a} and {b}"));
        }
    }
    worst.at_most(16.0, "ulp of a secant");
}
