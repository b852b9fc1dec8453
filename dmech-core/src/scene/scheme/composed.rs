//! Compositions on scenes.

use super::discrete_gradient::DiscreteGradientScene;
use super::{SceneScheme, Start};
use crate::newton::NotConverged;
use crate::scene::newton::Solver;
use crate::scene::setting::{Setting, System};
use crate::scene::terms::Acts;
use crate::scene::terms::WithoutVelocities;
use crate::scene::vectors::Vectors;
use crate::scheme::{Coefficients, Composed, DiscreteGradient, Effort, Leapfrog};

/// What a composition of [`Leapfrog`] carries for a scene.
#[derive(Clone, Debug)]
pub struct ComposedLeapfrogScene<const D: usize> {
    q: Vectors<D>,
    /// Velocity in the middle of the first stage of the step to come.
    v: Vectors<D>,
    /// ∇Φ − F at q.
    gradient: Vectors<D>,
    /// Work of the last step.
    work: f64,
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for ComposedLeapfrogScene<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![self.q.flat_mut(), self.v.flat_mut(), self.gradient.flat_mut()]
    }
}

impl<const D: usize> ComposedLeapfrogScene<D> {
    /// v + c (h/m) G: the velocity before a kick, or before a part of it.
    fn before(&self, setting: &Setting<D>, c: f64) -> Vectors<D> {
        let mut v = self.v.clone();
        for (i, v) in v.flat_mut().iter_mut().enumerate() {
            *v += c * setting.kick.flat()[i] * self.gradient.flat()[i];
        }
        v
    }
}

impl<C: Coefficients<N>, const N: usize, const D: usize, A: Acts<D> + WithoutVelocities> SceneScheme<D, A>
    for Composed<Leapfrog, C, N>
{
    type Memory = ComposedLeapfrogScene<D>;

    fn begin(
        &self,
        system: &System<D, A>,
        start: Start<'_, D>,
        _: &mut Solver<D>,
    ) -> Result<Self::Memory, NotConverged> {
        let mut gradient = Vectors::zeros(start.q.bodies());
        system.slope(start.q, start.v, start.t, &mut gradient);
        let mut v = start.v.clone();
        for (i, v) in v.flat_mut().iter_mut().enumerate() {
            *v -= 0.5 * C::GAMMA[0] * system.setting.kick.flat()[i] * gradient.flat()[i];
        }
        Ok(ComposedLeapfrogScene { q: start.q.clone(), v, gradient, work: 0.0 })
    }

    /// A drift and a kick for each stage; the kick after the last belongs half to the next step.
    fn step(
        &self,
        system: &System<D, A>,
        t: f64,
        memory: &mut Self::Memory,
        _: &mut Solver<D>,
    ) -> Result<Effort, NotConverged> {
        let ComposedLeapfrogScene { q, v, gradient, work } = memory;
        let (h, kicks) = (system.setting.dt, system.setting.kick.flat());
        *work = 0.0;
        for k in 0..N {
            // The kick before this drift, made at the end of the last stage, did the work F·(mean velocity) in its time.
            let last = Self::KICKS[(k + N - 1) % N];
            let mean = |i: usize| last * h * (v.flat()[i] + 0.5 * last * kicks[i] * gradient.flat()[i]);
            *work += system.setting.work(gradient, mean);
            for (q, v) in q.flat_mut().iter_mut().zip(v.flat()) {
                *q += C::GAMMA[k] * h * v;
            }
            system.slope(q, v, t + Self::ENDS[k] * h, gradient);
            for (v, (kick, gradient)) in v.flat_mut().iter_mut().zip(kicks.iter().zip(gradient.flat())) {
                *v -= Self::KICKS[k] * kick * gradient;
            }
        }
        Ok(Effort { evaluations: N as u32, iterations: 0 })
    }

    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Vectors<D> {
        &memory.q
    }

    /// Without the half kick of the step to come.
    fn velocity(&self, system: &System<D, A>, _: f64, memory: &Self::Memory) -> Vectors<D> {
        memory.before(&system.setting, 0.5 * C::GAMMA[0])
    }

    fn finite(&self, memory: &Self::Memory) -> bool {
        memory.q.is_finite() && memory.v.is_finite()
    }

    /// Σ m v²/2 in the middle of the last stage.
    fn kinetic_energy(&self, setting: &Setting<D>, memory: &Self::Memory) -> f64 {
        setting.kinetic_energy(&memory.before(setting, C::GAMMA[0]))
    }

    /// Σ F·h (v₋ + v₊)/2 over the kicks, v₋ and v₊ being the velocities before and after.
    fn work(&self, _: &Setting<D>, _: &Self::Memory, after: &Self::Memory) -> f64 {
        after.work
    }
}

/// What a composition of [`DiscreteGradient`](struct@DiscreteGradient) carries for a scene.
#[derive(Clone, Debug)]
pub struct ComposedDiscreteGradientScene<const D: usize> {
    state: DiscreteGradientScene<D>,
    /// ∇̄Φ less the mean force in the stages of the last step; ∇Φ − F before the first step.
    gradients: Vec<Vectors<D>>,
    /// The force that is expected in a stage.
    expected: Vectors<D>,
    /// γ_k h, and for each coordinate γ_k h/m and (γ_k h)²/2m; a palindrome.
    stages: Vec<(Setting<D>, Vectors<D>)>,
    /// Work of the last step.
    work: f64,
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for ComposedDiscreteGradientScene<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        let mut all: Vec<&mut [f64]> = self.state.sums_mut().into();
        all.extend(self.gradients.iter_mut().map(|gradient| gradient.flat_mut()));
        all
    }
}

impl<C: Coefficients<N>, const N: usize, const D: usize, A: Acts<D>> SceneScheme<D, A>
    for Composed<DiscreteGradient, C, N>
{
    type Memory = ComposedDiscreteGradientScene<D>;

    fn begin(
        &self,
        system: &System<D, A>,
        start: Start<'_, D>,
        _: &mut Solver<D>,
    ) -> Result<Self::Memory, NotConverged> {
        let state = DiscreteGradientScene::new(system, start);
        let stage = |gamma: &f64| {
            let setting = system.setting.times(*gamma);
            let g = setting.g(0.5 * setting.dt);
            (setting, g)
        };
        Ok(ComposedDiscreteGradientScene {
            gradients: vec![state.gradient().clone(); N],
            expected: state.gradient().clone(),
            stages: C::GAMMA[..N.div_ceil(2)].iter().map(stage).collect(),
            state,
            work: 0.0,
        })
    }

    fn step(
        &self,
        system: &System<D, A>,
        t: f64,
        memory: &mut Self::Memory,
        solver: &mut Solver<D>,
    ) -> Result<Effort, NotConverged> {
        let ComposedDiscreteGradientScene { state, gradients, expected, stages, work } = memory;
        let mut effort = Effort::default();
        *work = 0.0;
        for k in 0..N {
            expected.clear();
            for (w, gradient) in Self::WEIGHTS[k].iter().zip(&*gradients) {
                for (sum, gradient) in expected.flat_mut().iter_mut().zip(gradient.flat()) {
                    *sum += w * gradient;
                }
            }
            let (setting, g) = &stages[k.min(N - 1 - k)];
            let now = t + Self::begins(k) * system.setting.dt;
            let stage = (&system.acts, setting, g);
            // Three equal forces continue to themselves.
            let found = state.moving().advance(stage, now, solver, &self.scheme.newton, [&*expected; 3])?;
            let (gradient, delta) = (&solver.gradient, solver.delta.flat());
            *work += setting.work(gradient, |i| delta[i]);
            core::mem::swap(&mut gradients[k], &mut solver.gradient);
            effort.evaluations += found.evaluations;
            effort.iterations += found.iterations;
        }
        Ok(effort)
    }

    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Vectors<D> {
        &memory.state.sums()[0].hi
    }

    fn velocity(&self, _: &System<D, A>, _: f64, memory: &Self::Memory) -> Vectors<D> {
        memory.state.sums()[1].hi.clone()
    }

    fn finite(&self, memory: &Self::Memory) -> bool {
        memory.state.sums().into_iter().all(|sum| sum.is_finite())
    }

    fn kinetic_energy(&self, setting: &Setting<D>, memory: &Self::Memory) -> f64 {
        setting.kinetic_energy(&memory.state.sums()[1].hi)
    }

    /// Σ (−∇̄Φ + (F + F′)/2)·Δq over the stages.
    fn work(&self, _: &Setting<D>, _: &Self::Memory, after: &Self::Memory) -> f64 {
        after.work
    }
}
