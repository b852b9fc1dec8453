//! The position that final positions are compared with.

use dmech_scalar::{DoubleDouble, Real};

use crate::system::vector::finite;

/// q* at the end, and where it is known to more digits than `f64` has, the velocity there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Truth<const D: usize> {
    q: [DoubleDouble; D],
    v: [DoubleDouble; D],
}

impl<const D: usize> Truth<D> {
    /// A position in `f64`.
    pub(super) fn new(q: [f64; D]) -> Self {
        Truth { q: q.map(DoubleDouble::from), v: [DoubleDouble::ZERO; D] }
    }

    /// A position to all digits, and the velocity.
    pub(super) fn precise(q: [DoubleDouble; D], v: [DoubleDouble; D]) -> Self {
        Truth { q, v }
    }

    /// q*, rounded.
    pub(super) fn position(&self) -> [f64; D] {
        self.q.map(Real::to_f64)
    }

    /// |q − q* − v* late|, with q reached a little later than the end; `None` where it is not finite.
    ///
    /// `late` is a rounding error of the time, and what the velocity changes in it is one of a rounding error.
    pub(super) fn distance(&self, q: &[f64; D], late: f64) -> Option<f64> {
        let late = DoubleDouble::from(late);
        let apart = |i: usize| (DoubleDouble::from(q[i]) - late.mul_add(self.v[i], self.q[i])).to_f64();
        let distance = (0..D).fold(0.0_f64, |sum, i| sum.hypot(apart(i)));
        (finite(*q) && distance.is_finite()).then_some(distance)
    }
}
