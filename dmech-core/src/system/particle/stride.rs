//! The length of a step and the mass that it moves.

use dmech_scalar::{CompensatedVector, Real, two_sum};

use crate::system::stages::{drift, path};
use crate::vector::by_component;

/// Time step and mass, with the coefficients that follow from them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stride<R> {
    /// h, the time step.
    pub dt: R,
    /// m, the mass.
    pub mass: R,
    /// h/m: a whole kick is v − (h/m) ∇Φ.
    pub kick: R,
    /// h²/m, what a kick moves the particle in one step.
    pub fall: R,
    /// 2/h, by which the velocity at the end of a step follows from the increment.
    pub rate: R,
    /// The part of `kick` by which dt·kick exceeds `fall`, in exact arithmetic.
    excess: R,
}

impl<R: Real> Stride<R> {
    /// A step of length dt for a particle of the given mass.
    pub fn new(dt: R, mass: R) -> Self {
        let kick = dt / mass;
        let (fall, excess) = fall(dt, kick);
        Stride { dt, mass, kick, fall, rate: R::from_f64(2.0) / dt, excess }
    }

    /// The same mass and γ times the step; γ may be negative.
    pub fn times(&self, gamma: R) -> Self {
        Stride::new(gamma * self.dt, self.mass)
    }

    /// h v with the low part of v, which is not random: the corrections of [`Stride::kick_compensated`] pass through it.
    #[inline(always)]
    pub(super) fn drift<const D: usize>(&self, v: &CompensatedVector<D, R>) -> [R; D] {
        by_component!(|i| drift(self.dt, (v.hi[i], v.lo[i])))
    }

    /// As [`Stride::drift`], and what its rounding leaves out: for forces that do no work.
    #[inline(always)]
    pub(super) fn drift_and_rest<const D: usize>(&self, v: &CompensatedVector<D, R>) -> ([R; D], [R; D]) {
        let (mut drift, mut left) = ([R::ZERO; D], [R::ZERO; D]);
        for i in 0..D {
            let (moved, rest) = path(self.dt, (v.hi[i], v.lo[i]));
            (drift[i], left[i]) = two_sum(moved, rest);
        }
        (drift, left)
    }

    /// v −= `kick` G, and what the position moves in the meantime: h (v + share·change), with v as it was. G comes in two
    /// parts ([`Increment::parts`](crate::newton::Increment::parts)); the second, which may be too small to change the first,
    /// goes to the low part of v, as does what keeps h times the kick at `fall`, which the position was solved with.
    ///
    /// For the mean velocity (v + v′)/2 the share is ½, for v′ it is 1. Both updates use one rounded change c, and the sum is
    /// formed before it is multiplied: the work G·Δq and the kinetic energy that c brings then differ by relative rounding
    /// errors of c and of h (v + c/2), which a motion and its reversal make alike and with opposite work. Rounding g G and
    /// h v by themselves leaves a mean, and the energy drifts in proportion to the number of steps (1.5·10⁻¹³ in 10⁶ steps of
    /// Hénon–Heiles at h = 0.1 without fused instructions).
    #[inline(always)]
    pub(super) fn kick_and_drift<const D: usize>(
        &self,
        share: R,
        v: &mut CompensatedVector<D, R>,
        [slope, turned]: [[R; D]; 2],
    ) -> [R; D] {
        let mut moved = [R::ZERO; D];
        for i in 0..D {
            let (change, late) = (-self.kick * slope[i], self.excess.mul_add(slope[i], -self.kick * turned[i]));
            moved[i] = self.dt * (v.hi[i] + share.mul_add(change, share.mul_add(late, v.lo[i])));
            let (change, rest) = two_sum(change, late + v.lo[i]);
            let (high, low) = two_sum(v.hi[i], change);
            (v.hi[i], v.lo[i]) = (high, low + rest);
        }
        moved
    }

    /// v −= (`fall`/`dt`) G, to more digits than that quotient has.
    ///
    /// The position moves by multiples of `fall`. Were the velocity to move by a coefficient that is only nearly fall/dt,
    /// the same relative error in each step would feed energy in at a constant rate (2·10⁻¹³ of it in 500 orbits
    /// of eccentricity 0.9, a 200th of a period at a step). The correction is smaller than an ulp of the kick, so it
    /// goes to the low part of v and that part is carried on exactly.
    #[inline(always)]
    pub(super) fn kick_compensated<const D: usize>(&self, v: &mut CompensatedVector<D, R>, gradient: [R; D]) {
        for i in 0..D {
            let (change, rest) = two_sum(-self.kick * gradient[i], v.lo[i]);
            let (high, low) = two_sum(v.hi[i], change);
            v.hi[i] = high;
            v.lo[i] = low + self.excess.mul_add(gradient[i], rest);
        }
    }
}

/// h²/m from h/m, rounded, and the part of h/m by which h times that exceeds it, in exact arithmetic.
pub(crate) fn fall<R: Real>(dt: R, kick: R) -> (R, R) {
    let (fall, rest) = dt.product(kick);
    (fall, rest / dt)
}

#[cfg(test)]
mod tests {
    use dmech_scalar::CompensatedVector;

    use super::Stride;

    /// A hundredth of an ulp of each change, too small to change it, adds up.
    #[test]
    fn the_second_part_of_a_force_is_carried_on() {
        let (stride, mut v) = (Stride::new(0.5, 1.0), CompensatedVector::new([1.0]));
        let (change, late, kicks) = (0.375, 0.375 * 0.01 * f64::EPSILON, 100_000);
        for _ in 0..kicks {
            let moved = stride.kick_and_drift(0.5, &mut v, [[change / -0.5], [late / -0.5]]);
            assert!(moved[0] > 0.5 * v.hi[0] - change && moved[0] < 0.5 * v.hi[0]);
        }
        let kicks = f64::from(kicks);
        let added = (v.hi[0] - 1.0 - kicks * change) + v.lo[0];
        assert!((added / (kicks * late) - 1.0).abs() < 1e-3, "{added:e} of {:e}", kicks * late);
    }
}
