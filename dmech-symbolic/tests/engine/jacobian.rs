//! ∂∇̄Φ(a, b)/∂b: the derivative of the discrete gradient, to all digits; computed without cancellation at every gap;
//! half the Hessian where the points meet.

use crate::common::algebra::{Algebra, Big, Dual, big, narrow};
use crate::common::evaluate::evaluate;
use crate::common::laws::{Case, Law, cases};
use crate::common::tracked::Tracked;
use crate::common::{U, Worst, for_all, ratio};
use dmech_symbolic::expression::Expr;
use num_dual::Dual64;

fn lift<T>(number: impl Fn(f64) -> T, q: &[f64]) -> Vec<T> {
    q.iter().map(|&x| number(x)).collect()
}

/// Expressions between two points over any kind of number.
fn between<T: Algebra>(law: &Law, roots: &[Expr], a: &[T], b: &[T]) -> Vec<T> {
    evaluate(&law.graph, roots, &law.values(T::number, a, a, b))
}

/// The symbolic Jacobian is the derivative of the symbolic discrete gradient: equal to 25 digits to a central
/// difference computed with 77.
#[test]
fn it_is_the_derivative_of_the_discrete_gradient() {
    let worst = Worst::new();
    for_all(60, &cases(), |case| {
        let mut law = Law::new(&case.tree, case.dimension());
        let formulas = law.kernels().formulas;
        let a = lift(big, &case.a);
        for gap in [0.7, 1e-2, 1e-9] {
            let b = lift(big, &case.b(gap));
            let jacobian: Vec<Vec<Big>> =
                formulas.discrete_gradient_jacobian.iter().map(|row| between(&law, row, &a, &b)).collect();
            for j in 0..a.len() {
                let step = 2f64.powi(-55);
                let moved = |step: f64| {
                    let mut b = b.clone();
                    b[j] = b[j].plus(&big(step));
                    between(&law, &formulas.discrete_gradient, &a, &b)
                };
                let (up, down) = (moved(step), moved(-step));
                for i in 0..a.len() {
                    let difference = up[i].minus(&down[i]).over(&big(2.0 * step));
                    let scale = narrow(&difference).abs() + 1e-3;
                    let error = narrow(&difference.minus(&jacobian[i][j])).abs();
                    worst.see(error / scale * 1e25, || format!("{i}{j} of {} gap {gap}", law.graph.display(law.phi)));
                }
            }
        }
    });
    worst.at_most(1.0, "Jacobian against central differences, in units of 1e-25");
}

/// The program in binary64 against dual numbers, which differentiate the discrete gradient operation by operation.
#[test]
fn the_program_agrees_with_dual_numbers() {
    let (dual, limit, growth) = (Worst::new(), Worst::new(), Worst::new());
    for_all(200, &cases(), |case: Case| {
        let d = case.dimension();
        let mut law = Law::new(&case.tree, d);
        let kernels = law.kernels();
        let name = || law.graph.display(law.phi).to_string();
        let jacobian: Vec<Expr> = kernels.formulas.discrete_gradient_jacobian.concat();
        let a = &case.a;
        let mut apart = vec![0.0_f64; d * d];
        for gap in [1.0, 0.3, 1e-1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-16, 0.0] {
            let b = &case.b(gap);
            let computed = kernels.pointwise.discrete_gradient_jacobian.run(law.at(a, b));
            let tracked = between(&law, &jacobian, &lift(Tracked::number, a), &lift(Tracked::number, b));
            for j in 0..d {
                let fixed = lift(|x| Dual(Dual64::from_re(x)), a);
                let mut moving = lift(|x| Dual(Dual64::from_re(x)), b);
                moving[j].0.eps = 1.0;
                let column = between(&law, &kernels.formulas.discrete_gradient, &fixed, &moving);
                for (i, twin) in column.into_iter().enumerate() {
                    let k = i * d + j;
                    let error = (computed[k] - twin.0.eps).abs();
                    let place = || format!("{i}{j} of {} between {a:?} and {b:?}: {}", name(), computed[k]);
                    dual.see(ratio(error, U * (tracked[k].error + tracked[k].value.abs())), place);
                    // Rounding errors may not grow as the points approach one another.
                    if gap >= 0.1 {
                        apart[k] = apart[k].max(tracked[k].error);
                    } else {
                        growth.see(ratio(tracked[k].error, apart[k]), place);
                    }
                }
            }
        }
        let computed = kernels.pointwise.discrete_gradient_jacobian.run(law.at(a, a));
        let hessian = kernels.pointwise.hessian.run(law.at(a, a));
        let tracked = between(&law, &jacobian, &lift(Tracked::number, a), &lift(Tracked::number, a));
        let curvature = between(&law, &kernels.formulas.hessian.concat(), &lift(Tracked::number, a), &[]);
        for k in 0..d * d {
            let scale = U * (tracked[k].error + curvature[k].error);
            limit.see(ratio((computed[k] - hessian[k] / 2.0).abs(), scale), || format!("{k} of {} at {a:?}", name()));
        }
    });
    dual.at_most(2.0, "Jacobian against dual numbers, roundings");
    limit.at_most(2.0, "Jacobian at a = b against half the Hessian, roundings");
    growth.at_most(50.0, "rounding errors of close points to those of distant ones");
}
