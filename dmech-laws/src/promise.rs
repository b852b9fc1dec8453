//! What may be promised, and what it takes to break it.

use dmech_scalar::DoubleDouble;

/// What was not kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs)]
pub enum Promise {
    Secant,
    Finite,
    Symmetry,
    Limit,
    Gradient,
    Hessian,
    Jacobian,
    Structure,
}

/// A promise that was not kept, with both sides.
#[derive(Clone, Debug)]
pub struct Failure {
    /// Which one.
    pub promise: Promise,
    /// What was computed and what it should be.
    pub words: String,
}

/// What the secant identity may miss, in ulp of its scale.
pub const ULPS: f64 = 8.0;

/// Below this nothing is asked for: products that underflow lose more than roundings.
pub(crate) const UNDERFLOW: f64 = 1e-250;

pub(crate) fn lift(q: &[f64]) -> Vec<DoubleDouble> {
    q.iter().map(|&x| x.into()).collect()
}

pub(crate) fn size_of(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

pub(crate) fn all_finite(values: &[f64]) -> bool {
    values.iter().all(|x| x.is_finite())
}

pub(crate) fn failed(promise: Promise, words: String) -> Result<(), Failure> {
    Err(Failure { promise, words })
}
