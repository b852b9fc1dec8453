//! A step of eight stages.

use dmech_scalar::{Count, Mask, Real};

use super::ended::Ended;
use super::parts::otherwise;
use super::sweeps::{Stalled, Sweeps, With, apart, whole, whole_in_registers};
use super::{Gauss, LineIntegral};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::scheme::by_lane::by_lane;
use crate::scheme::memory::{memory, q_and_v};
use crate::scheme::{Effort, Method, Reached, Scheme};
use crate::system::Tableau;
use crate::system::{Beginning, Staged};

memory! {
    /// What [`Gauss`] and [`LineIntegral`] carry.
    pub struct GaussMemory<Y: Staged with Pushes, Scalar> {
        /// Position.
        pub q: Y::Sum,
        /// Velocity.
        pub v: Y::Sum,
        /// Pushes of the last step, from which those of the next are guessed.
        pub pushes: Y::Pushes,
        /// The next step in units of the last; 0 where the pushes are a guess already.
        ratio: Y::Scalar,
        /// Steps that were no smooth motion, or too long: see [`Report::rough`](crate::Report::rough).
        rough: Y::Scalar,
    }
    lists {}
    uncarried {
        /// The length of the last step.
        dt: Y::Scalar,
        /// The work of a step that was made in parts.
        in_parts: Option<Y::Scalar>,
    }
}

by_lane! { GaussMemory of Staged with Pushes { q, v, pushes, ratio, rough, dt } afresh { in_parts }; }

/// Bytes of pushes that stay in registers through a step, those of one coordinate. Of more, copies would be made in memory: steps of two
/// coordinates took 3 % more time, of three and of six 10 %; in place those of one take 2 to 24 %.
const FEW: usize = 64;

/// A method with eight stages.
pub(crate) trait Stages: Method {
    /// Its coefficients.
    const TABLEAU: &'static Tableau;
}

impl<Y: Staged> GaussMemory<Y> {
    fn begin(system: &Y, stride: &Y::Stride, start: &Beginning<'_, Y>) -> Self {
        let (q, v, pushes) = (Y::sum(start.q), Y::sum(start.v), system.pushes(stride, start.slope));
        let none = Y::Scalar::ZERO;
        GaussMemory { q, v, pushes, ratio: none, rough: none, dt: Y::dt(stride), in_parts: None }
    }

    #[inline(always)]
    fn step(
        &mut self,
        with: With<'_, Y>,
        stride: &Y::Stride,
        t: Y::Scalar,
        sweeps: &mut Sweeps<Y>,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let GaussMemory { q, v, pushes, ratio, rough, dt, in_parts: parts } = self;
        let (at, zero, one) = ((t, *ratio), Y::Scalar::ZERO, Y::Scalar::ONE);
        (*ratio, *dt, *parts, sweeps.made) = (one, Y::dt(stride), None, 0);
        let made = if Y::IN_REGISTERS && size_of::<Y::Pushes>() <= FEW && !Ended::<Y>::MANY {
            whole_in_registers(with, stride, at, [q, v], pushes, sweeps)
        } else {
            whole(with, stride, at, [q, v], pushes, sweeps)
        };
        match made {
            Ok(bent) => {
                if bent.any() {
                    *rough += Y::Scalar::either(bent, one, zero);
                }
            }
            Err(Stalled(residual)) if Ended::<Y>::MANY => {
                return Err(sweeps.gave_up(residual));
            }
            Err(_) => {
                *ratio = zero;
                let made = otherwise(with, stride, t, [q, v], pushes, sweeps, 1);
                let made = made.map_err(|Stalled(residual)| sweeps.gave_up(residual))?;
                *parts = Some(made.work);
                *rough += if made.rough { one } else { zero };
            }
        }
        let evaluations = if Ended::<Y>::MANY { sweeps.of_each } else { Count::of(8 * sweeps.made) };
        Ok(Effort { evaluations, iterations: Count::of(0) })
    }

    /// As the first step from there.
    fn within(
        with @ (system, _): With<'_, Y>,
        dt: Y::Scalar,
        from: &Beginning<'_, Y>,
    ) -> Result<Reached<Y>, NotConverged> {
        let (t, mut sweeps, stride) = (from.t, Sweeps::new(system), system.stride(dt, 0.0));
        let GaussMemory { mut q, mut v, mut pushes, ratio, .. } = GaussMemory::begin(system, &stride, from);
        let made = apart(with, &stride, (t, ratio), [&mut q, &mut v], &mut pushes, &mut sweeps);
        if made.is_err() {
            let made = otherwise(with, &stride, t, [&mut q, &mut v], &mut pushes, &mut sweeps, 1);
            made.map_err(|Stalled(residual)| sweeps.gave_up(residual))?;
        }
        let effort = Effort { evaluations: Count::of(8 * sweeps.made), iterations: Count::of(0) };
        Ok(([Y::value(&q).clone(), Y::value(&v).clone()], effort))
    }
}

macro_rules! stepped_by_stages {
    ($($scheme:ty, <$(const $s:ident: usize)?>;)*) => {$(
        impl<$(const $s: usize,)? Y: Staged> Scheme<Y> for $scheme {
            const SEES_ROUGH: bool = true;

            type Memory = GaussMemory<Y>;
            type Workspace = Sweeps<Y>;

            fn workspace(&self, system: &Y, _: &Y::Stride) -> Sweeps<Y> {
                Sweeps::new(system)
            }

            #[inline(always)]
            fn watch(&self, watched: bool, sweeps: &mut Sweeps<Y>) {
                sweeps.watched = watched;
            }

            fn begin(
                &self,
                system: &Y,
                stride: &Y::Stride,
                start: &Beginning<'_, Y>,
                _: &mut Sweeps<Y>,
            ) -> Result<Self::Memory, NotConverged> {
                Ok(GaussMemory::begin(system, stride, start))
            }

            #[inline(always)]
            fn step(
                &self,
                system: &Y,
                stride: &Y::Stride,
                t: Y::Scalar,
                memory: &mut Self::Memory,
                sweeps: &mut Sweeps<Y>,
            ) -> Result<Effort<Y::Scalar>, NotConverged> {
                memory.step((system, Self::TABLEAU), stride, t, sweeps)
            }

            /// As the first step from there.
            fn within(&self, system: &Y, dt: Y::Scalar, from: &Beginning<'_, Y>) -> Result<Reached<Y>, NotConverged> {
                GaussMemory::within((system, Self::TABLEAU), dt, from)
            }

            #[inline(always)]
            fn stretch(
                &self,
                _: &Y,
                _: &Y::Stride,
                _: Y::Scalar,
                ratio: Y::Scalar,
                memory: &mut Self::Memory,
                _: &mut Sweeps<Y>,
            ) -> u32 {
                memory.ratio *= ratio;
                0
            }

            q_and_v! { Y::value }

            /// Σ bᵢ h F(Qᵢ)·Ṽᵢ.
            fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
                let whole = || {
                    system.work_of_pushes(Self::TABLEAU, after.dt, Y::value(&before.v), &after.pushes)
                };
                after.in_parts.unwrap_or_else(whole)
            }

            fn rough(&self, memory: &Self::Memory) -> u64 {
                memory.rough.to_f64() as u64
            }

            fn tell_on(&self, so_far: &Self::Memory, memory: &mut Self::Memory) {
                memory.rough = so_far.rough;
            }

            fn kept(_: &Y, invariant: Invariant) -> Kept {
                Self::kept_by(Y::DEGREE, invariant)
            }
        }
    )*};
}

stepped_by_stages! {
    Gauss, <>;
    LineIntegral<S>, <const S: usize>;
}
