//! A scene in motion, as the time scale is read from it.

use crate::scene::vectors::Vectors;
use crate::system::{Course, Frequency};

/// Where bodies are and how they move: what the time scale of a scene depends on.
#[derive(Clone, Copy, Debug)]
pub struct Moving<'a, const D: usize> {
    /// The time.
    pub t: f64,
    /// Positions.
    pub q: &'a Vectors<D>,
    /// Velocities.
    pub v: &'a Vectors<D>,
    /// ∇Φ − F, of all terms together.
    pub slope: &'a Vectors<D>,
    /// 1/m of each body, 0 for those that are pinned.
    pub per_mass: &'a [f64],
    /// The smallest ω that counts in the scene; 0 if any does.
    pub least: f64,
}

impl<const D: usize> Moving<'_, D> {
    /// Nothing acts.
    pub fn nothing(&self) -> Frequency {
        Frequency::none(self.least)
    }

    /// One body.
    #[inline(always)]
    pub fn body(&self, i: usize) -> Course<D> {
        let per_mass = self.per_mass[i];
        let fall = self.slope.get(i).map(|x| -per_mass * x);
        Course { q: self.q.get(i), v: self.v.get(i), fall, per_mass, least: self.least }
    }
}
