//! Leap-frog whose sums lose nothing.

use dmech_scalar::Real;

use super::by_lane::by_lane;
use super::memory::memory;
use super::{Effort, Method, Scheme, WithoutVelocities};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::system::{Beginning, System};

/// [`Leapfrog`](crate::Leapfrog) with compensated sums: for runs so long, or steps so short, that rounding matters more
/// than the step.
///
/// ```text
/// q′ = q + h v½,   v½′ = v½ + h a(q′),   each sum with what its roundings left out so far
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 | bounded, O(h²) | exact | yes | yes, to fewer roundings | 1 force |
///
/// A plain sum rounds at each step to an ulp of the position, and N roundings move the planet by √N ulp or, as its period
/// follows its energy, by N^1.5 ulp along the orbit. Here a step rounds the increments h v½ and h a, which are smaller than
/// the position by a factor of the order of h. The scheme is otherwise the same, and costs some additions more.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/spring.md")]
/// // There and back in a hundred thousand short steps each.
/// let there = Simulation::new(Spring { k: 1.7 }, State::new([1.0], [0.3])).dt(1e-3);
/// let off = |run: Run<State<1>>| (run.last().q[0] - 1.0).abs();
/// let plain = there.clone().scheme(Leapfrog).run(100_000)?.last().reversed();
/// let compensated = there.scheme(CompensatedLeapfrog).run(100_000)?.last().reversed();
/// let back = |start| Simulation::new(Spring { k: 1.7 }, start).dt(1e-3);
/// let plain = off(back(plain).scheme(Leapfrog).run(100_000)?);
/// let compensated = off(back(compensated).scheme(CompensatedLeapfrog).run(100_000)?);
/// assert!(compensated < 3e-16 || compensated < plain);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Requires
/// Forces that do not depend on the velocity.
/// # Reference
/// E. Hairer, C. Lubich and G. Wanner, Geometric Numerical Integration (2nd ed., 2006), VIII.5; W. Kahan, Comm. ACM 8 (1965) 40.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CompensatedLeapfrog;

memory! {
    /// What [`CompensatedLeapfrog`] carries.
    pub struct CompensatedLeapfrogMemory<Y> {
        /// Position.
        pub q: Y::Sum,
        /// Velocity half a step after.
        pub v_after: Y::Sum,
        /// What the last kick added to the velocity.
        pub change: Y::Vector,
    }
    lists {}
    uncarried {}
}

by_lane! { CompensatedLeapfrogMemory { q, v_after, change }; }

impl Method for CompensatedLeapfrog {
    const NAME: &'static str = "CompensatedLeapfrog";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        super::Leapfrog::keeps(invariant)
    }
}

impl<Y: System> CompensatedLeapfrogMemory<Y> {
    /// Velocity before a share of the last kick.
    fn before(&self, share: f64) -> Y::Vector {
        let mut v = Y::value(&self.v_after).clone();
        Y::add_scaled(&mut v, Y::Scalar::from_f64(-share), &self.change);
        v
    }
}

impl<Y: System + WithoutVelocities> Scheme<Y> for CompensatedLeapfrog {
    const ALIKE: bool = true;

    type Memory = CompensatedLeapfrogMemory<Y>;
    /// ∇Φ.
    type Workspace = Y::Vector;

    fn workspace(&self, system: &Y, _: &Y::Stride) -> Y::Vector {
        system.zero()
    }

    fn begin(
        &self,
        system: &Y,
        stride: &Y::Stride,
        start: &Beginning<'_, Y>,
        _: &mut Y::Vector,
    ) -> Result<Self::Memory, NotConverged> {
        let (mut v_after, mut change) = (Y::sum(start.v), system.zero());
        system.kick_sum(stride, Y::Scalar::from_f64(0.5), start.slope, &mut v_after, &mut change);
        let half = change.clone();
        Y::add_scaled(&mut change, Y::Scalar::ONE, &half);
        Ok(CompensatedLeapfrogMemory { q: Y::sum(start.q), v_after, change })
    }

    #[inline(always)]
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        memory: &mut Self::Memory,
        slope: &mut Y::Vector,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let CompensatedLeapfrogMemory { q, v_after, change } = memory;
        Y::drift_sum(stride, q, v_after);
        // The force is independent of the velocity.
        system.slope(t + Y::dt(stride), Y::value(q), Y::value(v_after), slope);
        system.kick_sum(stride, Y::Scalar::ONE, slope, v_after, change);
        Ok(Effort::of(1))
    }

    #[inline]
    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Y::Vector {
        Y::value(&memory.q)
    }

    #[inline]
    fn velocity(&self, _: &Y, _: &Y::Stride, _: Y::Scalar, memory: &Self::Memory) -> Y::Vector {
        memory.before(0.5)
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        Y::is_finite(Y::value(&memory.q)) && Y::is_finite(Y::value(&memory.v_after))
    }

    /// Σ m v²/2 at the half step before.
    fn kinetic_energy(&self, system: &Y, memory: &Self::Memory) -> Y::Scalar {
        system.kinetic_energy(&memory.before(1.0))
    }

    /// F_k·(q_{k+1} − q_{k−1})/2, with F_k as the kick applied it.
    fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, _: &Self::Memory) -> Y::Scalar {
        system.work_of_kick(&before.before(1.0), Y::value(&before.v_after))
    }
}
