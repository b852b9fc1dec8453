//! Quotients whose numerator grows like their denominator: the terms of the slope that cancel far out are not formed.

use crate::common::laws::Law;
use crate::common::notation::{E, norm, squared};

/// In coordinates and parameters.
type Formula = fn(&[E], &[E]) -> E;

/// The slope as it is on paper, in coordinates and without a difference.
type Slope = fn(f64, f64) -> f64;

/// The slope along the first coordinate of laws that level off, within 8 ulp from near to so far out that the method's own value no
/// longer changes; as two fractions it has lost half of its digits at 10⁴ and all at 10⁸.
#[test]
fn slopes_keep_their_digits_far_out() {
    let laws: [(&str, usize, Formula, Slope); 9] = [
        ("q²/(1 + q²)", 1, |q, _| q[0].powi(2) / (1.0 + q[0].powi(2)), |x, _| 2.0 * x / (1.0 + x * x) / (1.0 + x * x)),
        (
            "(q/p)²/(1 + (q/p)²)",
            1,
            |q, p| (q[0] / p[1]).powi(2) / (1.0 + (q[0] / p[1]).powi(2)),
            |x, _| {
                let s = 1.0 + (x / 1.9) * (x / 1.9);
                2.0 * x / (1.9 * 1.9) / s / s
            },
        ),
        (
            "p q²/(1 + (q/p)²)",
            1,
            |q, p| p[0] * q[0].powi(2) / (1.0 + (q[0] / p[1]).powi(2)),
            |x, _| {
                let s = 1.0 + (x / 1.9) * (x / 1.9);
                2.0 * 0.7 * x / s / s
            },
        ),
        (
            "p q²/(p + q²)",
            1,
            |q, p| p[0] * q[0].powi(2) / (p[1] + q[0].powi(2)),
            |x, _| 2.0 * 0.7 * 1.9 * x / (1.9 + x * x) / (1.9 + x * x),
        ),
        (
            "(q² − 1)/(q² + 1)",
            1,
            |q, _| (q[0].powi(2) - 1.0) / (q[0].powi(2) + 1.0),
            |x, _| 4.0 * x / (1.0 + x * x) / (1.0 + x * x),
        ),
        (
            "q/√(1 + q²)",
            1,
            |q, _| q[0] / (1.0 + q[0].powi(2)).sqrt(),
            |x, _| 1.0 / (1.0 + x * x) / (1.0 + x * x).sqrt(),
        ),
        (
            "|q|²/(1 + |q|²)",
            2,
            |q, _| squared(q) / (1.0 + squared(q)),
            |x, y| {
                let s = 1.0 + x * x + y * y;
                2.0 * x / s / s
            },
        ),
        (
            "|q|/(1 + |q|)",
            2,
            |q, _| norm(q) / (1.0 + norm(q)),
            |x, y| {
                let r = (x * x + y * y).sqrt();
                x / r / (1.0 + r) / (1.0 + r)
            },
        ),
        (
            "x/|q|",
            2,
            |q, _| q[0] / norm(q),
            |x, y| {
                let s = x * x + y * y;
                y * y / s / s.sqrt()
            },
        ),
    ];
    for (name, dimension, formula, slope) in laws {
        let mut law = Law::build(dimension, formula);
        let kernels = law.kernels();
        let mut worst = 0.0_f64;
        for k in -20..=75 {
            let x = 1.234 * 10_f64.powi(k);
            let y = 0.37 * x.min(1e3);
            let q = &[x, y][..dimension];
            let exact = slope(x, y);
            let [gradient, secant] = [&kernels.pointwise.gradient, &kernels.pointwise.discrete_gradient]
                .map(|kernel| kernel.run(law.at(q, q))[0]);
            // What cancels between two roots is no term of a sum.
            let rational = !name.contains('√') && !name.starts_with("x/");
            for found in [gradient, if rational { secant } else { gradient }] {
                worst = worst.max((found / exact - 1.0).abs() / f64::EPSILON);
                assert!(worst <= 8.0, "{name} at {x:e}: {found:e} for {exact:e}");
            }
        }
        println!("{name:>18}: {worst:.1} ulp");
    }
}

/// Between two places, (a + b)/((1 + a²)(1 + b²)): symmetric to the bit, as near as the places may be.
#[test]
fn secants_keep_their_digits_far_out() {
    let mut law = Law::build(1, |q, _| q[0].powi(2) / (1.0 + q[0].powi(2)));
    let kernels = law.kernels();
    for a in [-3e4, 0.2, 1.7, 5e6, 2e40] {
        for b in [a * (1.0 + 1e-9), 1.5 * a, -2.0 * a, 0.1] {
            let exact = (a + b) / (1.0 + a * a) / (1.0 + b * b);
            let [there, back] =
                [(a, b), (b, a)].map(|(a, b)| kernels.pointwise.discrete_gradient.run(law.at(&[a], &[b]))[0]);
            assert!((there / exact - 1.0).abs() < 8.0 * f64::EPSILON, "{a} to {b}: {there:e} for {exact:e}");
            assert_eq!(there, back, "{a} to {b}");
        }
    }
}
