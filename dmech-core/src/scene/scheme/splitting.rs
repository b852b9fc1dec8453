//! Drifts and kicks in turn on scenes: compositions of leap-frog and Runge–Kutta–Nyström splittings.

use super::{SceneScheme, Start};
use crate::newton::NotConverged;
use crate::scene::setting::{Setting, System};
use crate::scene::terms::{Acts, WithoutVelocities};
use crate::scene::vectors::Vectors;
use crate::scheme::coefficients::{First, NystromCoefficients};
use crate::scheme::{Coefficients, Composed, Effort, Leapfrog, Nystrom, Splitting};

/// What [`Nystrom`] and compositions of [`Leapfrog`] carry for a scene.
#[derive(Clone, Debug)]
pub struct SplittingScene<const D: usize> {
    q: Vectors<D>,
    /// Velocity after the last kick.
    v: Vectors<D>,
    /// ∇Φ − F of the last kick.
    gradient: Vectors<D>,
    /// Work of the last step on each coordinate, summed up only when it is asked for.
    works: Vectors<D>,
    /// Work of the kick that was made already and belongs to the step to come.
    ahead: Vectors<D>,
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for SplittingScene<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![self.q.flat_mut(), self.v.flat_mut(), self.gradient.flat_mut(), self.ahead.flat_mut()]
    }
}

impl<const D: usize> SplittingScene<D> {
    /// v + c (h/m) G: the velocity before a kick, or before a part of it.
    fn before(&self, setting: &Setting<D>, c: f64) -> Vectors<D> {
        let mut v = self.v.clone();
        for (v, (kick, gradient)) in v.flat_mut().iter_mut().zip(setting.kick.flat().iter().zip(self.gradient.flat())) {
            *v += c * kick * gradient;
        }
        v
    }

    /// Takes the force at time t, kicks by c of a step and drifts by a, in one pass over the coordinates. The work of the
    /// kick, F·(mean velocity) in its time, is added to that of the step.
    fn kick_and_drift<A: Acts<D>>(&mut self, system: &System<D, A>, t: f64, c: f64, a: f64) {
        let Self { q, v, gradient, works, .. } = self;
        system.slope(q, v, t, gradient);
        let kick = system.setting.kick.flat();
        let lengths = [c, c * system.setting.dt, a * system.setting.dt];
        sweep(q.flat_mut(), v.flat_mut(), works.flat_mut(), kick, gradient.flat(), lengths);
    }
}

/// The pass itself, as a function: its arguments are known not to overlap, so that the compiler makes registers of it.
#[inline(never)]
fn sweep(q: &mut [f64], v: &mut [f64], works: &mut [f64], kick: &[f64], gradient: &[f64], [c, time, drift]: [f64; 3]) {
    let n = q.len();
    let (v, works, kick, gradient) = (&mut v[..n], &mut works[..n], &kick[..n], &gradient[..n]);
    for i in 0..n {
        let change = c * kick[i] * gradient[i];
        works[i] -= time * gradient[i] * (v[i] - 0.5 * change);
        v[i] -= change;
        q[i] += drift * v[i];
    }
}

/// The half of the last kick that belongs to the step to come.
const fn ahead<S: Splitting<N>, const N: usize>() -> f64 {
    if matches!(S::FIRST, First::Kick) { S::KICKS[0] } else { 0.0 }
}

macro_rules! stepped_by_drifts_and_kicks {
    ($($scheme:ty, $coefficients:ident;)*) => {$(
        impl<C: $coefficients<N>, const N: usize, const D: usize, A: Acts<D> + WithoutVelocities> SceneScheme<D, A>
            for $scheme
        {
            type Memory = SplittingScene<D>;
            type Workspace = ();

            fn begin(
                &self,
                system: &System<D, A>,
                start: Start<'_, D>,
                _: &mut (),
            ) -> Result<Self::Memory, NotConverged> {
                let zeros = || Vectors::zeros(start.q.bodies());
                let (q, v) = (start.q.clone(), start.v.clone());
                let mut memory = SplittingScene { q, v, gradient: zeros(), works: zeros(), ahead: zeros() };
                memory.kick_and_drift(system, start.t, ahead::<Self, N>(), 0.0);
                // The whole kick has the mean velocity of the start.
                let kicked = memory.gradient.flat().iter().zip(start.v.flat());
                for (work, (gradient, v)) in memory.ahead.flat_mut().iter_mut().zip(kicked) {
                    *work = -2.0 * ahead::<Self, N>() * system.setting.dt * gradient * v;
                }
                Ok(memory)
            }

            fn step(
                &self,
                system: &System<D, A>,
                t: f64,
                memory: &mut Self::Memory,
                _: &mut (),
            ) -> Result<Effort, NotConverged> {
                let h = system.setting.dt;
                core::mem::swap(&mut memory.works, &mut memory.ahead);
                let first = Self::DRIFTS[0] * h;
                for (q, v) in memory.q.flat_mut().iter_mut().zip(memory.v.flat()) {
                    *q += first * v;
                }
                for k in 0..N - 1 {
                    memory.kick_and_drift(system, t + <Self as Splitting<N>>::ENDS[k] * h, Self::JOINED[k], Self::DRIFTS[k + 1]);
                }
                memory.ahead.clear();
                let (t, last) = (t + <Self as Splitting<N>>::ENDS[N - 1] * h, Self::JOINED[N - 1]);
                if matches!(Self::FIRST, First::Drift) {
                    memory.kick_and_drift(system, t, last, Self::DRIFTS[0]);
                } else {
                    core::mem::swap(&mut memory.works, &mut memory.ahead);
                    memory.kick_and_drift(system, t, last, 0.0);
                    core::mem::swap(&mut memory.works, &mut memory.ahead);
                }
                Ok(Effort { evaluations: N as u32, iterations: 0 })
            }

            fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Vectors<D> {
                &memory.q
            }

            fn velocity(&self, system: &System<D, A>, _: f64, memory: &Self::Memory) -> Vectors<D> {
                memory.before(&system.setting, ahead::<Self, N>())
            }

            fn finite(&self, memory: &Self::Memory) -> bool {
                memory.q.is_finite() && memory.v.is_finite()
            }

            /// Σ m v²/2 before the kick that belongs half to the step to come.
            fn kinetic_energy(&self, setting: &Setting<D>, memory: &Self::Memory) -> f64 {
                setting.kinetic_energy(&memory.before(setting, 2.0 * ahead::<Self, N>()))
            }

            /// Σ F·h (v₋ + v₊)/2 over the kicks, v₋ and v₊ being the velocities before and after.
            fn work(&self, _: &Setting<D>, _: &Self::Memory, after: &Self::Memory) -> f64 {
                after.works.flat().iter().sum()
            }
        }
    )*};
}

stepped_by_drifts_and_kicks! {
    Composed<Leapfrog, C, N>, Coefficients;
    Nystrom<C, N>, NystromCoefficients;
}
