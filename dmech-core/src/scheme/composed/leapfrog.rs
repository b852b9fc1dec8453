//! Stages of leap-frog: drifts of γ_k h, and between them the half kicks of both neighbours in one.

use dmech_scalar::Real;

use super::{Coefficients, Composed};
use crate::State;
use crate::law::{Law, VelocityIndependent};
use crate::newton::NotConverged;
use crate::scheme::splitting::{First, Splitting, SplittingMemory};
use crate::scheme::{Effort, Leapfrog, Scheme, Stride};

impl<C: Coefficients<N>, const N: usize> Splitting<N> for Composed<Leapfrog, C, N> {
    const FIRST: First = First::Kick;
    const DRIFTS: [f64; N] = C::GAMMA;
    /// γ₁/2, and (γ_{k−1} + γ_k)/2: the half kick at the end of a stage and that at the start of the next.
    const KICKS: [f64; N] = {
        let mut kicks = [0.5 * C::GAMMA[0]; N];
        let mut k = 1;
        while k < N {
            kicks[k] = 0.5 * (C::GAMMA[k - 1] + C::GAMMA[k]);
            k += 1;
        }
        kicks
    };
    const GRADIENTS: [f64; N] = [0.0; N];
    const DRIFTS_LOW: [f64; N] = C::LOW;
    const KICKS_LOW: [f64; N] = {
        let mut low = [0.5 * C::LOW[0]; N];
        let mut k = 1;
        while k < N {
            // The rounding of γ_{k−1} + γ_k, which is exact in two parts (see `two_sum`).
            let (a, b) = (C::GAMMA[k - 1], C::GAMMA[k]);
            let part = (a + b) - a;
            let rounding = (a - ((a + b) - part)) + (b - part);
            low[k] = 0.5 * (rounding + (C::LOW[k - 1] + C::LOW[k]));
            k += 1;
        }
        low
    };
}

impl<L, C, const N: usize, const D: usize, R: Real> Scheme<L, D, R> for Composed<Leapfrog, C, N>
where
    L: Law<D, R> + VelocityIndependent,
    C: Coefficients<N>,
{
    type Memory = SplittingMemory<D, R>;

    fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
        Ok(SplittingMemory::new::<Self, L, N>(law, stride, start))
    }

    #[inline(always)]
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged> {
        Ok(memory.advance::<Self, L, N>(law, stride, t))
    }

    #[inline(always)]
    fn stretch(&self, law: &L, stride: &Stride<R>, t: R, _: R, memory: &mut Self::Memory) -> u32 {
        memory.stretch::<Self, L, N>(law, stride, t)
    }

    #[inline]
    fn position(&self, memory: &Self::Memory) -> [R; D] {
        memory.q
    }

    #[inline]
    fn velocity(&self, _: &L, _: &Stride<R>, _: R, memory: &Self::Memory) -> [R; D] {
        memory.velocity()
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        memory.finite()
    }

    /// m v²/2 before the kick that belongs half to the step to come.
    fn kinetic_energy(&self, law: &L, stride: &Stride<R>, memory: &Self::Memory) -> R {
        stride.kinetic_energy(law.mass_ratios(), memory.v_before)
    }

    /// Σ F·h (v₋ + v₊)/2 over the kicks, v₋ and v₊ being the velocities before and after.
    fn work(&self, _: &L, _: &Stride<R>, _: &Self::Memory, after: &Self::Memory) -> R {
        after.work()
    }
}
