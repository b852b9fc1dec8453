//! Numbers that know their rounding errors to first order: a running error analysis of one formula.
//!
//! The error, in roundings u, is what may be off when every operation of the formula as written rounds once, whatever the
//! order of sums and products and whether multiply-adds are fused or not. A formula that cancels has a large error of
//! this kind: the figure tells whether a program computes its formula, not whether the formula is good.

use dmech_symbolic::expression::Unary;
use num_dual::Dual64;

use super::algebra::{Algebra, Dual};

#[derive(Clone, Copy, Debug)]
pub(crate) struct Tracked {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

impl Tracked {
    /// Slopes times the errors of the arguments, and a rounding.
    fn new(value: f64, parts: &[(f64, f64)]) -> Self {
        let inherited = parts.iter().map(|(slope, error)| if *error == 0.0 { 0.0 } else { (slope * error).abs() });
        Self { value, error: value.abs() + inherited.sum::<f64>() }
    }
}

fn slope(f: impl Fn(Dual<Dual64>) -> Dual<Dual64>, x: f64) -> f64 {
    f(Dual(Dual64::from_re(x).derivative())).0.eps
}

impl Algebra for Tracked {
    fn number(value: f64) -> Self {
        Self { value, error: 0.0 }
    }
    fn plus(&self, other: &Self) -> Self {
        // Not the sum: in another order it may be reached over larger ones.
        let mut sum = Self::new(self.value + other.value, &[(1.0, self.error), (1.0, other.error)]);
        sum.error += self.value.abs() + other.value.abs() - sum.value.abs();
        sum
    }
    fn minus(&self, other: &Self) -> Self {
        self.plus(&Self { value: -other.value, ..*other })
    }
    fn times(&self, other: &Self) -> Self {
        Self::new(self.value * other.value, &[(other.value, self.error), (self.value, other.error)])
    }
    fn over(&self, other: &Self) -> Self {
        let quotient = self.value / other.value;
        let mut tracked =
            Self::new(quotient, &[(1.0 / other.value, self.error), (quotient / other.value, other.error)]);
        // As a product with a reciprocal: one rounding more.
        tracked.error += quotient.abs();
        tracked
    }
    fn less(&self, other: &Self) -> bool {
        self.value < other.value
    }
    fn unary(&self, f: Unary) -> Self {
        let slope = if self.error == 0.0 { 0.0 } else { slope(|x| x.unary(f), self.value) };
        let mut tracked = Self::new(f.apply(self.value), &[(slope, self.error)]);
        tracked.error += tracked.value.abs();
        tracked
    }
    fn powf(&self, p: &Self) -> Self {
        let value = self.value.powf(p.value);
        Self::new(2.0 * value, &[(p.value * value / self.value, self.error), (value * self.value.ln(), p.error)])
            .halved(value)
    }
    fn atan2(&self, x: &Self) -> Self {
        let r2 = self.value * self.value + x.value * x.value;
        let value = self.value.atan2(x.value);
        Self::new(2.0 * value, &[(x.value / r2, self.error), (self.value / r2, x.error)]).halved(value)
    }
}

impl Tracked {
    fn halved(self, value: f64) -> Self {
        Self { value, ..self }
    }
}
