//! Gradients and Hessians against dual numbers and 77 digits: every function over its domain, and random laws.

use crate::common::algebra::{Algebra, Big, Dual, big, narrow};
use crate::common::bounds::bound;
use crate::common::evaluate::evaluate;
use crate::common::laws::{Law, cases};
use crate::common::tracked::Tracked;
use crate::common::{U, Worst, for_all, ratio};
use dmech_symbolic::calculus;
use dmech_symbolic::expression::{Binary, Expr, Graph, Unary, evaluate as interpret};
use num_dual::{Dual2_64, HyperDual64};

/// f, f′, f″ by central differences whose errors are below 1e-25.
fn differences(f: &dyn Fn(&Big) -> Big, x: f64) -> [f64; 3] {
    let h = big(2f64.powi(-50) * x.abs().clamp(1e-3, 1.0));
    let x = big(x);
    let (low, at, high) = (f(&x.minus(&h)), f(&x), f(&x.plus(&h)));
    let second = high.plus(&low).minus(&at.plus(&at)).over(&h.times(&h));
    [narrow(&at), narrow(&high.minus(&low).over(&h.plus(&h))), narrow(&second)]
}

/// Where each function is tried; the engine's own primitives too.
fn points(f: Unary) -> Vec<f64> {
    use Unary::*;
    match f {
        Sqrt | Ln | Log2 | Log10 => vec![1e-3, 0.07, 0.5, 1.0, 1.3, 8.1, 4e3],
        Cbrt => vec![-31.0, -0.4, -2e-3, 3e-3, 0.6, 1.7, 2e4],
        Ln1p => vec![-0.95, -0.3, 1e-3, 0.4, 2.9, 7e3],
        Asin | Acos | Atanh | Atanhc | AtanhcSlope => vec![-0.98, -0.6, -0.05, 0.003, 0.2, 0.55, 0.93],
        Acosh => vec![1.01, 1.3, 2.7, 40.0],
        Tan => vec![-1.4, -0.6, 0.02, 0.5, 1.1, 1.5, 2.2],
        Abs | Signum | Round | Floor | Trunc => vec![-2.3, -0.4, 0.7, 5.1],
        Exp | Exp2 | ExpM1 | Sinh | Cosh | Tanh => vec![-19.0, -2.6, -0.7, 0.01, 0.4, 1.9, 11.0, 17.0],
        _ => vec![-6.1, -2.6, -0.7, 0.05, 0.4, 1.3, 1.9, 5.2],
    }
}

fn derivatives(build: &dyn Fn(&mut Graph, Expr) -> Expr, x: f64) -> [f64; 3] {
    let mut graph = Graph::new();
    let symbol = graph.coordinate("x");
    let u = graph.symbol(symbol);
    let value = build(&mut graph, u);
    let first = calculus::derivative(&mut graph, value, symbol);
    let second = calculus::derivative(&mut graph, first, symbol);
    [value, first, second].map(|e| interpret(&graph, e, |_| x))
}

/// f′ within 2 ulp and f″ within 4 ulp, times the condition 1 + |x f″/f′| and 1 + |x f‴/f″|, of 77 digits, and as
/// near to dual numbers. (num-dual has its own roundings, which is why it is only the second witness.)
#[test]
fn every_function() {
    let mut report = vec![];
    for f in Unary::ALL {
        let (first, second, dual) = (Worst::new(), Worst::new(), Worst::new());
        for x in points(f) {
            let jet = derivatives(&|g, u| g.unary(f, u), x);
            let exact = differences(&|x| x.unary(f), x);
            let near = differences(&|x| x.unary(f), x * (1.0 + 1e-6));
            let twin = Dual(Dual2_64::from_re(x).derivative()).unary(f).0;
            let twin = [twin.re, twin.v1, twin.v2];
            for (order, worst) in [(1, &first), (2, &second)] {
                let condition = |k: usize| exact[k].abs() + (near[k] - exact[k]).abs() * 1e6;
                // The slopes of the cardinal slopes are for completeness: they inherit the values they are made of.
                let own = matches!(f, Unary::SincSlope | Unary::SinhcSlope | Unary::AtancSlope | Unary::AtanhcSlope);
                let scale = condition(order)
                    + if own { 8.0 * exact[0].abs().max(1.0) / x.abs().powi(order as i32) } else { 0.0 };
                let place = || format!("x = {x}: {:e}, exactly {:e}", jet[order], exact[order]);
                worst.see(ratio((jet[order] - exact[order]).abs(), 2.0 * U * scale), place);
                dual.see(ratio((jet[order] - twin[order]).abs(), 2.0 * U * scale), place);
            }
        }
        println!(
            "{:>12}: f′ {:5.2}, f″ {:5.2}, to dual numbers {:5.2}",
            f.method(),
            first.figure(),
            second.figure(),
            dual.figure()
        );
        report.push((f, first, second, dual));
    }
    for (f, first, second, dual) in report {
        assert!(first.figure() <= 2.0, "{f:?}′: {}", first.place());
        assert!(second.figure() <= 4.0, "{f:?}″: {}", second.place());
        assert!(dual.figure() <= 16.0 && dual.seen() > 0, "{f:?}: {}", dual.place());
    }
}

/// Random laws: ∇Φ within the rounding errors of the law (`common::bounds` at a = b), the Hessian within those of its
/// own formula, both against 77 digits and hyper-dual numbers on the law as it was written.
#[test]
fn random_laws() {
    let (slopes, curvatures, dual, hyper) = (Worst::new(), Worst::new(), Worst::new(), Worst::new());
    for_all(250, &cases(), |case| {
        let (q, d) = (&case.a, case.dimension());
        let mut law = Law::new(&case.tree, d);
        let kernels = law.kernels();
        let name = || format!("{} at {q:?}", law.graph.display(law.phi));
        let at = law.at(q, q);
        let gradient = kernels.pointwise.gradient.run(&at);
        let hessian = kernels.pointwise.hessian.run(&at);
        let allowed = bound(&case.tree, q, q).error;
        let value = |i: usize, si: f64, j: usize, sj: f64| {
            let mut at: Vec<_> = q.iter().map(|&x| big(x)).collect();
            at[i] = at[i].plus(&big(si));
            at[j] = at[j].plus(&big(sj));
            case.tree.evaluate(&at)
        };
        let h = 2f64.powi(-50);
        let hh = big(h).times(&big(h));
        for i in 0..d {
            let exact = narrow(&value(i, h, i, 0.0).minus(&value(i, -h, i, 0.0)).over(&big(2.0 * h)));
            slopes.see(ratio((gradient[i] - exact).abs(), U * allowed[i]), name);
            for j in 0..=i {
                let lift = |k: usize, x: f64| {
                    let mut number = HyperDual64::from_re(x);
                    number.eps1 = f64::from(u8::from(k == i));
                    number.eps2 = f64::from(u8::from(k == j));
                    Dual(number)
                };
                let twin = case.tree.evaluate(&q.iter().enumerate().map(|(k, &x)| lift(k, x)).collect::<Vec<_>>()).0;
                dual.see(ratio((gradient[i] - twin.eps1).abs(), U * allowed[i]), name);
                let expression = kernels.formulas.hessian[i][j];
                let tracked = evaluate(
                    &law.graph,
                    &[expression],
                    &law.values(Tracked::number, &q.iter().map(|&x| Tracked::number(x)).collect::<Vec<_>>(), &[], &[]),
                )[0];
                // In the order of errors of the law itself: an exact 0 may be a difference to hyper-dual numbers.
                let scale = U * (tracked.error + tracked.value.abs());
                hyper.see(ratio((hessian[i * d + j] - twin.eps1eps2).abs(), scale + 4.0 * U * allowed[i]), name);
                let exact = if i == j {
                    let (low, mid, high) = (value(i, -h, i, 0.0), value(i, 0.0, i, 0.0), value(i, h, i, 0.0));
                    high.plus(&low).minus(&mid.plus(&mid)).over(&hh)
                } else {
                    let same = value(i, h, j, h).plus(&value(i, -h, j, -h));
                    let cross = value(i, h, j, -h).plus(&value(i, -h, j, h));
                    same.minus(&cross).over(&hh.times(&big(4.0)))
                };
                let exact = narrow(&exact);
                // The differences themselves are exact to 1e-25.
                curvatures.see(ratio((hessian[i * d + j] - exact).abs(), scale + 1e-25), name);
                assert_eq!(hessian[i * d + j].to_bits(), hessian[j * d + i].to_bits(), "{}", name());
            }
        }
    });
    slopes.at_most(2.0, "gradient against 77 digits, roundings");
    dual.at_most(4.0, "gradient against dual numbers, roundings");
    curvatures.at_most(2.0, "Hessian against 77 digits, roundings");
    hyper.at_most(8.0, "Hessian against hyper-dual numbers, roundings");
}

/// A power whose exponent moves, and the angle, in both arguments.
#[test]
fn functions_of_two_arguments() {
    let worst = Worst::new();
    for (f, points) in [
        (Binary::Powf, vec![(0.3, 1.7), (2.9, -0.6), (7.1, 3.3)]),
        (Binary::Atan2, vec![(0.3, 1.7), (-2.9, -0.6), (7.1, -3.3), (-0.4, 0.2)]),
        (Binary::Min, vec![(0.3, 1.7), (2.9, -0.6)]),
        (Binary::Max, vec![(0.3, 1.7), (2.9, -0.6)]),
    ] {
        for (x, y) in points {
            let mut graph = Graph::new();
            let symbols = [graph.coordinate("x"), graph.coordinate("y")];
            let [u, w] = symbols.map(|s| graph.symbol(s));
            let value = graph.binary(f, u, w);
            let gradient = calculus::gradient(&mut graph, value, &symbols);
            for (i, slope) in gradient.into_iter().enumerate() {
                let computed = interpret(&graph, slope, |s| if s == symbols[0] { x } else { y });
                let h = 2f64.powi(-50);
                let at = |step: f64| {
                    let mut p = [big(x), big(y)];
                    p[i] = p[i].plus(&big(step));
                    p[0].binary(f, &p[1])
                };
                let exact = narrow(&at(h).minus(&at(-h)).over(&big(2.0 * h)));
                worst.see(ratio((computed - exact).abs(), 2.0 * U * exact.abs()), || format!("{f:?} {x} {y}"));
            }
        }
    }
    worst.at_most(4.0, "∂f/∂u, ∂f/∂w, ulp");
}
