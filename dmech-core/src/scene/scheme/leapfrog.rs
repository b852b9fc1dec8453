//! Leap-frog on scenes.

use super::{SceneScheme, Start};
use crate::newton::NotConverged;
use crate::scene::setting::{Setting, System};
use crate::scene::terms::{Acts, WithoutVelocities};
use crate::scene::vectors::Vectors;
use crate::scheme::{Effort, Leapfrog};

/// What [`Leapfrog`] carries for a scene.
#[derive(Debug)]
pub struct LeapfrogScene<const D: usize> {
    q: Vectors<D>,
    /// Velocity half a step after.
    v: Vectors<D>,
    /// ∇Φ − F at q, which kicked the velocity from half a step before: v₋ = v + (h/m) G.
    gradient: Vectors<D>,
}

cloned_in_place!(LeapfrogScene { q, v, gradient });

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for LeapfrogScene<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![self.q.flat_mut(), self.v.flat_mut(), self.gradient.flat_mut()]
    }
}

impl<const D: usize, A: Acts<D> + WithoutVelocities> SceneScheme<D, A> for Leapfrog {
    type Memory = LeapfrogScene<D>;
    type Workspace = ();

    fn begin(&self, system: &System<D, A>, start: Start<'_, D>, _: &mut ()) -> Result<Self::Memory, NotConverged> {
        let gradient = start.slope.clone();
        let mut v = start.v.clone();
        for (i, v) in v.flat_mut().iter_mut().enumerate() {
            *v -= 0.5 * system.setting.kick.flat()[i] * gradient.flat()[i];
        }
        Ok(LeapfrogScene { q: start.q.clone(), v, gradient })
    }

    /// q′ = q + h v½; v½′ = v½ + h a(q′).
    fn step(
        &self,
        system: &System<D, A>,
        t: f64,
        memory: &mut Self::Memory,
        _: &mut (),
    ) -> Result<Effort, NotConverged> {
        let LeapfrogScene { q, v, gradient } = memory;
        let h = system.setting.dt;
        for (q, v) in q.flat_mut().iter_mut().zip(v.flat()) {
            *q += h * v;
        }
        system.slope(q, v, t + h, gradient);
        let kicks = system.setting.kick.flat().iter().zip(gradient.flat());
        for (v, (kick, gradient)) in v.flat_mut().iter_mut().zip(kicks) {
            *v -= kick * gradient;
        }
        Ok(Effort { evaluations: 1, iterations: 0 })
    }

    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Vectors<D> {
        &memory.q
    }

    /// The mean of the two half steps.
    fn velocity(&self, system: &System<D, A>, _: f64, memory: &Self::Memory) -> Vectors<D> {
        let mut v = memory.v.clone();
        for (i, v) in v.flat_mut().iter_mut().enumerate() {
            *v += 0.5 * system.setting.kick.flat()[i] * memory.gradient.flat()[i];
        }
        v
    }

    fn finite(&self, memory: &Self::Memory) -> bool {
        memory.q.is_finite() && memory.v.is_finite()
    }

    /// Σ m v²/2 at the half step before.
    fn kinetic_energy(&self, setting: &Setting<D>, memory: &Self::Memory) -> f64 {
        let mut before = memory.v.clone();
        for (i, v) in before.flat_mut().iter_mut().enumerate() {
            *v += setting.kick.flat()[i] * memory.gradient.flat()[i];
        }
        setting.kinetic_energy(&before)
    }

    /// Σ F_k·(q_{k+1} − q_{k−1})/2, with q_{k+1} − q_{k−1} = h (v_{k+½} + v_{k−½}).
    fn work(&self, setting: &Setting<D>, before: &Self::Memory, _: &Self::Memory) -> f64 {
        let (v, kick, gradient) = (before.v.flat(), setting.kick.flat(), before.gradient.flat());
        setting.work(&before.gradient, |i| 0.5 * setting.dt * (v[i] + (v[i] + kick[i] * gradient[i])))
    }
}
