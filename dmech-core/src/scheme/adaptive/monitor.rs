//! The local time scale of a motion, from the law.

use crate::law::{Field, Law};
use crate::look::{Course, Frequency, Stiffness};

pub(super) use crate::look::{EVALUATIONS, Look};

/// A place of the motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<const D: usize> {
    pub(super) t: f64,
    pub(super) q: [f64; D],
    pub(super) v: [f64; D],
    pub(super) mass: f64,
    /// The smallest ω that counts.
    pub(super) least: f64,
}

impl<const D: usize> Place<D> {
    /// ω here, as [`Frequency::of`] has it.
    pub(super) fn look<L: Law<D>>(&self, law: &L) -> Look {
        let per_mass = self.mass.recip();
        let fall = law.field(self.mass, self.t).slope(self.q, self.v).map(|x| -per_mass * x);
        let course = Course { q: self.q, v: self.v, fall, per_mass, least: self.least };
        let stiffness = |s: f64, q: [f64; D], v: [f64; D]| Stiffness::of(law, self.mass, self.t + s, q, v);
        Frequency::of(course, stiffness).look(self.least)
    }
}
