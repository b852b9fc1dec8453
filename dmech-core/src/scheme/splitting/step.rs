//! A step of drifts and kicks.

use dmech_scalar::Real;

use super::{First, Splitting};
use crate::law::{Field, Law};
use crate::scheme::Stride;
use crate::vector::{add_scaled, difference, finite, scaled, sum, weighted};

/// What a scheme of drifts and kicks carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplittingMemory<const D: usize, R = f64> {
    /// Position.
    pub q: [R; D],
    /// Velocity before the kick that belongs half to the step that ends; the velocity now where a step ends with a drift.
    pub v_before: [R; D],
    /// Velocity after it.
    pub v_after: [R; D],
    /// Work of the last step.
    work: R,
}

#[cfg(feature = "serde")]
impl<const D: usize> crate::checkpoint::Carried for SplittingMemory<D> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        vec![&mut self.q, &mut self.v_before, &mut self.v_after]
    }
}

impl<const D: usize, R: Real> SplittingMemory<D, R> {
    /// From a state at time t.
    pub(crate) fn new<S, L, const N: usize>(law: &L, stride: &Stride<R>, (t, q, v): (R, [R; D], [R; D])) -> Self
    where
        S: Splitting<N>,
        L: Law<D, R>,
    {
        if matches!(S::FIRST, First::Drift) {
            return SplittingMemory { q, v_before: v, v_after: v, work: R::ZERO };
        }
        let field = law.field(stride.mass, t);
        let kicked = |sign: f64| kick(&field, stride, sign * S::KICKS[0], sign * S::GRADIENTS[0], q, v);
        SplittingMemory { q, v_before: kicked(-1.0), v_after: kicked(1.0), work: R::ZERO }
    }

    /// One step from time t.
    #[inline(always)]
    pub(crate) fn advance<S, L, const N: usize>(&mut self, law: &L, stride: &Stride<R>, t: R)
    where
        S: Splitting<N>,
        L: Law<D, R>,
    {
        let SplittingMemory { mut q, mut v_before, mut v_after, .. } = *self;
        let mut work = R::ZERO;
        // A kick does the work F·(mean velocity) in its time.
        let of_kick = |before, after| weighted(law.mass_ratios(), difference(after, before), sum(after, before));
        for k in 0..N {
            // Of the kick before this drift; before the first drift of a step that begins with one both are the same.
            work += of_kick(v_before, v_after);
            q = add_scaled(q, R::from_f64(S::DRIFTS[k]) * stride.dt, v_after);
            let now = R::from_f64(S::ENDS[k]).mul_add(stride.dt, t);
            v_before = v_after;
            let field = law.field(stride.mass, now);
            v_after = kick(&field, stride, S::JOINED[k], S::JOINED_GRADIENTS[k], q, v_before);
        }
        if matches!(S::FIRST, First::Drift) {
            work += of_kick(v_before, v_after);
            q = add_scaled(q, R::from_f64(S::DRIFTS[0]) * stride.dt, v_after);
            v_before = v_after;
        }
        work *= R::from_f64(0.5) * stride.mass;
        *self = SplittingMemory { q, v_before, v_after, work };
    }

    /// The mean of the velocities around the last kick: half of it belongs to the step that ends.
    #[inline]
    pub(crate) fn velocity(&self) -> [R; D] {
        scaled(R::from_f64(0.5), sum(self.v_before, self.v_after))
    }

    #[inline]
    pub(crate) fn finite(&self) -> bool {
        finite(self.q) && finite(self.v_after)
    }

    pub(crate) fn work(&self) -> R {
        self.work
    }
}

/// v + b h a + e h³ a′a, at one position.
#[inline(always)]
fn kick<F: Field<D, R>, const D: usize, R: Real>(
    field: &F,
    stride: &Stride<R>,
    b: f64,
    e: f64,
    q: [R; D],
    v: [R; D],
) -> [R; D] {
    let c = R::from_f64(b) * stride.kick;
    if e == 0.0 {
        return field.kick(c, q, v);
    }
    field.gradient_kick(c, R::from_f64(e) * stride.dt * stride.kick * stride.kick, q, v)
}

/// `Scheme` for a scheme of drifts and kicks.
macro_rules! splitting_scheme {
    ($scheme:ident, $coefficients:ident) => {
        impl<L, C, const N: usize, const D: usize, R: Real> Scheme<L, D, R> for $scheme<C, N>
        where
            L: Law<D, R> + VelocityIndependent,
            C: $coefficients<N>,
        {
            type Memory = SplittingMemory<D, R>;

            fn begin(&self, law: &L, stride: &Stride<R>, start: &State<D, R>) -> Result<Self::Memory, NotConverged> {
                let State { t, q, v } = *start;
                Ok(SplittingMemory::new::<Self, L, N>(law, stride, (R::from_f64(t), q, v)))
            }

            #[inline(always)]
            fn step(
                &self,
                law: &L,
                stride: &Stride<R>,
                t: R,
                memory: &mut Self::Memory,
            ) -> Result<Effort, NotConverged> {
                memory.advance::<Self, L, N>(law, stride, t);
                Ok(Effort { evaluations: N as u32, iterations: 0 })
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
    };
}
pub(crate) use splitting_scheme;
