//! A scene as a simulation sets it up.

use super::SceneSystem;
use crate::error::Error;
use crate::scene::bodies::Bodies;
use crate::scene::builder::Scene;
use crate::scene::driven::Driven;
use crate::scene::space::Space;
use crate::scene::state::SceneState;
use crate::scene::terms::Term;
use crate::setup::Setup;
use crate::span::moves_on;

impl<const D: usize, P, L: Term<D, P, B>, B: Space<D>> Setup<()> for Scene<D, P, L, B> {
    type State = SceneState<D>;
    type System = SceneSystem<D, L::Ready>;

    fn start(&self) -> SceneState<D> {
        let Bodies { t, q, v, drives, .. } = &self.bodies;
        let mut start = SceneState { t: *t, q: q.clone(), v: v.clone() };
        drives.place(&mut start);
        start
    }

    fn starting_from(self, state: &SceneState<D>) -> Self {
        self.starting_from(state)
    }

    fn whole_mass(&self, _: f64) -> f64 {
        self.bodies.weights().iter().sum()
    }

    fn system(self, (): (), _: f64, dt: f64) -> Result<Self::System, Error> {
        let Scene { bodies, laws, space } = self;
        bodies.check()?;
        space.check()?;
        moves_on(bodies.t, dt, f64::EPSILON)?;
        let terms = laws.prepare(&bodies, space)?;
        let mut per_mass: Vec<_> = bodies.masses.iter().map(|mass| mass.recip()).collect();
        bodies.pins.iter().for_each(|&i| per_mass[i] = 0.0);
        let weights = bodies.weights();
        let Bodies { masses, pins, tests, drives, .. } = bodies;
        Ok(SceneSystem { acts: Driven { terms, drives }, masses, pins, per_mass, tests, weights })
    }
}
