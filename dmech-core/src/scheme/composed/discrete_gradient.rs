//! Energy-exact stages.

use core::array::from_fn;

use dmech_scalar::{CompensatedVector, Real};

use super::predictor::{Place, Resample, expected, weights};
use super::{Coefficients, Composed};
use crate::State;
use crate::law::{Field, Law};
use crate::newton::NotConverged;
use crate::scheme::discrete_gradient::advance;
use crate::scheme::{DiscreteGradient, Effort, Scheme, Stride};
use crate::vector::{finite, weighted};

/// What a composition of [`DiscreteGradient`](struct@DiscreteGradient) carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComposedDiscreteGradientMemory<const D: usize, const N: usize, R = f64> {
    /// Position.
    pub q: CompensatedVector<D, R>,
    /// Velocity.
    pub v: CompensatedVector<D, R>,
    /// ∇̄Φ less the mean force in the stages of the last step; ∇Φ − F before the first step.
    gradients: [[R; D]; N],
    /// γ_k h and what follows from it.
    strides: [Stride<R>; N],
    /// Work of the last step.
    work: R,
}

#[cfg(feature = "serde")]
impl<const D: usize, const N: usize> crate::checkpoint::Carried for ComposedDiscreteGradientMemory<D, N> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        let gradients = self.gradients.as_flattened_mut();
        vec![&mut self.q.hi, &mut self.q.lo, &mut self.v.hi, &mut self.v.lo, gradients]
    }
}

impl<C: Coefficients<N>, const N: usize> Composed<DiscreteGradient, C, N> {
    pub(crate) const WEIGHTS: [[f64; N]; N] = weights(C::GAMMA, Place::Middle);
    const RESAMPLE: Resample<N> = Resample::new(C::GAMMA, Place::Middle);
}

impl<L, C, const N: usize, const D: usize, R: Real> Scheme<L, D, R> for Composed<DiscreteGradient, C, N>
where
    L: Law<D, R>,
    C: Coefficients<N>,
{
    type Memory = ComposedDiscreteGradientMemory<D, N, R>;

    fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
        let State { t, q, v } = *start;
        let gradient = law.field(stride.mass, R::from_f64(t)).slope(q, v);
        Ok(ComposedDiscreteGradientMemory {
            q: CompensatedVector::new(q),
            v: CompensatedVector::new(v),
            gradients: [gradient; N],
            strides: from_fn(|k| stride.times(Self::gamma(k))),
            work: R::ZERO,
        })
    }

    #[inline(always)]
    fn step(&self, law: &L, stride: &Stride<R>, t: R, memory: &mut Self::Memory) -> Result<Effort, NotConverged> {
        let ComposedDiscreteGradientMemory { mut q, mut v, mut gradients, ref strides, .. } = *memory;
        let mut effort = Effort::default();
        let mut work = R::ZERO;
        for k in 0..N {
            let now = R::from_f64(Self::begins(k)).mul_add(stride.dt, t);
            let next = expected(&Self::WEIGHTS[k], &gradients);
            let found = advance(law, &strides[k], now, &mut q, &mut v, next, &self.scheme.newton)?;
            gradients[k] = found.gradient;
            work -= weighted(law.mass_ratios(), found.gradient, found.delta);
            effort.evaluations += found.evaluations;
            effort.iterations += found.iterations;
        }
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
        memory.q.value()
    }

    #[inline]
    fn velocity(&self, _: &L, _: &Stride<R>, _: R, memory: &Self::Memory) -> [R; D] {
        memory.v.value()
    }

    #[inline]
    fn finite(&self, memory: &Self::Memory) -> bool {
        finite(memory.q.hi) && finite(memory.v.hi)
    }

    fn kinetic_energy(&self, law: &L, stride: &Stride<R>, memory: &Self::Memory) -> R {
        stride.kinetic_energy(law.mass_ratios(), memory.v.value())
    }

    /// Σ (−∇̄Φ + (F + F′)/2)·Δq over the stages.
    fn work(&self, _: &L, _: &Stride<R>, _: &Self::Memory, after: &Self::Memory) -> R {
        after.work
    }
}
