//! Compositions of implicit schemes: one step after another, each guessed from the stages of the step before.

use dmech_scalar::Real;

use super::predictor::{Resample, SlopeAt, weights};
use super::{Coefficients, Composable, Composed, strides};
use crate::newton::NotConverged;
use crate::scheme::by_lane::by_lane;
use crate::scheme::memory::{memory, q_and_v};
use crate::scheme::{DiscreteGradient, Effort, Implicit, Scheme, alike};
use crate::system::{Ahead, Beginning, ImplicitSteps, Step};

memory! {
    /// What a composition of [`DiscreteGradient`](struct@DiscreteGradient) or [`Implicit`](struct@Implicit) carries.
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

/// A scheme that solves an equation in each stage.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be composed to a higher order",
    label = "not a symmetric one-step scheme"
)]
pub trait Stage: Composable {
    /// Where in a stage its slope belongs.
    #[doc(hidden)]
    const SLOPE_AT: SlopeAt;
    /// The share of h²/m at the unknown force.
    const SHARE: f64;

    /// Stage k: q and v move, and its slope is replaced by the one that was found; its cost and its work come back.
    ///
    /// # Errors
    /// [`NotConverged`]
    fn advance<Y: ImplicitSteps, const N: usize>(
        &self,
        system: &Y,
        stage: InStage<'_, Y>,
        moves: [&mut Y::Sum; 2],
        slopes: &mut [Y::Vector; N],
    ) -> Result<(Effort<Y::Scalar>, Y::Scalar), NotConverged>;
}

/// What a stage is given: its number, its length, the time, the slope that is expected, where to work.
pub struct InStage<'a, Y: ImplicitSteps> {
    k: usize,
    stride: &'a Y::Stride,
    t: Y::Scalar,
    ahead: Ahead<'a, Y::Vector>,
    solver: &'a mut Y::Solver,
}

/// (v′ + v)/2 = (q′ − q)/h; m (v′ − v)/h = −∇̄Φ(q, q′) + (F + F′)/2.
impl Stage for DiscreteGradient {
    const SLOPE_AT: SlopeAt = SlopeAt::Middle;
    const SHARE: f64 = Self::SHARE;

    #[inline(always)]
    fn advance<Y: ImplicitSteps, const N: usize>(
        &self,
        system: &Y,
        InStage { k, stride, t, ahead, solver }: InStage<'_, Y>,
        [q, v]: [&mut Y::Sum; 2],
        slopes: &mut [Y::Vector; N],
    ) -> Result<(Effort<Y::Scalar>, Y::Scalar), NotConverged> {
        let mut found = system.solve_exact(solver, &Step { stride, t, q, v, ahead, newton: &self.newton })?;
        system.settle(solver, stride, 0.5, &mut found, [q, v]);
        let work = system.work_along(Y::found(solver, &found), Y::moved(solver, &found));
        Y::keep(solver, &found, &mut slopes[k]);
        Ok((Y::effort(&found), work))
    }
}

/// (v′ + v)/2 = (q′ − q)/h; (v′ − v)/h = (a(q′, v′, t′) + a(q, v, t))/2.
impl Stage for Implicit {
    const SLOPE_AT: SlopeAt = SlopeAt::End;
    const SHARE: f64 = Self::SHARE;

    #[inline(always)]
    fn advance<Y: ImplicitSteps, const N: usize>(
        &self,
        system: &Y,
        InStage { k, stride, t, ahead, solver }: InStage<'_, Y>,
        [q, v]: [&mut Y::Sum; 2],
        slopes: &mut [Y::Vector; N],
    ) -> Result<(Effort<Y::Scalar>, Y::Scalar), NotConverged> {
        // The slope at the end of the stage before, which may be the last of the step before.
        let known = &slopes[(k + N - 1) % N];
        let mut found = system.solve_mean(solver, &Step { stride, t, q, v, ahead, newton: &self.newton }, known)?;
        system.settle_mean(solver, stride, known, &mut found, [q, v]);
        let of = |slope| system.work_along(slope, Y::moved(solver, &found));
        let work = Y::Scalar::from_f64(0.5) * (of(known) + of(Y::found(solver, &found)));
        Y::keep(solver, &found, &mut slopes[k]);
        Ok((Y::effort(&found), work))
    }
}

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
            let stage = InStage { k, stride: &strides[k], t, ahead: Ahead::Expected(expected), solver };
            let (cost, done) = self.scheme.advance(system, stage, [q, v], slopes)?;
            *work += done;
            effort += cost;
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
