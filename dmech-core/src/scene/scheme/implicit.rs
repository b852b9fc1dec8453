//! The implicit scheme on scenes.

use super::{SceneScheme, Start, shift};
use crate::newton::NotConverged;
use crate::scene::compensated::CompensatedVectors;
use crate::scene::matrix::Matrix;
use crate::scene::newton::{Equation, Solver, Unknown};
use crate::scene::setting::{Setting, System};
use crate::scene::terms::Acts;
use crate::scene::terms::stencil::Stencil;
use crate::scene::vectors::Vectors;
use crate::scheme::{Effort, Implicit};

/// What [`Implicit`](struct@Implicit) carries for a scene.
#[derive(Debug)]
pub struct ImplicitScene<const D: usize> {
    q: CompensatedVectors<D>,
    v: CompensatedVectors<D>,
    /// ∇Φ − F in the last three states, the newest first.
    gradients: [Vectors<D>; 3],
    g: Vectors<D>,
}

cloned_in_place!(ImplicitScene { q, v, gradients, g });

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for ImplicitScene<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        let [q, q_low] = self.q.parts_mut();
        let [v, v_low] = self.v.parts_mut();
        let [newest, second, third] = self.gradients.each_mut().map(|gradient| gradient.flat_mut());
        vec![q, q_low, v, v_low, newest, second, third]
    }
}

/// ∇Φ(b) − F(b, v) at the end of the step.
struct AtEnd<'a, A> {
    acts: &'a A,
    t: f64,
}

impl<const D: usize, A: Acts<D>> Unknown<D> for AtEnd<'_, A> {
    const LINEAR: bool = A::LINEAR && !A::FORCED;
    const PIECEWISE: bool = A::PIECEWISE;
    const FORCED: bool = A::FORCED;
    const EXACT: bool = false;

    fn gradient(&self, _: f64, b: &Vectors<D>, v: &Vectors<D>, out: &mut Vectors<D>) {
        self.acts.set_gradient(b, self.t, out);
        self.acts.subtract_force(1.0, b, v, self.t, out);
    }

    fn jacobian(&self, _: f64, b: &Vectors<D>, v: &Vectors<D>, rate: f64, out: &mut Matrix<D>) {
        self.acts.add_hessian(1.0, b, self.t, out);
        self.acts.subtract_force_jacobian(1.0, b, v, self.t, rate, out);
    }

    #[inline(always)]
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>) {
        self.acts.add_stencil(b, self.t, first, out);
    }
}

impl<const D: usize, A: Acts<D>> SceneScheme<D, A> for Implicit {
    type Memory = ImplicitScene<D>;
    type Workspace = Solver<D>;

    fn begin(
        &self,
        system: &System<D, A>,
        start: Start<'_, D>,
        _: &mut Solver<D>,
    ) -> Result<Self::Memory, NotConverged> {
        Ok(ImplicitScene {
            q: CompensatedVectors::new(start.q.clone()),
            v: CompensatedVectors::new(start.v.clone()),
            g: system.setting.g(0.25 * system.setting.dt),
            gradients: core::array::from_fn(|_| start.slope.clone()),
        })
    }

    /// (v′ + v)/2 = (q′ − q)/h; (v′ − v)/h = (a(q′, v′, t′) + a(q, v, t))/2.
    fn step(
        &self,
        system: &System<D, A>,
        t: f64,
        memory: &mut Self::Memory,
        solver: &mut Solver<D>,
    ) -> Result<Effort, NotConverged> {
        let ImplicitScene { q, v, gradients, g } = memory;
        let h = system.setting.dt;
        let [gradient, before, earlier] = &*gradients;
        let equation = Equation {
            q: &q.hi,
            q_low: &q.lo,
            h,
            known: Some(gradient),
            g,
            v: &v.hi,
            v_low: &v.lo,
            rate: 2.0 / h,
            last: [gradient, before, earlier],
            last_are_whole: false,
            newton: &self.newton,
        };
        let effort = solver.solve(&equation, &AtEnd { acts: &system.acts, t: t + h })?;
        let (kick, found) = (system.setting.kick.flat(), solver.gradient.flat());
        let change = |i: usize| -0.5 * kick[i] * (gradient.flat()[i] + found[i]);
        CompensatedVectors::kick_and_drift(q, v, h, 0.5, change);
        shift(gradients, &mut solver.gradient);
        Ok(effort)
    }

    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Vectors<D> {
        &memory.q.hi
    }

    fn velocity(&self, _: &System<D, A>, _: f64, memory: &Self::Memory) -> Vectors<D> {
        memory.v.hi.clone()
    }

    fn finite(&self, memory: &Self::Memory) -> bool {
        memory.q.is_finite() && memory.v.is_finite()
    }

    fn kinetic_energy(&self, setting: &Setting<D>, memory: &Self::Memory) -> f64 {
        setting.kinetic_energy(&memory.v.hi)
    }

    /// Σ (F + F′)/2·Δq (2.7).
    fn work(&self, setting: &Setting<D>, before: &Self::Memory, after: &Self::Memory) -> f64 {
        let moved = |i: usize| 0.5 * after.moved(before, i);
        setting.work(&before.gradients[0], moved) + setting.work(&after.gradients[0], moved)
    }
}

impl<const D: usize> ImplicitScene<D> {
    /// Δq, from positions with their low parts.
    fn moved(&self, before: &Self, i: usize) -> f64 {
        self.q.since(&before.q, i)
    }
}
