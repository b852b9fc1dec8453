//! The explicit scheme on scenes.

use super::{SceneScheme, Start};
use crate::newton::NotConverged;
use crate::scene::setting::{Setting, System};
use crate::scene::terms::Acts;
use crate::scene::vectors::Vectors;
use crate::scheme::{Effort, Explicit};

/// What [`Explicit`] carries for a scene.
#[derive(Debug)]
pub struct ExplicitScene<const D: usize> {
    q: Vectors<D>,
    v: Vectors<D>,
    /// ∇Φ − F at the step before.
    gradient: Vectors<D>,
}

cloned_in_place!(ExplicitScene { q, v, gradient });

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for ExplicitScene<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![self.q.flat_mut(), self.v.flat_mut(), self.gradient.flat_mut()]
    }
}

impl<const D: usize, A: Acts<D>> SceneScheme<D, A> for Explicit {
    type Memory = ExplicitScene<D>;
    type Workspace = ();

    fn begin(&self, _: &System<D, A>, start: Start<'_, D>, _: &mut ()) -> Result<Self::Memory, NotConverged> {
        let gradient = Vectors::zeros(start.q.bodies());
        Ok(ExplicitScene { q: start.q.clone(), v: start.v.clone(), gradient })
    }

    /// v′ = v + h a(q); q′ = q + h (v + v′)/2.
    fn step(
        &self,
        system: &System<D, A>,
        t: f64,
        memory: &mut Self::Memory,
        _: &mut (),
    ) -> Result<Effort, NotConverged> {
        let ExplicitScene { q, v, gradient } = memory;
        system.slope(q, v, t, gradient);
        let half = 0.5 * system.setting.dt;
        let kicks = system.setting.kick.flat().iter().zip(gradient.flat());
        for ((q, v), (kick, gradient)) in q.flat_mut().iter_mut().zip(v.flat_mut()).zip(kicks) {
            let before = *v;
            *v -= kick * gradient;
            *q += half * (before + *v);
        }
        Ok(Effort { evaluations: 1, iterations: 0 })
    }

    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Vectors<D> {
        &memory.q
    }

    fn velocity(&self, _: &System<D, A>, _: f64, memory: &Self::Memory) -> Vectors<D> {
        memory.v.clone()
    }

    fn finite(&self, memory: &Self::Memory) -> bool {
        memory.q.is_finite() && memory.v.is_finite()
    }

    fn kinetic_energy(&self, setting: &Setting<D>, memory: &Self::Memory) -> f64 {
        setting.kinetic_energy(&memory.v)
    }

    /// Σ F_k·(q_{k+1} − q_k), with q_{k+1} − q_k = h (v_k + v_{k+1})/2.
    fn work(&self, setting: &Setting<D>, before: &Self::Memory, after: &Self::Memory) -> f64 {
        setting.work(&after.gradient, |i| 0.5 * setting.dt * (before.v.flat()[i] + after.v.flat()[i]))
    }
}
