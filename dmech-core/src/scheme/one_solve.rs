//! Schemes that solve one equation in a step.

use super::by_lane::by_lane;
use super::composed::SlopeAt;
use super::memory::memory;
use super::{Composable, Effort};
use crate::newton::NotConverged;
use crate::system::{Ahead, ImplicitSteps};

memory! {
    /// What [`DiscreteGradient`](struct@super::DiscreteGradient) and [`Implicit`](struct@super::Implicit) carry.
    pub struct OneSolveMemory<Y> {
        /// Position.
        pub q: Y::Sum,
        /// Velocity.
        pub v: Y::Sum,
    }
    lists {
        /// What was found in the last three steps, the newest first: ∇̄Φ less the mean force, or ∇Φ − F at their ends; ∇Φ − F before the
        /// first step.
        slopes: [Y::Vector; 3],
    }
    uncarried {}
}

by_lane! { OneSolveMemory { q, v, slopes }; }

/// A scheme that solves an equation in each step: by itself, and as a stage of a composition.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be composed to a higher order",
    label = "not a symmetric one-step scheme"
)]
pub trait Stage: Composable {
    /// Where in a step its slope belongs.
    #[doc(hidden)]
    const SLOPE_AT: SlopeAt;
    /// The share of h²/m at the unknown force.
    const SHARE: f64;

    /// q and v move. The slope where they begin is `known`, if that is the slope at the end of a step.
    ///
    /// # Errors
    /// [`NotConverged`]
    fn advance<Y: ImplicitSteps>(
        &self,
        system: &Y,
        step: Begun<'_, Y>,
        known: &Y::Vector,
        moves: [&mut Y::Sum; 2],
    ) -> Result<Y::Found, NotConverged>;

    /// The work of a step that was just made.
    fn work_of<Y: ImplicitSteps>(system: &Y, solver: &Y::Solver, found: &Y::Found, known: &Y::Vector) -> Y::Scalar;
}

/// What a step is given: its length, its time, the slope that is expected, where to work.
pub struct Begun<'a, Y: ImplicitSteps> {
    pub(super) stride: &'a Y::Stride,
    pub(super) t: Y::Scalar,
    pub(super) ahead: Ahead<'a, Y::Vector>,
    pub(super) solver: &'a mut Y::Solver,
}

/// One step, guessed from the three before it.
#[inline(always)]
pub(super) fn step<Y: ImplicitSteps, S: Stage>(
    scheme: &S,
    system: &Y,
    (stride, t): (&Y::Stride, Y::Scalar),
    OneSolveMemory { q, v, slopes }: &mut OneSolveMemory<Y>,
    solver: &mut Y::Solver,
) -> Result<Effort<Y::Scalar>, NotConverged> {
    let begun = Begun { stride, t, ahead: Ahead::Continued(slopes.each_ref()), solver: &mut *solver };
    let found = scheme.advance(system, begun, &slopes[0], [q, v])?;
    super::remember::<Y>(solver, &found, slopes);
    Ok(Y::effort(&found))
}

/// What such a scheme is beside its equation and its work.
macro_rules! one_solve {
    () => {
        const SHARE: f64 = <Self as Stage>::SHARE;

        const STRETCHES: bool = false;

        type Memory = OneSolveMemory<Y>;
        type Workspace = Y::Solver;

        fn workspace(&self, system: &Y, _: &Y::Stride) -> Y::Solver {
            system.solver()
        }

        fn begin(
            &self,
            _: &Y,
            _: &Y::Stride,
            start: &crate::system::Beginning<'_, Y>,
            _: &mut Y::Solver,
        ) -> Result<Self::Memory, NotConverged> {
            Ok(OneSolveMemory { q: Y::sum(start.q), v: Y::sum(start.v), slopes: crate::scheme::alike(start.slope) })
        }

        #[inline(always)]
        fn step(
            &self,
            system: &Y,
            stride: &Y::Stride,
            t: Y::Scalar,
            memory: &mut Self::Memory,
            solver: &mut Y::Solver,
        ) -> Result<crate::scheme::Effort<Y::Scalar>, NotConverged> {
            crate::scheme::one_solve::step(self, system, (stride, t), memory, solver)
        }

        crate::scheme::memory::q_and_v! { Y::value }
    };
}

pub(super) use one_solve;
