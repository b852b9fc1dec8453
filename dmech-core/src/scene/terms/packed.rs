//! One body at a time or eight.

use dmech_scalar::{Lanes, Real};

/// A scalar that is loaded from consecutive numbers of a column, as many as it has lanes.
pub trait Packed: Real {
    /// column[i], …
    fn load(column: &[f64], i: usize) -> Self;
    /// column[i], … = self.
    fn store(self, column: &mut [f64], i: usize);
    /// column[i], … += self.
    fn add_to(self, column: &mut [f64], i: usize);
}

impl Packed for f64 {
    #[inline(always)]
    fn load(column: &[f64], i: usize) -> f64 {
        column[i]
    }

    #[inline(always)]
    fn store(self, column: &mut [f64], i: usize) {
        column[i] = self;
    }

    #[inline(always)]
    fn add_to(self, column: &mut [f64], i: usize) {
        column[i] += self;
    }
}

impl Packed for Lanes {
    #[inline(always)]
    fn load(column: &[f64], i: usize) -> Lanes {
        Lanes::from_slice(&column[i..])
    }

    #[inline(always)]
    fn store(self, column: &mut [f64], i: usize) {
        Lanes::store(self, &mut column[i..]);
    }

    #[inline(always)]
    fn add_to(self, column: &mut [f64], i: usize) {
        (Lanes::from_slice(&column[i..]) + self).store(&mut column[i..]);
    }
}
