//! The explicit formulas.

use core::convert::identity;

use dmech_scalar::Real;

use super::by_lane::by_lane;
use super::memory::{memory, q_and_v};
use super::{Effort, Method, Scheme};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::system::{Beginning, Kick, System};

/// The explicit formulas of the first discrete mechanics (Greenspan (1.1)–(1.3); LaBudde–Greenspan (2.7)).
///
/// ```text
/// v′ = v + h a(q),   q′ = q + h (v + v′)/2
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 1 | grows | grows | no | no | 1 force |
///
/// A bound orbit spirals outward. The work-energy balance Kₙ − K₀ = Σ F_k·Δq_k is exact all the same: it is the
/// definition of work that makes it so.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3]));
/// let run = quartic.scheme(Explicit).dt(0.01).run_until(10.0)?;
/// assert!(run.drift(Invariant::WorkEnergy).unwrap().max_relative() < 1e-13);
/// // The energy is gained, step by step.
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() > 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Shapes and units
/// q, v: `[R; D]` in any consistent units; dt in the unit of time.
/// # Reference
/// D. Greenspan, Univ. of Wisconsin, Computer Sciences TR 122 (1971), (1.1)–(1.3) and (5.7)–(5.8).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Explicit;

memory! {
    /// What [`Explicit`] carries.
    pub struct ExplicitMemory<Y> {
        /// Position.
        pub q: Y::Vector,
        /// Velocity.
        pub v: Y::Vector,
    }
    lists {}
    uncarried {
        /// Velocity a step before.
        v_before: Y::Vector,
    }
}

by_lane! { ExplicitMemory { q, v, v_before }; }

impl Method for Explicit {
    const NAME: &'static str = "Explicit";
    const ORDER: u32 = 1;
    const SYMMETRIC: bool = false;

    fn keeps(invariant: Invariant) -> Kept {
        match invariant {
            Invariant::WorkEnergy => Kept::Exact,
            _ => Kept::No,
        }
    }
}

impl<Y: System> Scheme<Y> for Explicit {
    const ALIKE: bool = true;

    type Memory = ExplicitMemory<Y>;
    type Workspace = Y::Room;

    fn workspace(&self, system: &Y, _: &Y::Stride) -> Y::Room {
        system.room()
    }

    fn begin(
        &self,
        _: &Y,
        _: &Y::Stride,
        start: &Beginning<'_, Y>,
        _: &mut Y::Room,
    ) -> Result<Self::Memory, NotConverged> {
        Ok(ExplicitMemory { q: start.q.clone(), v: start.v.clone(), v_before: start.v.clone() })
    }

    /// v′ = v + h a(q); q′ = q + h (v + v′)/2.
    #[inline(always)]
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        memory: &mut Self::Memory,
        room: &mut Y::Room,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let ExplicitMemory { q, v, v_before } = memory;
        core::mem::swap(v, v_before);
        system.kick(room, stride, Kick { t, b: Y::Scalar::ONE, e: 0.0 }, q, v_before, v);
        Y::drift_by_mean(stride, q, v_before, v);
        Ok(Effort::of(1))
    }

    q_and_v! { identity }

    /// F_k·(q_{k+1} − q_k), with F_k as the kick applied it.
    fn work(&self, system: &Y, _: &Y::Stride, _: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
        system.work_of_kick(&after.v_before, &after.v)
    }
}
