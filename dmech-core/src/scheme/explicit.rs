//! The explicit formulas.

use dmech_scalar::Real;

use super::{Effort, Method, Scheme, Stride};
use crate::State;
use crate::invariant::{Invariant, Kept};
use crate::law::{Law, Potential};
use crate::newton::NotConverged;
use crate::vector::{add_scaled, difference, finite, scaled, sum, weighted};

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
/// # Shapes and units
/// q, v: `[R; D]` in any consistent units; dt in the unit of time.
/// # Reference
/// D. Greenspan, Univ. of Wisconsin, Computer Sciences TR 122 (1971), (1.1)–(1.3) and (5.7)–(5.8).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Explicit;

/// What [`Explicit`] carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExplicitMemory<const D: usize, R = f64> {
    /// Position.
    pub q: [R; D],
    /// Velocity.
    pub v: [R; D],
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for ExplicitMemory<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![&mut self.q, &mut self.v]
    }
}

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

impl<L: Law<D, R>, const D: usize, R: Real> Scheme<L, D, R> for Explicit {
    type Memory = ExplicitMemory<D, R>;

    fn begin(&self, _: &L, _: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
        Ok(ExplicitMemory { q: start.q, v: start.v })
    }

    #[inline(always)]
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged> {
        let ExplicitMemory { q, v } = *memory;
        let v_next = law.field(stride.mass, t).kick(stride.kick, q, v);
        let q_next = add_scaled(q, R::from_f64(0.5) * stride.dt, sum(v, v_next));
        *memory = ExplicitMemory { q: q_next, v: v_next };
        Ok(Effort { evaluations: 1, iterations: 0 })
    }

    #[inline]
    fn position(&self, memory: &Self::Memory) -> [R; D] {
        memory.q
    }

    #[inline]
    fn velocity(&self, _: &L, _: &Stride<R>, _: R, memory: &Self::Memory) -> [R; D] {
        memory.v
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        finite(memory.q) && finite(memory.v)
    }

    fn kinetic_energy(&self, law: &L, stride: &Stride<R>, memory: &Self::Memory) -> R {
        stride.kinetic_energy(law.mass_ratios(), memory.v)
    }

    /// F_k·(q_{k+1} − q_k), with F_k as the kick applied it.
    fn work(&self, law: &L, stride: &Stride<R>, before: &Self::Memory, after: &Self::Memory) -> R {
        let force = scaled(stride.kick.recip(), difference(after.v, before.v));
        weighted(law.mass_ratios(), force, difference(after.q, before.q))
    }
}
