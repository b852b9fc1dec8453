//! Stages of leap-frog.

use dmech_scalar::Real;

use super::{Coefficients, Composed};
use crate::State;
use crate::law::{Law, Potential, VelocityIndependent};
use crate::newton::NotConverged;
use crate::scheme::{Effort, Leapfrog, Scheme, Stride};
use crate::vector::{add_scaled, difference, finite, scaled, sum, weighted};

/// What a composition of [`Leapfrog`] carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComposedLeapfrogMemory<const D: usize, R = f64> {
    /// Position.
    pub q: [R; D],
    /// Velocity in the middle of the last stage.
    pub v_before: [R; D],
    /// Velocity in the middle of the first stage of the step to come.
    pub v_after: [R; D],
    /// Work of the last step.
    work: R,
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for ComposedLeapfrogMemory<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![&mut self.q, &mut self.v_before, &mut self.v_after]
    }
}

impl<C: Coefficients<N>, const N: usize> Composed<Leapfrog, C, N> {
    /// (γ_k + γ_{k+1})/2: the half kick at the end of a stage and that at the start of the next.
    pub(crate) const KICKS: [f64; N] = {
        let mut kicks = [0.0; N];
        let mut k = 0;
        while k < N {
            kicks[k] = 0.5 * (C::GAMMA[k] + C::GAMMA[(k + 1) % N]);
            k += 1;
        }
        kicks
    };
}

impl<L, C, const N: usize, const D: usize, R: Real> Scheme<L, D, R> for Composed<Leapfrog, C, N>
where
    L: Law<D, R> + VelocityIndependent,
    C: Coefficients<N>,
{
    type Memory = ComposedLeapfrogMemory<D, R>;

    fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
        let State { t, q, v } = *start;
        let field = law.field(stride.mass, R::from_f64(t));
        let half_kick = R::from_f64(0.5 * C::GAMMA[0]) * stride.kick;
        let (v_before, v_after) = (field.kick(-half_kick, q, v), field.kick(half_kick, q, v));
        Ok(ComposedLeapfrogMemory { q, v_before, v_after, work: R::ZERO })
    }

    #[inline(always)]
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged> {
        let ComposedLeapfrogMemory { mut q, mut v_before, mut v_after, .. } = *memory;
        let mut work = R::ZERO;
        for k in 0..N {
            // A kick does the work F·(mean velocity) in its time; the first was made at the end of the step before.
            work += weighted(law.mass_ratios(), difference(v_after, v_before), sum(v_after, v_before));
            q = add_scaled(q, R::from_f64(C::GAMMA[k]) * stride.dt, v_after);
            let now = R::from_f64(Self::ENDS[k]).mul_add(stride.dt, t);
            let kick = R::from_f64(Self::KICKS[k]) * stride.kick;
            v_before = v_after;
            v_after = law.field(stride.mass, now).kick(kick, q, v_before);
        }
        work *= R::from_f64(0.5) * stride.mass;
        *memory = ComposedLeapfrogMemory { q, v_before, v_after, work };
        Ok(Effort { evaluations: N as u32, iterations: 0 })
    }

    #[inline]
    fn position(&self, memory: &Self::Memory) -> [R; D] {
        memory.q
    }

    /// The mean of the velocities around the last kick: half of it belongs to the step that ends.
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

    /// m v²/2 in the middle of the last stage.
    fn kinetic_energy(&self, law: &L, stride: &Stride<R>, memory: &Self::Memory) -> R {
        stride.kinetic_energy(law.mass_ratios(), memory.v_before)
    }

    /// Σ F·h (v₋ + v₊)/2 over the kicks, v₋ and v₊ being the velocities before and after.
    fn work(&self, _: &L, _: &Stride<R>, _: &Self::Memory, after: &Self::Memory) -> R {
        after.work
    }
}
