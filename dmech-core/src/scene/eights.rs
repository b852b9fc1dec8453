//! Eight vectors of each body, side by side.

use dmech_scalar::Lanes;

use super::vectors::Vectors;

/// Eight numbers for each coordinate of n bodies, by column as [`Vectors`]: those of the stages of a step.
#[derive(Debug, Default)]
pub struct Eights<const D: usize> {
    bodies: usize,
    flat: Vec<Lanes>,
}

impl<const D: usize> Eights<D> {
    pub(super) fn zeros(bodies: usize) -> Self {
        Eights { bodies, flat: vec![Lanes::default(); D * bodies] }
    }

    #[inline(always)]
    pub(super) fn flat(&self) -> &[Lanes] {
        &self.flat
    }

    #[inline(always)]
    pub(super) fn flat_mut(&mut self) -> &mut [Lanes] {
        &mut self.flat
    }

    /// The columns.
    #[inline(always)]
    pub(super) fn columns(&self) -> [&[Lanes]; D] {
        core::array::from_fn(|k| &self.flat[k * self.bodies..(k + 1) * self.bodies])
    }

    /// The columns, to be written to.
    #[inline(always)]
    pub(super) fn columns_mut(&mut self) -> [&mut [Lanes]; D] {
        let mut rest = self.flat.as_mut_slice();
        core::array::from_fn(|_| rest.split_off_mut(..self.bodies).unwrap_or_default())
    }

    #[inline(always)]
    pub(super) fn get(&self, i: usize) -> [Lanes; D] {
        let mut all = [Lanes::default(); D];
        for k in 0..D {
            all[k] = self.flat[k * self.bodies + i];
        }
        all
    }

    pub(super) fn set(&mut self, i: usize, x: [Lanes; D]) {
        for k in 0..D {
            self.flat[k * self.bodies + i] = x[k];
        }
    }

    #[inline(always)]
    pub(super) fn add(&mut self, i: usize, x: [Lanes; D]) {
        for k in 0..D {
            self.flat[k * self.bodies + i] += x[k];
        }
    }

    #[inline(always)]
    pub(super) fn subtract(&mut self, i: usize, x: [Lanes; D]) {
        for k in 0..D {
            self.flat[k * self.bodies + i] -= x[k];
        }
    }

    pub(super) fn clear(&mut self) {
        self.flat.fill(Lanes::default());
    }

    /// Vector number `stage` of each body.
    pub(super) fn copy_to(&self, stage: usize, out: &mut Vectors<D>) {
        for (out, eight) in out.flat_mut().iter_mut().zip(&self.flat) {
            *out = eight[stage];
        }
    }
}

impl<const D: usize> Clone for Eights<D> {
    fn clone(&self) -> Self {
        Eights { bodies: self.bodies, flat: self.flat.clone() }
    }

    /// Without a new allocation where the number of bodies is the same.
    fn clone_from(&mut self, other: &Self) {
        self.bodies = other.bodies;
        self.flat.clone_from(&other.flat);
    }
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for Eights<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        self.flat.iter_mut().map(Lanes::as_mut_slice).collect()
    }
}
