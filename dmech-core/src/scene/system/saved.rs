//! What a checkpoint knows of a scene.

use super::SceneSystem;
use crate::checkpoint::{Carried, Saved};
use crate::scene::compensated::CompensatedVectors;
use crate::scene::terms::Acts;
use crate::scene::vectors::Vectors;
use crate::system::System;

impl<const D: usize> Carried for Vectors<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![self.flat_mut()]
    }
}

impl<const D: usize> Carried for CompensatedVectors<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        self.parts_mut().into()
    }
}

impl<const D: usize, A: Acts<D>> Saved for SceneSystem<D, A> {
    fn numbers(x: &mut Vectors<D>) -> &mut [f64] {
        x.flat_mut()
    }

    fn bodies(&self) -> (Vec<f64>, Vec<usize>) {
        (self.masses.clone(), self.pins.clone())
    }

    fn fields(&self, see: &mut dyn FnMut(&'static str, f64)) {
        self.acts.terms.fields(see);
        self.acts.drives.bodies().for_each(|i| see("driven bodies", i as f64));
        self.tests.iter().for_each(|&i| see("test bodies", i as f64));
    }

    /// Φ, ∇Φ and F.
    fn sample(&self, t: f64, [q, v]: &[Vectors<D>; 2], see: &mut dyn FnMut(&[f64])) {
        let mut out = Vectors::zeros(q.bodies());
        see(&[self.potential(t, q)]);
        self.acts.at(t, q, |terms, q| terms.add_gradient(q, t, &mut out));
        see(out.flat());
        out.clear();
        self.acts.subtract_force(1.0, q, v, t, &mut out);
        see(out.flat());
    }
}
