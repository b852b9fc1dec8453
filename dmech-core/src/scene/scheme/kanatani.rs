//! Kanatani's scheme on scenes.

use super::{SceneScheme, Start, discrete_gradient, shift};
use crate::newton::NotConverged;
use crate::scene::compensated::CompensatedVectors;
use crate::scene::matrix::Matrix;
use crate::scene::newton::{Equation, Solver, Unknown};
use crate::scene::setting::{Setting, System};
use crate::scene::terms::stencil::Stencil;
use crate::scene::terms::{Acts, WithoutVelocities};
use crate::scene::vectors::Vectors;
use crate::scheme::{Effort, Kanatani, Start as Beginning};

/// What [`Kanatani`](struct@Kanatani) carries for a scene.
#[derive(Debug)]
pub struct KanataniScene<const D: usize> {
    q_before: Vectors<D>,
    q: CompensatedVectors<D>,
    z: CompensatedVectors<D>,
    /// ∇̄Φ − F of the last three steps, the newest first.
    gradients: [Vectors<D>; 3],
    /// −F at the position now.
    force: Vectors<D>,
    g: Vectors<D>,
}

cloned_in_place!(KanataniScene { q_before, q, z, gradients, force, g });

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for KanataniScene<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        let [q, q_low] = self.q.parts_mut();
        let [z, z_low] = self.z.parts_mut();
        let [newest, second, third] = self.gradients.each_mut().map(|gradient| gradient.flat_mut());
        vec![self.q_before.flat_mut(), q, q_low, z, z_low, newest, second, third]
    }
}

/// ∇̄Φ(q₋, b).
struct Exact<'a, const D: usize, A> {
    acts: &'a A,
    before: &'a Vectors<D>,
    q: &'a Vectors<D>,
    t: f64,
}

impl<const D: usize, A: Acts<D>> Exact<'_, D, A> {
    /// q + θ (q₋ − q): both ends move as the step is lengthened.
    fn behind(&self, theta: f64) -> Vectors<D> {
        let mut a = self.q.clone();
        for (a, before) in a.flat_mut().iter_mut().zip(self.before.flat()) {
            *a += theta * (before - *a);
        }
        a
    }
}

impl<const D: usize, A: Acts<D>> Unknown<D> for Exact<'_, D, A> {
    const LINEAR: bool = A::LINEAR;
    const PIECEWISE: bool = A::PIECEWISE;
    const FORCED: bool = false;
    const EXACT: bool = true;

    fn gradient(&self, theta: f64, b: &Vectors<D>, _: &Vectors<D>, out: &mut Vectors<D>) {
        if theta == 1.0 {
            self.acts.set_discrete_gradient(self.before, b, self.t, out);
        } else {
            self.acts.set_discrete_gradient(&self.behind(theta), b, self.t, out);
        }
    }

    fn jacobian(&self, theta: f64, b: &Vectors<D>, _: &Vectors<D>, _: f64, out: &mut Matrix<D>) {
        if theta == 1.0 {
            self.acts.add_discrete_jacobian(self.before, b, self.t, out);
        } else {
            self.acts.add_discrete_jacobian(&self.behind(theta), b, self.t, out);
        }
    }

    #[inline(always)]
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>) {
        self.acts.add_discrete_stencil(self.before, b, self.t, first, out);
    }
}

impl<const D: usize, A: Acts<D> + WithoutVelocities + Clone> SceneScheme<D, A> for Kanatani {
    type Memory = KanataniScene<D>;
    type Workspace = Solver<D>;

    fn begin(
        &self,
        system: &System<D, A>,
        start: Start<'_, D>,
        solver: &mut Solver<D>,
    ) -> Result<Self::Memory, NotConverged> {
        let Start { q, v, slope: gradient, .. } = start;
        let h = system.setting.dt;
        let (mut q_before, mut z) = (q.clone(), v.clone());
        match self.start {
            Beginning::Formula => {
                for i in 0..z.flat().len() {
                    z.flat_mut()[i] += 0.5 * system.setting.kick.flat()[i] * gradient.flat()[i];
                    q_before.flat_mut()[i] -= h * z.flat()[i];
                }
            }
            Beginning::BackwardStep => {
                q_before = discrete_gradient::step_back(system, start, solver, &self.newton)?;
                for (i, z) in z.flat_mut().iter_mut().enumerate() {
                    *z = (q.flat()[i] - q_before.flat()[i]) / h;
                }
            }
        }
        Ok(KanataniScene {
            q_before,
            q: CompensatedVectors::new(q.clone()),
            z: CompensatedVectors::new(z),
            force: gradient.clone(),
            g: system.setting.g(h),
            gradients: core::array::from_fn(|_| gradient.clone()),
        })
    }

    /// (q₊ − 2q + q₋)/h² = −∇̄Φ(q₋, q₊)/m; z = (q − q₋)/h.
    fn step(
        &self,
        system: &System<D, A>,
        t: f64,
        memory: &mut Self::Memory,
        solver: &mut Solver<D>,
    ) -> Result<Effort, NotConverged> {
        let KanataniScene { q_before, q, z, gradients, force, g } = memory;
        let h = system.setting.dt;
        let [gradient, before, earlier] = &*gradients;
        // A force beside the potential is that at the position now.
        if A::FORCED {
            force.clear();
            system.acts.subtract_force(1.0, &q.hi, &z.hi, t, force);
        }
        let equation = Equation {
            q: &q.hi,
            q_low: &q.lo,
            h,
            known: A::FORCED.then_some(&*force),
            g,
            v: &z.hi,
            v_low: &z.lo,
            rate: 0.0,
            last: [gradient, before, earlier],
            last_are_whole: true,
            newton: &self.newton,
        };
        let unknown = Exact { acts: &system.acts, before: q_before, q: &q.hi, t };
        let effort = solver.solve(&equation, &unknown)?;
        if A::FORCED {
            for (found, force) in solver.gradient.flat_mut().iter_mut().zip(force.flat()) {
                *found += force;
            }
        }
        let (kick, found, rest) = (system.setting.kick.flat(), solver.gradient.flat(), solver.rest.flat());
        let change = |i: usize| [-kick[i] * found[i], -kick[i] * rest[i]];
        q_before.clone_from(&q.hi);
        CompensatedVectors::kick_in_parts_and_drift(q, z, h, 1.0, change);
        shift(gradients, &mut solver.gradient);
        Ok(effort)
    }

    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Vectors<D> {
        &memory.q.hi
    }

    /// z + (h/2) a(q).
    fn velocity(&self, system: &System<D, A>, t: f64, memory: &Self::Memory) -> Vectors<D> {
        let mut gradient = Vectors::zeros(memory.q.hi.bodies());
        system.slope(&memory.q.hi, &memory.z.hi, t, &mut gradient);
        let mut v = memory.z.hi.clone();
        for (i, v) in v.flat_mut().iter_mut().enumerate() {
            *v -= 0.5 * system.setting.kick.flat()[i] * gradient.flat()[i];
        }
        v
    }

    fn finite(&self, memory: &Self::Memory) -> bool {
        memory.q.is_finite() && memory.z.is_finite()
    }

    /// Σ m z²/2 (3.2).
    fn kinetic_energy(&self, setting: &Setting<D>, memory: &Self::Memory) -> f64 {
        setting.kinetic_energy(&memory.z.hi)
    }

    /// Σ F·(q₊ − q₋)/2 (3.3)–(3.6).
    fn work(&self, setting: &Setting<D>, before: &Self::Memory, after: &Self::Memory) -> f64 {
        setting.work(&after.gradients[0], |i| 0.5 * setting.dt * (before.z.sum(i) + after.z.sum(i)))
    }

    /// Σ m z²/2 + (Φ(q) + Φ(q₋))/2 (3.9)–(3.10).
    fn discrete_energy(&self, system: &System<D, A>, t: f64, memory: &Self::Memory) -> Option<f64> {
        let potentials = system.acts.potential(&memory.q.hi, t) + system.acts.potential(&memory.q_before, t);
        Some(system.setting.kinetic_energy(&memory.z.hi) + 0.5 * potentials)
    }
}
