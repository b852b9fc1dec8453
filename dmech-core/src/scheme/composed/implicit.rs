//! Stages of the trapezoidal rule.

use core::array::from_fn;

use dmech_scalar::Real;

use super::predictor::{Place, Resample, expected, weights};
use super::{Coefficients, Composed};
use crate::State;
use crate::law::{Field, Law};
use crate::newton::NotConverged;
use crate::scheme::implicit::advance;
use crate::scheme::{Effort, Implicit, Scheme, Stride};
use crate::vector::{finite, sum, weighted};

/// What a composition of [`Implicit`](struct@Implicit) carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComposedImplicitMemory<const D: usize, const N: usize, R = f64> {
    /// Position.
    pub q: [R; D],
    /// Velocity.
    pub v: [R; D],
    /// ∇Φ − F at the ends of the stages of the last step.
    gradients: [[R; D]; N],
    /// γ_k h and what follows from it.
    strides: [Stride<R>; N],
    /// Work of the last step.
    work: R,
}

#[cfg(feature = "serde")]
impl<const D: usize, const N: usize> crate::checkpoint::Carried for ComposedImplicitMemory<D, N> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![&mut self.q, &mut self.v, self.gradients.as_flattened_mut()]
    }
}

impl<C: Coefficients<N>, const N: usize> Composed<Implicit, C, N> {
    const WEIGHTS: [[f64; N]; N] = weights(C::GAMMA, Place::End);
    const RESAMPLE: Resample<N> = Resample::new(C::GAMMA, Place::End);
}

impl<L, C, const N: usize, const D: usize, R: Real> Scheme<L, D, R> for Composed<Implicit, C, N>
where
    L: Law<D, R>,
    C: Coefficients<N>,
{
    type Memory = ComposedImplicitMemory<D, N, R>;

    fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
        let State { t, q, v } = *start;
        let gradient = law.field(stride.mass, R::from_f64(t)).slope(q, v);
        let strides = from_fn(|k| stride.times(Self::gamma(k)));
        Ok(ComposedImplicitMemory { q, v, gradients: [gradient; N], strides, work: R::ZERO })
    }

    #[inline(always)]
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged> {
        let ComposedImplicitMemory { mut q, mut v, mut gradients, ref strides, .. } = *memory;
        let mut gradient = gradients[N - 1];
        let mut effort = Effort::default();
        let mut work = R::ZERO;
        for k in 0..N {
            let end = R::from_f64(Self::ENDS[k]).mul_add(stride.dt, t);
            let next = expected(&Self::WEIGHTS[k], &gradients);
            let found = advance(law, &strides[k], end, (&mut q, &mut v), gradient, next, &self.scheme.newton)?;
            work -= weighted(law.mass_ratios(), sum(gradient, found.gradient), found.delta);
            gradient = found.gradient;
            gradients[k] = gradient;
            effort.evaluations += found.evaluations;
            effort.iterations += found.iterations;
        }
        work *= R::from_f64(0.5);
        (memory.q, memory.v, memory.gradients, memory.work) = (q, v, gradients, work);
        Ok(effort)
    }

    #[inline]
    fn stretch(&self, _: &L, stride: &Stride<R>, _: R, ratio: R, memory: &mut Self::Memory) -> u32 {
        Self::RESAMPLE.apply(ratio, &mut memory.gradients);
        Scheme::<L, D, R>::restore(self, stride, memory);
        0
    }

    #[inline]
    fn restore(&self, stride: &Stride<R>, memory: &mut Self::Memory) {
        memory.strides = from_fn(|k| stride.times(Self::gamma(k)));
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

    /// Σ (F + F′)/2·Δq over the stages.
    fn work(&self, _: &L, _: &Stride<R>, _: &Self::Memory, after: &Self::Memory) -> R {
        after.work
    }
}
