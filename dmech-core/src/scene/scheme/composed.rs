//! Compositions of the energy-exact scheme on scenes.

use super::discrete_gradient::DiscreteGradientScene;
use super::{SceneScheme, Start};
use crate::newton::NotConverged;
use crate::scene::newton::Solver;
use crate::scene::setting::{Setting, System};
use crate::scene::terms::Acts;
use crate::scene::vectors::Vectors;
use crate::scheme::{Coefficients, Composed, DiscreteGradient, Effort};

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
    type Workspace = Solver<D>;

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
