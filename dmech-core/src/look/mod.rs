//! The local time scale of a motion, from what acts.

mod course;
mod frequency;
mod stiffness;

pub use course::Course;
pub use frequency::{EVALUATIONS, Frequency};
pub use stiffness::Stiffness;

use dmech_scalar::{Mask, Real};

/// ρ/ω, of what passes, at least.
const STAYS: f64 = 2.0 / 3.0;

/// What the motion is like where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look<R = f64> {
    /// (ω s)¹²: roots take longer than all the rest, and are hardly ever needed.
    pub(crate) power: R,
    /// The part of it that is of bodies that pass.
    pub(crate) passing: R,
    /// A length of time.
    pub(crate) s: R,
    /// d ln ω/dt along the motion, of what does not pass.
    pub growth: R,
}

impl<R: Real> Look<R> {
    /// ω, the angular frequency of the linearised motion.
    #[cold]
    pub fn rate(&self) -> R {
        twelfth_root(self.power) / self.s
    }

    /// Whether ρ is below so many ω, of what does not pass: steps did not see it come.
    #[inline(always)]
    pub(crate) fn outruns(&self, least: f64, density: R) -> R::Mask {
        self.power_of(density).less(R::from_f64(least.powi(12)) * (self.power - self.passing))
    }

    /// Whether ρ is above so many ω: steps did not see it go.
    #[inline(always)]
    pub(crate) fn outlasts(&self, most: f64, density: R) -> R::Mask {
        (R::from_f64(most.powi(12)) * self.power).less(self.power_of(density))
    }

    /// (ρ s)¹², as [`power`](Look::power) is that of ω. No density is negative.
    #[inline(always)]
    fn power_of(&self, density: R) -> R {
        (density * self.s).max(R::ZERO).powi(12)
    }

    /// ρ, or the end of the range `band` of ρ/ω where it lies outside; what passes now is not taken to be gone soon.
    #[inline(always)]
    pub fn within(&self, [least, most]: [f64; 2], density: R) -> R {
        let bound = |end: f64, power: R| R::from_f64(end.powi(12)) * power;
        let (least, most) = (bound(least, self.power).max(bound(STAYS, self.passing)), bound(most, self.power));
        let ratio = self.power_of(density);
        let (below, above) = (ratio.less(least), most.less(ratio));
        if !below.or(above).any() {
            return density;
        }
        let end = twelfth_root(R::either(below, least, most)) / self.s;
        R::either(below.or(above), end, density)
    }
}

#[cold]
fn twelfth_root<R: Real>(power: R) -> R {
    power.sqrt().sqrt().cbrt()
}
