//! Runge–Kutta–Nyström splittings on scenes.

use super::{SceneScheme, Start};
use crate::newton::NotConverged;
use crate::scene::newton::Solver;
use crate::scene::setting::{Setting, System};
use crate::scene::terms::{Acts, WithoutVelocities};
use crate::scene::vectors::Vectors;
use crate::scheme::coefficients::{First, NystromCoefficients};
use crate::scheme::{Effort, Nystrom, Splitting};

/// What [`Nystrom`] carries for a scene.
#[derive(Clone, Debug)]
pub struct NystromScene<const D: usize> {
    q: Vectors<D>,
    /// Velocity after the last kick.
    v: Vectors<D>,
    /// ∇Φ − F of the last kick.
    gradient: Vectors<D>,
    /// Work of the last step.
    work: f64,
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for NystromScene<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![self.q.flat_mut(), self.v.flat_mut(), self.gradient.flat_mut()]
    }
}

impl<const D: usize> NystromScene<D> {
    /// v + c (h/m) G: the velocity before a kick, or before a part of it.
    fn before(&self, setting: &Setting<D>, c: f64) -> Vectors<D> {
        let mut v = self.v.clone();
        for (v, (kick, gradient)) in v.flat_mut().iter_mut().zip(setting.kick.flat().iter().zip(self.gradient.flat())) {
            *v += c * kick * gradient;
        }
        v
    }

    /// The work of the last kick, F·(mean velocity) in its time.
    fn of_kick(&self, setting: &Setting<D>, c: f64) -> f64 {
        let (v, kick, gradient) = (self.v.flat(), setting.kick.flat(), self.gradient.flat());
        setting.work(&self.gradient, |i| c * setting.dt * (v[i] + 0.5 * c * kick[i] * gradient[i]))
    }

    fn drift(&mut self, h: f64) {
        for (q, v) in self.q.flat_mut().iter_mut().zip(self.v.flat()) {
            *q += h * v;
        }
    }

    /// Takes the force at time t and kicks with it.
    fn kick<A: Acts<D>>(&mut self, system: &System<D, A>, t: f64, c: f64) {
        let Self { q, v, gradient, .. } = self;
        system.slope(q, v, t, gradient);
        for (v, (kick, gradient)) in v.flat_mut().iter_mut().zip(system.setting.kick.flat().iter().zip(gradient.flat()))
        {
            *v -= c * kick * gradient;
        }
    }
}

impl<C: NystromCoefficients<N>, const N: usize> Nystrom<C, N> {
    /// The half of the last kick that belongs to the step to come.
    const AHEAD: f64 = if matches!(C::FIRST, First::Kick) { C::KICKS[0] } else { 0.0 };
}

impl<C: NystromCoefficients<N>, const N: usize, const D: usize, A: Acts<D> + WithoutVelocities> SceneScheme<D, A>
    for Nystrom<C, N>
{
    type Memory = NystromScene<D>;

    fn begin(
        &self,
        system: &System<D, A>,
        start: Start<'_, D>,
        _: &mut Solver<D>,
    ) -> Result<Self::Memory, NotConverged> {
        let gradient = Vectors::zeros(start.q.bodies());
        let mut memory = NystromScene { q: start.q.clone(), v: start.v.clone(), gradient, work: 0.0 };
        memory.kick(system, start.t, Self::AHEAD);
        Ok(memory)
    }

    fn step(
        &self,
        system: &System<D, A>,
        t: f64,
        memory: &mut Self::Memory,
        _: &mut Solver<D>,
    ) -> Result<Effort, NotConverged> {
        let (setting, h) = (&system.setting, system.setting.dt);
        let mut work = 0.0;
        for k in 0..N {
            if k > 0 || matches!(C::FIRST, First::Kick) {
                work += memory.of_kick(setting, Self::JOINED[(k + N - 1) % N]);
            }
            memory.drift(Self::DRIFTS[k] * h);
            memory.kick(system, t + Self::ENDS[k] * h, Self::JOINED[k]);
        }
        if matches!(C::FIRST, First::Drift) {
            work += memory.of_kick(setting, Self::JOINED[N - 1]);
            memory.drift(Self::DRIFTS[0] * h);
        }
        memory.work = work;
        Ok(Effort { evaluations: N as u32, iterations: 0 })
    }

    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Vectors<D> {
        &memory.q
    }

    fn velocity(&self, system: &System<D, A>, _: f64, memory: &Self::Memory) -> Vectors<D> {
        memory.before(&system.setting, Self::AHEAD)
    }

    fn finite(&self, memory: &Self::Memory) -> bool {
        memory.q.is_finite() && memory.v.is_finite()
    }

    /// Σ m v²/2 before the kick that belongs half to the step to come.
    fn kinetic_energy(&self, setting: &Setting<D>, memory: &Self::Memory) -> f64 {
        setting.kinetic_energy(&memory.before(setting, 2.0 * Self::AHEAD))
    }

    /// Σ F·h (v₋ + v₊)/2 over the kicks, v₋ and v₊ being the velocities before and after.
    fn work(&self, _: &Setting<D>, _: &Self::Memory, after: &Self::Memory) -> f64 {
        after.work
    }
}
