//! The energy-exact one-step scheme.

use super::composed::SlopeAt;
use super::one_solve::{Begun, OneSolveMemory, Stage, one_solve};
use super::{Method, Newton, Scheme};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::system::{ImplicitSteps, Step};

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
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3]));
/// // However long the step is.
/// for dt in [0.1, 1.0] {
///     let run = quartic.clone().scheme(DiscreteGradient).dt(dt).run_until(1000.0)?;
///     assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// `DiscreteGradient` is a value and a type; `DiscreteGradient.with(...)` sets options.
///
/// # Requires
/// Φ finite on both ends of each step; for a law that names the time the discrete gradient is that of the mid-time.
/// # Errors
/// A run ends with [`Error::NotConverged`](crate::Error::NotConverged), which has the corrections made and the last of them, or, where
/// the law is not finite on the way, with [`Error::LawInStep`](crate::Error::LawInStep).
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

impl Stage for DiscreteGradient {
    const SLOPE_AT: SlopeAt = SlopeAt::Middle;
    const SHARE: f64 = 0.5;

    /// (v′ + v)/2 = (q′ − q)/h; m (v′ − v)/h = −∇̄Φ(q, q′) + (F + F′)/2.
    #[inline(always)]
    fn advance<Y: ImplicitSteps>(
        &self,
        system: &Y,
        Begun { stride, t, ahead, solver }: Begun<'_, Y>,
        _: &Y::Vector,
        [q, v]: [&mut Y::Sum; 2],
    ) -> Result<Y::Found, NotConverged> {
        let mut found = system.solve_exact(solver, &Step { stride, t, q, v, ahead, newton: &self.newton })?;
        system.settle(solver, stride, 0.5, &mut found, [q, v]);
        Ok(found)
    }

    #[inline(always)]
    fn work_of<Y: ImplicitSteps>(system: &Y, solver: &Y::Solver, found: &Y::Found, _: &Y::Vector) -> Y::Scalar {
        system.work_along(Y::found(solver, found), Y::moved(solver, found))
    }
}

impl<Y: ImplicitSteps> Scheme<Y> for DiscreteGradient {
    one_solve! {}

    /// (−∇̄Φ(q, q′) + (F + F′)/2)·Δq.
    fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
        system.work_between(&after.slopes[0], &before.q, &after.q)
    }
}
