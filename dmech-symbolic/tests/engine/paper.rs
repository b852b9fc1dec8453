//! The discrete forces that Kanatani printed, as expressions: the engine derives the same ones.

use crate::common::laws::Law;
use crate::common::notation::{E, norm, squared, within};
use dmech_symbolic::expression::Symbol;
use dmech_symbolic::kernel::{Kernels, Way};

type Potential = fn(&[E], &[E]) -> E;

fn kernels(dimension: usize, phi: Potential) -> (Law, Kernels) {
    let mut law = Law::build(dimension, phi);
    let kernels = law.kernels();
    (law, kernels)
}

/// Asserts that the derived discrete gradient is the expression printed, component by component.
fn check(dimension: usize, phi: Potential, printed: impl Fn(E, &[E], &[E], usize) -> E) -> Kernels {
    let (mut law, kernels) = kernels(dimension, phi);
    let mut list = |names: &[Symbol]| names.iter().map(|&s| E(law.graph.symbol(s))).collect::<Vec<_>>();
    let (a, b) = (list(&law.variables.a), list(&law.variables.b));
    let k = E(law.graph.symbol(law.parameters[0]));
    for (i, &derived) in kernels.formulas.discrete_gradient.iter().enumerate() {
        let force = within(&mut law.graph, || printed(k, &a, &b, i)).0;
        assert_eq!(derived, force, "{} for {}", law.graph.display(derived), law.graph.display(force));
    }
    kernels
}

/// (3.16)–(3.19): for Φ = k r²/2 the force is −k (a + b)/2, in any number of dimensions and however r² is written.
#[test]
fn linear_oscillation_is_3_18() {
    let ways: [Potential; 3] = [
        |q, k| k[0] * squared(q) / 2.0,
        |q, k| 0.5 * k[0] * norm(q) * norm(q),
        |q, k| norm(q).powf(2.0) * (k[0] / 2.0),
    ];
    for dimension in 1..=4 {
        for phi in ways {
            let kernels = check(dimension, phi, |k, a, b, i| k * ((a[i] + b[i]) / 2.0));
            assert!([kernels.discrete.way, kernels.implicit.way] == [Way::Linear; 2]);
        }
    }
}

/// (3.23)–(3.27): for Φ = −k/r the force is −k n̄/r̄², r̄² = |a||b|, n̄ = (a + b)/(|a| + |b|).
#[test]
fn inverse_square_law_is_3_25() {
    let ways: [Potential; 3] = [
        |q, k| -k[0] / norm(q),
        |q, k| -(k[0] * squared(q).powf(-0.5)),
        |q, k| -1.0 * (k[0] / q[1..].iter().fold(q[0], |r, &x| r.hypot(x))),
    ];
    for dimension in 2..=4 {
        for phi in ways {
            let kernels = check(dimension, phi, |k, a, b, i| {
                let mean_direction = (a[i] + b[i]) / (norm(a) + norm(b));
                let mean_distance = (norm(a) * norm(b)).sqrt();
                k * mean_direction / mean_distance.powi(2)
            });
            assert!([kernels.discrete.way, kernels.implicit.way] == [Way::Central; 2]);
        }
    }
}

/// On a line r is |x|, and (3.25) is k/(a b) with the sign of the side; the two ends are on one side.
#[test]
fn inverse_square_law_on_a_line() {
    let (law, kernels) = kernels(1, |q, k| -k[0] / norm(q));
    for (a, b) in [(0.3_f64, 1.1_f64), (-0.4, -2.9), (0.7, 0.7), (0.7, 0.7000000001)] {
        let force = 0.7 * (a + b) / ((a * b).abs() * (a.abs() + b.abs()));
        let derived = kernels.pointwise.discrete_gradient.run(law.at(&[a], &[b]))[0];
        assert!((derived - force).abs() <= 4.0 * f64::EPSILON * force.abs(), "{derived} {force}");
    }
}
