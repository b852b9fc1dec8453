//! A step of drifts and kicks from one state to the next, and its correction.

use core::convert::identity;

use dmech_scalar::{Count, Real};

use super::{Relaxed, RelaxedRoom, corrects};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::scheme::coefficients::NystromCoefficients;
use crate::scheme::memory::{memory, q_and_v};
use crate::scheme::splitting::{First, Splitting, digits, drift, kick};
use crate::scheme::{Effort, Leapfrog, Method, Scheme, WithoutVelocities};
use crate::system::{Beginning, System};

memory! {
    /// What [`Relaxed`] carries.
    pub struct RelaxedMemory<Y> {
        /// Position.
        pub q: Y::Vector,
        /// Velocity.
        pub v: Y::Vector,
        /// The energy of the start, and what rounding to `f64` leaves out of it; 0 where none is kept.
        pub level: f64,
        pub(in crate::scheme) level_low: f64,
    }
    lists {}
    uncarried {
        /// Velocity before the last kick.
        before: Y::Vector,
        /// Work of the kicks of the last step, where nothing is corrected.
        work: Y::Work,
    }
}

impl<C: NystromCoefficients<N>, const N: usize, Y: System + WithoutVelocities> Scheme<Y> for Relaxed<C, N> {
    type Memory = RelaxedMemory<Y>;
    type Workspace = RelaxedRoom<Y>;

    fn workspace(&self, system: &Y, _: &Y::Stride) -> RelaxedRoom<Y> {
        RelaxedRoom::new(system)
    }

    #[inline(always)]
    fn watch(&self, watched: bool, room: &mut RelaxedRoom<Y>) {
        room.watched = watched;
    }

    fn begin(
        &self,
        system: &Y,
        _: &Y::Stride,
        start: &Beginning<'_, Y>,
        _: &mut RelaxedRoom<Y>,
    ) -> Result<Self::Memory, NotConverged> {
        const { assert!(matches!(<Self as Splitting<N>>::FIRST, First::Drift), "no kick is shared by two steps") };
        let level = if corrects(system) {
            system.potential(start.t, start.q) + system.kinetic_energy(start.v)
        } else {
            Y::Scalar::ZERO
        };
        let high = level.to_f64();
        Ok(RelaxedMemory {
            q: start.q.clone(),
            v: start.v.clone(),
            level: high,
            level_low: (level - Y::Scalar::from_f64(high)).to_f64(),
            before: start.v.clone(),
            work: system.no_work(),
        })
    }

    #[inline(always)]
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        memory: &mut Self::Memory,
        room: &mut RelaxedRoom<Y>,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let (h, exact) = (Y::dt(stride), corrects(system));
        let RelaxedMemory { q, v, level, level_low, before, work } = memory;
        Y::watch(room.watched && !exact, &mut room.kicks);
        Y::clear(work);
        Y::drift(q, drift::<Self, N, _>(0, h), v);
        for k in 0..N {
            core::mem::swap(before, v);
            let (kick, a) = (kick::<Self, N, _>(k, h, t), drift::<Self, N, _>((k + 1) % N, h));
            if exact && Y::IN_REGISTERS {
                system.kick(&mut room.kicks, stride, kick, q, before, v);
                Y::drift(q, a, v);
            } else {
                system.kick_and_drift::<false>(&mut room.kicks, stride, kick, a, q, before, v, work);
            }
        }
        let corrections =
            if exact { room.correct(system, stride, t + h, digits(*level, *level_low), [q, v])? } else { 0 };
        Ok(Effort { evaluations: Count::of(N as u32 + corrections), iterations: Count::of(corrections) })
    }

    q_and_v! { identity }

    /// Φ(q) − Φ(q′), or Σ F·h (v₋ + v₊)/2 over the kicks where nothing is corrected.
    fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
        if !corrects(system) {
            return system.total(&after.work);
        }
        // Nothing names the time where the energy is kept.
        system.potential(Y::Scalar::ZERO, &before.q) - system.potential(Y::Scalar::ZERO, &after.q)
    }

    /// Nothing is corrected where the energy is not kept.
    fn kept(system: &Y, invariant: Invariant) -> Kept {
        if corrects(system) { Self::keeps(invariant) } else { Leapfrog::keeps(invariant) }
    }
}
