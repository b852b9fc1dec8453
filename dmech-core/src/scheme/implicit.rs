//! The implicit formulas: the trapezoidal rule.

use dmech_scalar::Real;

use super::composed::SlopeAt;
use super::one_solve::{Begun, OneSolveMemory, Stage, one_solve};
use super::{Method, Newton, Scheme};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::system::{ImplicitSteps, Step};

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
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3]));
/// let run = quartic.scheme(Implicit).dt(0.1).run_until(1000.0)?;
/// assert!(run.drift(Invariant::WorkEnergy).unwrap().max_relative() < 1e-13);
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 6e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// `Implicit` is a value and a type; `Implicit.with(...)` sets options.
///
/// # Errors
/// A run ends with [`Error::NotConverged`](crate::Error::NotConverged), which has the corrections made and the last of them, or, where
/// the law is not finite on the way, with [`Error::LawInStep`](crate::Error::LawInStep).
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

impl Stage for Implicit {
    const SLOPE_AT: SlopeAt = SlopeAt::End;
    const SHARE: f64 = 0.25;

    /// (v′ + v)/2 = (q′ − q)/h; (v′ − v)/h = (a(q′, v′, t′) + a(q, v, t))/2.
    #[inline(always)]
    fn advance<Y: ImplicitSteps>(
        &self,
        system: &Y,
        Begun { stride, t, ahead, solver }: Begun<'_, Y>,
        known: &Y::Vector,
        [q, v]: [&mut Y::Sum; 2],
    ) -> Result<Y::Found, NotConverged> {
        let mut found = system.solve_mean(solver, &Step { stride, t, q, v, ahead, newton: &self.newton }, known)?;
        system.settle_mean(solver, stride, known, &mut found, [q, v]);
        Ok(found)
    }

    #[inline(always)]
    fn work_of<Y: ImplicitSteps>(system: &Y, solver: &Y::Solver, found: &Y::Found, known: &Y::Vector) -> Y::Scalar {
        let of = |slope| system.work_along(slope, Y::moved(solver, found));
        Y::Scalar::from_f64(0.5) * (of(known) + of(Y::found(solver, found)))
    }
}

impl<Y: ImplicitSteps> Scheme<Y> for Implicit {
    one_solve! {}

    /// (F + F′)/2·Δq (2.7).
    fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
        let of = |slope| system.work_between(slope, &before.q, &after.q);
        Y::Scalar::from_f64(0.5) * (of(&before.slopes[0]) + of(&after.slopes[0]))
    }
}
