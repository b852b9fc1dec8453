//! The energy-exact scheme on scenes.

use super::{SceneScheme, Start, shift};
use crate::newton::NotConverged;
use crate::scene::compensated::CompensatedVectors;
use crate::scene::matrix::Matrix;
use crate::scene::newton::{Equation, Solver, Unknown};
use crate::scene::setting::{Setting, System};
use crate::scene::terms::Acts;
use crate::scene::terms::stencil::Stencil;
use crate::scene::vectors::Vectors;
use crate::scheme::{DiscreteGradient, Effort, Newton};

/// What [`DiscreteGradient`](struct@DiscreteGradient) carries for a scene.
#[derive(Debug)]
pub struct DiscreteGradientScene<const D: usize> {
    q: CompensatedVectors<D>,
    v: CompensatedVectors<D>,
    /// ∇̄Φ less the mean force of the last three steps, the newest first; ∇Φ − F before the first step.
    gradients: [Vectors<D>; 3],
    /// −F/2 at the start of the step.
    half_force: Vectors<D>,
    g: Vectors<D>,
}

cloned_in_place!(DiscreteGradientScene { q, v, gradients, half_force, g });

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for DiscreteGradientScene<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        let [q, q_low] = self.q.parts_mut();
        let [v, v_low] = self.v.parts_mut();
        let [newest, second, third] = self.gradients.each_mut().map(|gradient| gradient.flat_mut());
        vec![q, q_low, v, v_low, newest, second, third]
    }
}

/// ∇̄Φ(a, b) − F(b, v)/2.
struct Exact<'a, const D: usize, A> {
    acts: &'a A,
    a: &'a Vectors<D>,
    middle: f64,
    end: f64,
}

impl<const D: usize, A: Acts<D>> Unknown<D> for Exact<'_, D, A> {
    const LINEAR: bool = A::LINEAR && !A::FORCED;
    const PIECEWISE: bool = A::PIECEWISE;
    const FORCED: bool = A::FORCED;
    const EXACT: bool = true;

    fn gradient(&self, _: f64, b: &Vectors<D>, v: &Vectors<D>, out: &mut Vectors<D>) {
        self.acts.set_discrete_gradient(self.a, b, self.middle, out);
        self.acts.subtract_force(0.5, b, v, self.end, out);
    }

    fn jacobian(&self, _: f64, b: &Vectors<D>, v: &Vectors<D>, rate: f64, out: &mut Matrix<D>) {
        self.acts.add_discrete_jacobian(self.a, b, self.middle, out);
        self.acts.subtract_force_jacobian(0.5, b, v, self.end, rate, out);
    }

    #[inline(always)]
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>) {
        self.acts.add_discrete_stencil(self.a, b, self.middle, first, out);
    }
}

impl<const D: usize> DiscreteGradientScene<D> {
    pub(super) fn new<A: Acts<D>>(system: &System<D, A>, start: Start<'_, D>) -> Self {
        let gradient = start.slope;
        DiscreteGradientScene {
            q: CompensatedVectors::new(start.q.clone()),
            v: CompensatedVectors::new(start.v.clone()),
            half_force: gradient.clone(),
            g: system.setting.g(0.5 * system.setting.dt),
            gradients: core::array::from_fn(|_| gradient.clone()),
        }
    }

    /// One step; the force then joins those of the last steps.
    fn advance<A: Acts<D>>(
        &mut self,
        system: &System<D, A>,
        t: f64,
        solver: &mut Solver<D>,
        newton: &Newton,
    ) -> Result<Effort, NotConverged> {
        let DiscreteGradientScene { q, v, gradients, half_force, g } = self;
        let (moving, last) = (Moving { q, v, half_force }, gradients.each_ref());
        let effort = moving.advance((&system.acts, &system.setting, g), t, solver, newton, last)?;
        shift(gradients, &mut solver.gradient);
        Ok(effort)
    }

    /// What a step changes.
    pub(super) fn moving(&mut self) -> Moving<'_, D> {
        Moving { q: &mut self.q, v: &mut self.v, half_force: &mut self.half_force }
    }

    /// ∇̄Φ less the mean force of the last step.
    pub(super) fn gradient(&self) -> &Vectors<D> {
        &self.gradients[0]
    }

    /// q and v with their low parts.
    pub(super) fn sums(&self) -> [&CompensatedVectors<D>; 2] {
        [&self.q, &self.v]
    }

    /// q and v with their low parts, as lists of numbers.
    #[cfg(feature = "serde")]
    pub(super) fn sums_mut(&mut self) -> [&mut [f64]; 4] {
        let [q, q_low] = self.q.parts_mut();
        let [v, v_low] = self.v.parts_mut();
        [q, q_low, v, v_low]
    }
}

/// Position and velocity, and vectors that a step needs for itself.
pub(super) struct Moving<'a, const D: usize> {
    q: &'a mut CompensatedVectors<D>,
    v: &'a mut CompensatedVectors<D>,
    half_force: &'a mut Vectors<D>,
}

impl<const D: usize> Moving<'_, D> {
    /// (v′ + v)/2 = (q′ − q)/h; (v′ − v)/h = −∇̄Φ(q, q′) + (F + F′)/2, with the h of the setting, and g = h²/2m. The guess
    /// continues the three forces. Δq and the force are left in the solver.
    pub(super) fn advance<A: Acts<D>>(
        self,
        (acts, setting, g): (&A, &Setting<D>, &Vectors<D>),
        t: f64,
        solver: &mut Solver<D>,
        newton: &Newton,
        forces: [&Vectors<D>; 3],
    ) -> Result<Effort, NotConverged> {
        let Moving { q, v, half_force } = self;
        let h = setting.dt;
        // The share of the force at the start of the step is known.
        if A::FORCED {
            half_force.clear();
            acts.subtract_force(0.5, &q.hi, &v.hi, t, half_force);
        }
        let equation = Equation {
            q: &q.hi,
            q_low: &q.lo,
            h,
            known: A::FORCED.then_some(&*half_force),
            g,
            v: &v.hi,
            v_low: &v.lo,
            rate: 2.0 / h,
            last: forces,
            last_are_whole: true,
            newton,
        };
        let unknown = Exact { acts, a: &q.hi, middle: t + 0.5 * h, end: t + h };
        let effort = solver.solve(&equation, &unknown)?;
        if A::FORCED {
            for (found, half) in solver.gradient.flat_mut().iter_mut().zip(half_force.flat()) {
                *found += half;
            }
        }
        let (kick, found, rest) = (setting.kick.flat(), solver.gradient.flat(), solver.rest.flat());
        let change = |i: usize| [-kick[i] * found[i], -kick[i] * rest[i]];
        CompensatedVectors::kick_in_parts_and_drift(q, v, h, 0.5, change);
        Ok(effort)
    }
}

/// One step back from the start, for schemes that need the position before it.
pub(super) fn step_back<const D: usize, A: Acts<D> + Clone>(
    system: &System<D, A>,
    start: Start<'_, D>,
    solver: &mut Solver<D>,
    newton: &Newton,
) -> Result<Vectors<D>, NotConverged> {
    let back = System { acts: system.acts.clone(), setting: system.setting.times(-1.0) };
    let mut before = DiscreteGradientScene::new(&back, start);
    before.advance(&back, start.t, solver, newton)?;
    Ok(before.q.hi)
}

impl<const D: usize, A: Acts<D>> SceneScheme<D, A> for DiscreteGradient {
    type Memory = DiscreteGradientScene<D>;
    type Workspace = Solver<D>;

    fn begin(
        &self,
        system: &System<D, A>,
        start: Start<'_, D>,
        _: &mut Solver<D>,
    ) -> Result<Self::Memory, NotConverged> {
        Ok(DiscreteGradientScene::new(system, start))
    }

    fn step(
        &self,
        system: &System<D, A>,
        t: f64,
        memory: &mut Self::Memory,
        solver: &mut Solver<D>,
    ) -> Result<Effort, NotConverged> {
        memory.advance(system, t, solver, &self.newton)
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

    /// Σ (−∇̄Φ(q, q′) + (F + F′)/2)·Δq.
    fn work(&self, setting: &Setting<D>, before: &Self::Memory, after: &Self::Memory) -> f64 {
        setting.work(&after.gradients[0], |i| after.q.since(&before.q, i))
    }
}
