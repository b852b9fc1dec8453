//! The implicit formulas: the trapezoidal rule.

use dmech_scalar::Real;

use super::by_lane::by_lane;
use super::memory::{memory, one_solve};
use super::{Effort, Method, Newton, Scheme, remember};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::system::{Ahead, ImplicitSteps, Step};

/// The implicit formulas (Greenspan (2.1)–(2.5)): mean velocity and mean acceleration.
///
/// ```text
/// (v′ + v)/2 = (q′ − q)/h,   (v′ − v)/h = (a(q′, v′, t′) + a(q, v, t))/2
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 | bounded, O(h²) | bounded | conjugate | yes | 1 nonlinear solve |
///
/// Position and velocity are compensated sums. The velocity is eliminated, Newton acts on the increment Δ = q′ − q, and v′ = v + h (a +
/// a′)/2: v′ = 2Δ/h − v would amplify the round-off by 1/h. The work-energy balance holds with the mean force, W = Σ (F + F′)/2·Δq
/// (2.7)–(2.9).
///
/// `Implicit` is a value and a type; `Implicit.with(...)` sets options.
///
/// # Errors
/// [`NotConverged`] with iterations and residual.
/// # Reference
/// D. Greenspan, Univ. of Wisconsin, Computer Sciences TR 122 (1971), §2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Implicit {
    pub(crate) newton: Newton,
}

/// [`Implicit`](struct@Implicit) with the default options.
#[expect(non_upper_case_globals)]
pub const Implicit: Implicit = Implicit { newton: Newton::DEFAULT };

impl Implicit {
    /// The same scheme with other options for the solution of its equation.
    pub const fn with(self, newton: Newton) -> Self {
        Implicit { newton }
    }
}

memory! {
    /// What [`Implicit`](struct@Implicit) carries.
    pub struct ImplicitMemory<Y> {
        /// Position.
        pub q: Y::Sum,
        /// Velocity.
        pub v: Y::Sum,
    }
    lists {
        /// ∇Φ − F in the last three states, the newest first.
        slopes: [Y::Vector; 3],
    }
    uncarried {}
}

by_lane! { ImplicitMemory { q, v, slopes }; }

impl Method for Implicit {
    const NAME: &'static str = "Implicit";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        match invariant {
            Invariant::Energy | Invariant::AngularMomentum => Kept::Bounded,
            Invariant::WorkEnergy | Invariant::LinearMomentum => Kept::Exact,
            Invariant::DiscreteEnergy => Kept::No,
        }
    }
}

impl Implicit {
    /// The share of h²/m at the unknown force.
    pub(super) const SHARE: f64 = 0.25;
}

impl<Y: ImplicitSteps> Scheme<Y> for Implicit {
    one_solve! { ImplicitMemory }

    /// (v′ + v)/2 = (q′ − q)/h; (v′ − v)/h = (a(q′, v′, t′) + a(q, v, t))/2.
    #[inline(always)]
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        memory: &mut Self::Memory,
        solver: &mut Y::Solver,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let ImplicitMemory { q, v, slopes } = memory;
        let ahead = Ahead::Continued(slopes.each_ref());
        let step = Step { stride, t, q, v, ahead, newton: &self.newton };
        let mut found = system.solve_mean(solver, &step, &slopes[0])?;
        system.settle_mean(solver, stride, &slopes[0], &mut found, [q, v]);
        remember::<Y>(solver, &found, slopes);
        Ok(Y::effort(&found))
    }

    /// (F + F′)/2·Δq (2.7).
    fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
        let of = |slope| system.work_between(slope, &before.q, &after.q);
        Y::Scalar::from_f64(0.5) * (of(&before.slopes[0]) + of(&after.slopes[0]))
    }
}
