//! What a scheme carries, number by number.

use dmech_scalar::{CompensatedVector, Exact, Lanes};

use super::Digits;
use crate::error::Difference;
use crate::law::{Field, Law, Potential};
use crate::system::{Particle, System};

/// The numbers that a scheme carries from step to step: what a checkpoint saves of its memory.
pub trait Carried: Clone {
    /// All of them, always in the same order. What a step computes before it reads it need not be among them.
    fn carried(&mut self) -> Vec<&mut [f64]>;
}

impl<const D: usize> Carried for [f64; D] {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![self]
    }
}

impl Carried for f64 {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![core::slice::from_mut(self)]
    }
}

impl<const D: usize> Carried for [Lanes; D] {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        self.iter_mut().map(|lanes| lanes.as_mut_slice()).collect()
    }
}

impl<const D: usize> Carried for CompensatedVector<D, f64> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![&mut self.hi, &mut self.lo]
    }
}

/// A system that can be saved: what shows that it is the same. In a store its numbers are any that are [`Exact`], in a checkpoint `f64`.
pub trait Saved: System<Scalar: Exact> {
    /// The numbers of a vector.
    fn numbers(x: &mut Self::Vector) -> &mut [Self::Scalar];
    /// The masses of the bodies, and those that are pinned.
    fn bodies(&self) -> (Vec<f64>, Vec<usize>);
    /// Every number that makes the system what it is, by name.
    fn fields(&self, see: &mut dyn FnMut(&'static str, f64));
    /// What acts at a place: position and velocity.
    fn sample(&self, t: f64, place: &[Self::Vector; 2], see: &mut dyn FnMut(&[Self::Scalar]));
}

impl<L: Law<D, R>, const D: usize, R: Exact> Saved for Particle<L, D, R> {
    fn numbers(x: &mut [R; D]) -> &mut [R] {
        x
    }

    fn bodies(&self) -> (Vec<f64>, Vec<usize>) {
        (vec![self.mass().to_f64()], Vec::new())
    }

    /// What the law reads of itself, and the masses of its coordinates.
    fn fields(&self, see: &mut dyn FnMut(&'static str, f64)) {
        self.law().tell(see);
        self.law().mass_ratios().into_iter().for_each(|ratio| see("masses", ratio));
    }

    fn sample(&self, t: f64, [q, v]: &[[R; D]; 2], see: &mut dyn FnMut(&[R])) {
        let field = self.field(R::from_f64(t));
        see(&[field.potential(*q)]);
        see(&field.slope(*q, *v));
    }
}

/// A copy of what a scheme carries.
pub(crate) fn save(memory: &impl Carried) -> Vec<Digits> {
    memory.clone().carried().into_iter().map(|numbers| Digits(numbers.to_vec())).collect()
}

/// Replaces what a scheme carries.
pub(crate) fn load(memory: &mut impl Carried, saved: &[Digits]) -> Result<(), Difference> {
    memory.carried().into_iter().zip(saved).try_for_each(|(place, numbers)| numbers.copy_to(place))
}
