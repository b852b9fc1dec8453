//! The position that final positions are compared with.

use dmech_core::extend::{DoubleDouble, Real};

use crate::motion::norm;

/// q* at the end, and where it is known to more digits than `f64` has, the velocity there.
#[derive(Clone, Debug)]
pub(super) struct Truth {
    q: Vec<DoubleDouble>,
    v: Vec<DoubleDouble>,
}

impl Truth {
    /// A position in `f64`.
    pub(super) fn new(q: &[f64]) -> Self {
        let q: Vec<_> = q.iter().copied().map(DoubleDouble::from).collect();
        Truth { v: vec![DoubleDouble::ZERO; q.len()], q }
    }

    /// A position to all digits, and the velocity.
    pub(super) fn precise(q: &[DoubleDouble], v: &[DoubleDouble]) -> Self {
        Truth { q: q.to_vec(), v: v.to_vec() }
    }

    /// q*, rounded.
    pub(super) fn position(&self) -> Vec<f64> {
        self.q.iter().map(|x| x.to_f64()).collect()
    }

    /// |q − q* − v* late|, with q reached a little later than the end; `None` where it is not finite.
    ///
    /// `late` is a rounding error of the time, and what the velocity changes in it is one of a rounding error.
    pub(super) fn distance(&self, q: &[f64], late: f64) -> Option<f64> {
        let late = DoubleDouble::from(late);
        let here = self.q.iter().zip(&self.v).map(|(q, v)| late.mul_add(*v, *q));
        let apart = q.iter().zip(here).map(|(q, here)| (DoubleDouble::from(*q) - here).to_f64());
        let distance = norm(apart);
        (q.iter().all(|x| x.is_finite()) && distance.is_finite()).then_some(distance)
    }
}
