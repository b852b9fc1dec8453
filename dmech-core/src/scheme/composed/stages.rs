//! Compositions of implicit schemes: one step after another, each guessed from the stages of the step before.

use dmech_scalar::Real;

use super::predictor::{Resample, weights};
use super::{Coefficients, Composed, strides};
use crate::newton::NotConverged;
use crate::scheme::by_lane::by_lane;
use crate::scheme::memory::{memory, q_and_v};
use crate::scheme::one_solve::{Begun, Stage};
use crate::scheme::{Effort, Scheme, alike};
use crate::system::{Ahead, Beginning, ImplicitSteps};

memory! {
    /// What a composition of [`DiscreteGradient`](struct@crate::DiscreteGradient) or [`Implicit`](struct@crate::Implicit) carries.
    pub struct StagesMemory<Y, const N: usize> {
        /// Position.
        pub q: Y::Sum,
        /// Velocity.
        pub v: Y::Sum,
    }
    lists {
        /// The slopes that were found in the stages of the last step; ∇Φ − F before the first step.
        slopes: [Y::Vector; N],
    }
    uncarried {
        /// Work of the last step.
        work: Y::Scalar,
    }
}

by_lane! { StagesMemory<const N> { q, v, slopes, work }; }

/// What a step works in.
#[derive(Clone, Debug)]
pub struct StagesRoom<S, T, V, const N: usize> {
    solver: S,
    /// γ_k h and what follows from it.
    strides: [T; N],
    expected: V,
}

impl<S: Stage, C: Coefficients<N>, const N: usize> Composed<S, C, N> {
    const WEIGHTS: [[f64; N]; N] = weights(C::GAMMA, S::SLOPE_AT);
    const RESAMPLE: Resample<N> = Resample::new(C::GAMMA, S::SLOPE_AT);
}

impl<Y: ImplicitSteps, S: Stage, C: Coefficients<N>, const N: usize> Scheme<Y> for Composed<S, C, N> {
    type Memory = StagesMemory<Y, N>;
    type Workspace = StagesRoom<Y::Solver, Y::Stride, Y::Vector, N>;

    fn workspace(&self, system: &Y, stride: &Y::Stride) -> Self::Workspace {
        let strides = strides::<Y, C, N>(system, stride, S::SHARE);
        StagesRoom { solver: system.solver(), strides, expected: system.zero() }
    }

    fn pace(&self, system: &Y, stride: &Y::Stride, workspace: &mut Self::Workspace) {
        workspace.strides = strides::<Y, C, N>(system, stride, S::SHARE);
    }

    fn begin(
        &self,
        _: &Y,
        _: &Y::Stride,
        start: &Beginning<'_, Y>,
        _: &mut Self::Workspace,
    ) -> Result<Self::Memory, NotConverged> {
        let (q, v) = (Y::sum(start.q), Y::sum(start.v));
        Ok(StagesMemory { q, v, slopes: alike(start.slope), work: Y::Scalar::ZERO })
    }

    #[inline(always)]
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        memory: &mut Self::Memory,
        StagesRoom { solver, strides, expected }: &mut Self::Workspace,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let StagesMemory { q, v, slopes, work } = memory;
        let mut effort = Effort::default();
        *work = Y::Scalar::ZERO;
        for k in 0..N {
            Y::weigh(&Self::WEIGHTS[k], slopes, expected);
            let t = Y::Scalar::from_f64(Self::begins(k)).mul_add(Y::dt(stride), t);
            let begun = Begun { stride: &strides[k], t, ahead: Ahead::Expected(expected), solver: &mut *solver };
            // The slope of the stage before, which may be the last of the step before.
            let known = &slopes[(k + N - 1) % N];
            let found = self.scheme.advance(system, begun, known, [q, v])?;
            *work += S::work_of(system, solver, &found, known);
            Y::keep(solver, &found, &mut slopes[k]);
            effort += Y::effort(&found);
        }
        Ok(effort)
    }

    #[inline]
    fn stretch(
        &self,
        system: &Y,
        _: &Y::Stride,
        _: Y::Scalar,
        ratio: Y::Scalar,
        memory: &mut Self::Memory,
        _: &mut Self::Workspace,
    ) -> u32 {
        Self::RESAMPLE.apply(system, ratio, &mut memory.slopes);
        0
    }

    q_and_v! { Y::value }

    /// Σ F·Δq over the stages, with the force that each of them takes.
    fn work(&self, _: &Y, _: &Y::Stride, _: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
        after.work
    }
}
