//! Vectors of many bodies with the rounding errors of their sums.

use dmech_scalar::two_sum;

use super::vectors::Vectors;

/// hi + lo, where hi is the value and lo what rounding took from it so far.
#[derive(Debug, PartialEq)]
pub struct CompensatedVectors<const D: usize> {
    /// The value.
    pub hi: Vectors<D>,
    /// What is missing.
    pub lo: Vectors<D>,
}

impl<const D: usize> Clone for CompensatedVectors<D> {
    fn clone(&self) -> Self {
        CompensatedVectors { hi: self.hi.clone(), lo: self.lo.clone() }
    }

    /// Without a new allocation.
    fn clone_from(&mut self, other: &Self) {
        self.hi.clone_from(&other.hi);
        self.lo.clone_from(&other.lo);
    }
}

impl<const D: usize> CompensatedVectors<D> {
    /// The vectors themselves.
    pub fn new(hi: Vectors<D>) -> Self {
        let lo = Vectors::zeros(hi.bodies());
        CompensatedVectors { hi, lo }
    }

    /// The values and what is missing, to be written to.
    #[cfg(feature = "serde")]
    pub(super) fn parts_mut(&mut self) -> [&mut [f64]; 2] {
        [self.hi.flat_mut(), self.lo.flat_mut()]
    }

    /// Adds (i ↦ change).
    #[inline]
    pub(super) fn add(&mut self, change: impl Fn(usize) -> f64) {
        let parts = self.hi.flat_mut().iter_mut().zip(self.lo.flat_mut()).enumerate();
        for (i, (hi, lo)) in parts {
            (*hi, *lo) = two_sum(*hi, change(i) + *lo);
        }
    }

    /// self − before, component i.
    #[inline]
    pub(super) fn since(&self, before: &Self, i: usize) -> f64 {
        (self.hi.flat()[i] - before.hi.flat()[i]) + (self.lo.flat()[i] - before.lo.flat()[i])
    }

    /// As [`CompensatedVectors::kick_and_drift`] with a change in two parts, of which the second may be too small to change
    /// the first, for steps that conserve the energy: what each sum leaves out is carried on.
    #[inline]
    pub(super) fn kick_in_parts_and_drift(
        q: &mut Self,
        v: &mut Self,
        h: f64,
        share: f64,
        change: impl Fn(usize) -> [f64; 2],
    ) {
        let places = q.hi.flat_mut().iter_mut().zip(q.lo.flat_mut());
        let speeds = v.hi.flat_mut().iter_mut().zip(v.lo.flat_mut());
        for (i, ((q, q_low), (v, v_low))) in places.zip(speeds).enumerate() {
            let [change, late] = change(i);
            let moved = h * (*v + (share * change + (share * late + *v_low)));
            (*q, *q_low) = two_sum(*q, *q_low + moved);
            let (change, rest) = two_sum(change, late + *v_low);
            let (high, low) = two_sum(*v, change);
            (*v, *v_low) = (high, low + rest);
        }
    }

    /// v += (i ↦ change) and q += h (v + share·change), with v as it was, in one pass.
    ///
    /// The change is rounded once, and the sum formed before it is multiplied: rounding errors then do work of one sense and
    /// of the other alike, as those of one body do.
    #[inline]
    pub(super) fn kick_and_drift(q: &mut Self, v: &mut Self, h: f64, share: f64, change: impl Fn(usize) -> f64) {
        let places = q.hi.flat_mut().iter_mut().zip(q.lo.flat_mut());
        let speeds = v.hi.flat_mut().iter_mut().zip(v.lo.flat_mut());
        for (i, ((q, q_low), (v, v_low))) in places.zip(speeds).enumerate() {
            let change = change(i);
            let moved = h * (*v + (share * change + *v_low));
            (*q, *q_low) = two_sum(*q, *q_low + moved);
            (*v, *v_low) = two_sum(*v, *v_low + change);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::CompensatedVectors;
    use crate::scene::vectors::Vectors;

    /// A hundredth of an ulp of each change, too small to change it, adds up.
    #[test]
    fn the_second_part_of_a_change_is_carried_on() {
        let mut q = CompensatedVectors::new(Vectors::<1>::zeros(1));
        let mut v = q.clone();
        let (change, late, kicks) = (0.375, 0.375 * 0.01 * f64::EPSILON, 100_000);
        for _ in 0..kicks {
            CompensatedVectors::kick_in_parts_and_drift(&mut q, &mut v, 0.5, 0.5, |_| [change, late]);
        }
        let kicks = f64::from(kicks);
        let added = (v.hi.flat()[0] - kicks * change) + v.lo.flat()[0];
        assert!((added / (kicks * late) - 1.0).abs() < 1e-3, "{added:e} of {:e}", kicks * late);
        let moved = 0.25 * kicks * kicks * change;
        let sum = q.hi.flat()[0] + q.lo.flat()[0];
        assert!((sum / moved - 1.0).abs() < 1e-12, "{sum} for {moved}");
    }
}
