//! The energy-exact one-step scheme.

use super::by_lane::by_lane;
use super::memory::{memory, one_solve};
use super::{Effort, Method, Newton, Scheme, remember};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::system::{Ahead, ImplicitSteps, Step};

/// The energy-exact step (LaBudde–Greenspan): mean velocity, and the force as a discrete gradient.
///
/// ```text
/// (v′ + v)/2 = (q′ − q)/h,   m (v′ − v)/h = −∇̄Φ(q, q′),   ∇̄Φ(a, b)·(b − a) = Φ(b) − Φ(a)
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 | exact, for any sequence of steps | exact (central laws) | no | yes | 1 nonlinear solve |
///
/// Beside a force the second equation is m (v′ − v)/h = −∇̄Φ + (F + F′)/2: the change of energy is the work of that force,
/// exactly. A force that does no work at any velocity, as v × B, is taken at the mean position and mean velocity
/// instead, where it does none in the step either. In a magnetic field that lowers the drift of grad B and the mirror force by the
/// factor 1/(1 + (ωh/2)²), ω the frequency of gyration: [`Boris`](crate::Boris) is the scheme for guiding centres, or ωh < 0.1.
///
/// Multiplying the second equation by Δq = q′ − q gives K′ − K = −(Φ′ − Φ). Position and velocity are compensated
/// sums: their rounding would otherwise be the largest error of the energy, and grow in proportion to the time.
///
/// `DiscreteGradient` is a value and a type; `DiscreteGradient.with(...)` sets options.
///
/// # Requires
/// Φ finite on both ends of each step; for a law that names the time the discrete gradient is that of the mid-time.
/// # Errors
/// [`NotConverged`] with iterations and residual.
/// # Reference
/// R. LaBudde and D. Greenspan, J. Comput. Phys. 15 (1974) 134; K. Kanatani, J. Comput. Phys. (1983–84), §3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DiscreteGradient {
    pub(crate) newton: Newton,
}

/// [`DiscreteGradient`](struct@DiscreteGradient) with the default options.
#[expect(non_upper_case_globals)]
pub const DiscreteGradient: DiscreteGradient = DiscreteGradient { newton: Newton::DEFAULT };

impl DiscreteGradient {
    /// The same scheme with other options for the solution of its equation.
    pub const fn with(self, newton: Newton) -> Self {
        DiscreteGradient { newton }
    }
}

memory! {
    /// What [`DiscreteGradient`](struct@DiscreteGradient) carries.
    pub struct DiscreteGradientMemory<Y> {
        /// Position.
        pub q: Y::Sum,
        /// Velocity.
        pub v: Y::Sum,
    }
    lists {
        /// ∇̄Φ less the mean force of the last three steps, the newest first; ∇Φ − F before the first step.
        slopes: [Y::Vector; 3],
    }
    uncarried {}
}

by_lane! { DiscreteGradientMemory { q, v, slopes }; }

impl Method for DiscreteGradient {
    const NAME: &'static str = "DiscreteGradient";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        match invariant {
            Invariant::DiscreteEnergy => Kept::No,
            _ => Kept::Exact,
        }
    }
}

impl DiscreteGradient {
    /// The share of h²/m at the unknown force.
    pub(super) const SHARE: f64 = 0.5;
}

impl<Y: ImplicitSteps> Scheme<Y> for DiscreteGradient {
    one_solve! { DiscreteGradientMemory }

    /// (v′ + v)/2 = (q′ − q)/h; m (v′ − v)/h = −∇̄Φ(q, q′) + (F + F′)/2.
    #[inline(always)]
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        memory: &mut Self::Memory,
        solver: &mut Y::Solver,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let DiscreteGradientMemory { q, v, slopes } = memory;
        let ahead = Ahead::Continued(slopes.each_ref());
        let mut found = system.solve_exact(solver, &Step { stride, t, q, v, ahead, newton: &self.newton })?;
        system.settle(solver, stride, 0.5, &mut found, [q, v]);
        remember::<Y>(solver, &found, slopes);
        Ok(Y::effort(&found))
    }

    /// (−∇̄Φ(q, q′) + (F + F′)/2)·Δq.
    fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
        system.work_between(&after.slopes[0], &before.q, &after.q)
    }
}
