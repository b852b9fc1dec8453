//! Leap-frog.

use dmech_scalar::Real;

use super::{Effort, Method, Scheme, Stride};
use crate::State;
use crate::invariant::{Invariant, Kept};
use crate::law::{Law, Potential, VelocityIndependent};
use crate::newton::NotConverged;
use crate::vector::{add_scaled, difference, finite, scaled, sum, weighted};

/// Leap-frog: positions at whole steps, velocities at half steps (Greenspan (3.2)–(3.6); Kanatani (2.14)–(2.15)).
///
/// ```text
/// v½ = v + (h/2) a(q);   then   q′ = q + h v½,   v½′ = v½ + h a(q′)
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 | bounded, O(h²) | exact | yes | yes | 1 force |
///
/// The velocity of a state is the mean of the two half steps around it. It is computed only when a state is asked for;
/// the half-step velocities themselves are in [`LeapfrogMemory`]. Work is F_k·(q_{k+1} − q_{k−1})/2, with the
/// kinetic energy of the half steps, as Greenspan §3 suggests and Kanatani (3.3) carries out.
///
/// # Requires
/// Forces that do not depend on the velocity (Greenspan §3, last sentence).
/// # Reference
/// D. Greenspan, Univ. of Wisconsin, Computer Sciences TR 122 (1971), §3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Leapfrog;

/// What [`Leapfrog`] carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeapfrogMemory<const D: usize, R = f64> {
    /// Position.
    pub q: [R; D],
    /// Velocity half a step before.
    pub v_before: [R; D],
    /// Velocity half a step after.
    pub v_after: [R; D],
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for LeapfrogMemory<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![&mut self.q, &mut self.v_before, &mut self.v_after]
    }
}

impl Method for Leapfrog {
    const NAME: &'static str = "Leapfrog";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        match invariant {
            Invariant::Energy => Kept::Bounded,
            Invariant::WorkEnergy | Invariant::AngularMomentum | Invariant::LinearMomentum => Kept::Exact,
            Invariant::DiscreteEnergy => Kept::No,
        }
    }
}

impl<L: Law<D, R> + VelocityIndependent, const D: usize, R: Real> Scheme<L, D, R> for Leapfrog {
    type Memory = LeapfrogMemory<D, R>;

    fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
        let State { t, q, v } = *start;
        let field = law.field(stride.mass, R::from_f64(t));
        let half_kick = R::from_f64(0.5) * stride.kick;
        Ok(LeapfrogMemory { q, v_before: field.kick(-half_kick, q, v), v_after: field.kick(half_kick, q, v) })
    }

    #[inline(always)]
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged> {
        let q = add_scaled(memory.q, stride.dt, memory.v_after);
        let v_before = memory.v_after;
        let v_after = law.field(stride.mass, t + stride.dt).kick(stride.kick, q, v_before);
        *memory = LeapfrogMemory { q, v_before, v_after };
        Ok(Effort { evaluations: 1, iterations: 0 })
    }

    #[inline]
    fn position(&self, memory: &Self::Memory) -> [R; D] {
        memory.q
    }

    #[inline]
    fn velocity(&self, _: &L, _: &Stride<R>, _: R, memory: &Self::Memory) -> [R; D] {
        // Halves first: the sum of two finite velocities need not be finite.
        let half = R::from_f64(0.5);
        sum(scaled(half, memory.v_before), scaled(half, memory.v_after))
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        finite(memory.q) && finite(memory.v_after)
    }

    /// m v²/2 at the half step before.
    fn kinetic_energy(&self, law: &L, stride: &Stride<R>, memory: &Self::Memory) -> R {
        stride.kinetic_energy(law.mass_ratios(), memory.v_before)
    }

    /// F_k·(q_{k+1} − q_{k−1})/2, with F_k as the kick applied it and q_k − q_{k−1} = h v_{k−½}.
    fn work(&self, law: &L, stride: &Stride<R>, before: &Self::Memory, after: &Self::Memory) -> R {
        let force = scaled(stride.kick.recip(), difference(before.v_after, before.v_before));
        let two_steps = add_scaled(difference(after.q, before.q), stride.dt, before.v_before);
        R::from_f64(0.5) * weighted(law.mass_ratios(), force, two_steps)
    }
}
