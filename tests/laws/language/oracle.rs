//! The user's method as the judge of what is generated from it.

use dmech::prelude::*;

/// Reproducible numbers in (−1, 1).
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn throw(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn near<const D: usize>(&mut self, q: [f64; D], radius: f64) -> [f64; D] {
        q.map(|x| x + radius * self.throw())
    }
}

impl Default for Dice {
    fn default() -> Self {
        Self(0x9e37_79b9_7f4a_7c15)
    }
}

/// ∂f/∂xᵢ by differences of fourth order.
pub(crate) fn slope<const D: usize>(f: impl Fn([f64; D]) -> f64, x: [f64; D], i: usize) -> f64 {
    let h = 1e-3;
    let at = |s: f64| {
        let mut x = x;
        x[i] += s * h;
        f(x)
    };
    (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h)
}

/// The generated potential is the declared one, its gradient and Hessian are the slopes, and the discrete gradient takes
/// exactly the declared differences of energy, over any gap.
pub(crate) fn agrees<const D: usize>(
    name: &str,
    law: &impl Potential<D>,
    declared: impl Fn([f64; D]) -> f64,
    centre: [f64; D],
    radius: f64,
) {
    let mut dice = Dice::default();
    let (mut moved, mut felt) = (0.0_f64, 0.0_f64);
    for round in 0..40 {
        let a = dice.near(centre, 0.5 * radius);
        let value = declared(a);
        let close = |generated: f64, expected: f64, tolerance: f64, what: &str| {
            let scale = 1.0 + value.abs() + expected.abs();
            let miss = (generated - expected).abs();
            assert!(miss <= tolerance * scale, "{name}: {what} at {a:?} is {generated:e}, expected {expected:e}");
        };
        close(law.potential(a), value, 16.0 * f64::EPSILON, "the potential");
        let (gradient, hessian) = (law.gradient(a), law.hessian(a));
        for i in 0..D {
            close(gradient[i], slope(&declared, a, i), 1e-8, "the gradient");
            felt = felt.max(gradient[i].abs());
            for j in 0..D {
                close(hessian[i][j], slope(|x| law.gradient(x)[i], a, j), 1e-7, "the Hessian");
            }
        }
        let b = dice.near(a, 0.5 * radius * 0.3_f64.powi(round % 12));
        let discrete = law.discrete_gradient(a, b);
        let secant: f64 = (0..D).map(|i| discrete[i] * (b[i] - a[i])).sum();
        close(secant, declared(b) - value, 32.0 * f64::EPSILON, "the secant identity");
        let limit = law.discrete_gradient(a, a);
        for i in 0..D {
            close(limit[i], gradient[i], 64.0 * f64::EPSILON, "the limit of the discrete gradient");
        }
        moved = moved.max((declared(b) - value).abs());
    }
    assert!(moved > 1e-3 && felt > 1e-3, "{name}: a constant potential shows nothing");
}
