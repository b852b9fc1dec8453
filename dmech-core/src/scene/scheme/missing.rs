//! A scene whose scheme was not chosen.

use super::{SceneScheme, Start};
use crate::newton::NotConverged;
use crate::scene::setting::{Setting, System};
use crate::scene::terms::Acts;
use crate::scene::vectors::Vectors;
use crate::scheme::{Effort, NeverBegun, WithScheme};
use crate::simulation::NoScheme;

/// Of no scene, as [`WithScheme`] never holds: so that the compiler says what is missing.
impl<const D: usize, A: Acts<D> + WithScheme> SceneScheme<D, A> for NoScheme {
    type Memory = NeverBegun;
    type Workspace = ();

    fn begin(&self, _: &System<D, A>, _: Start<'_, D>, _: &mut ()) -> Result<NeverBegun, NotConverged> {
        NeverBegun::begin()
    }

    fn step(&self, _: &System<D, A>, _: f64, m: &mut NeverBegun, _: &mut ()) -> Result<Effort, NotConverged> {
        match *m {}
    }

    fn position<'m>(&self, memory: &'m NeverBegun) -> &'m Vectors<D> {
        match *memory {}
    }

    fn velocity(&self, _: &System<D, A>, _: f64, memory: &NeverBegun) -> Vectors<D> {
        match *memory {}
    }

    fn finite(&self, memory: &NeverBegun) -> bool {
        match *memory {}
    }

    fn kinetic_energy(&self, _: &Setting<D>, memory: &NeverBegun) -> f64 {
        match *memory {}
    }

    fn work(&self, _: &Setting<D>, memory: &NeverBegun, _: &NeverBegun) -> f64 {
        match *memory {}
    }
}
