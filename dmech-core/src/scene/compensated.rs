//! Vectors of many bodies with the rounding errors of their sums.

use dmech_scalar::two_sum;

use super::vectors::Vectors;

/// hi + lo, where hi is the value and lo what rounding took from it so far.
#[derive(Clone, Debug, PartialEq)]
pub struct CompensatedVectors<const D: usize> {
    /// The value.
    pub hi: Vectors<D>,
    /// What is missing.
    pub lo: Vectors<D>,
}

impl<const D: usize> CompensatedVectors<D> {
    /// The vectors themselves.
    pub fn new(hi: Vectors<D>) -> Self {
        let lo = Vectors::zeros(hi.bodies());
        CompensatedVectors { hi, lo }
    }

    /// Whether every component is finite.
    pub fn is_finite(&self) -> bool {
        self.hi.is_finite()
    }

    /// Component i with its low part.
    #[inline]
    pub(super) fn sum(&self, i: usize) -> f64 {
        self.hi.flat()[i] + self.lo.flat()[i]
    }

    /// self − before, component i.
    #[inline]
    pub(super) fn since(&self, before: &Self, i: usize) -> f64 {
        (self.hi.flat()[i] - before.hi.flat()[i]) + (self.lo.flat()[i] - before.lo.flat()[i])
    }

    /// self += (i ↦ change).
    #[inline]
    pub(super) fn add(&mut self, change: impl Fn(usize) -> f64) {
        for (i, (hi, lo)) in self.hi.flat_mut().iter_mut().zip(self.lo.flat_mut()).enumerate() {
            (*hi, *lo) = two_sum(*hi, *lo + change(i));
        }
    }
}
