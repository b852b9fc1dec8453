//! A step of drifts and kicks.

use dmech_scalar::Real;

use super::{First, Splitting, digits};
use crate::newton::NotConverged;
use crate::scheme::by_lane::by_lane;
use crate::scheme::coefficients::{ForceGradientCoefficients, NystromCoefficients};
use crate::scheme::memory::memory;
use crate::scheme::{
    Boris, Coefficients, Composed, Effort, ForceGradient, Leapfrog, LinearVelocities, Nystrom, Scheme,
    WithoutVelocities,
};
use crate::system::{Beginning, Kick, System};

memory! {
    /// What a scheme of drifts and kicks carries.
    pub struct SplittingMemory<Y> {
        /// Position.
        pub q: Y::Vector,
        /// Velocity before the kick that belongs half to the step that ends; the velocity now where a step ends with a drift.
        pub v_before: Y::Vector,
        /// Velocity after it.
        pub v_after: Y::Vector,
    }
    lists {}
    uncarried {
        /// Work of the kicks that belong wholly to the last step.
        work: Y::Work,
        /// Whether in it is by how much that of the shared kick has changed with the length of a step.
        begun: SharedKick,
    }
}

by_lane! { SplittingMemory { q, v_before, v_after } sums { work } all { begun }; }

/// Work of the kick that two steps of different lengths share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::scheme) enum SharedKick {
    /// There was none.
    No,
    /// Of the step to come.
    ToCome,
    /// Of the step that was made.
    Made,
}

/// The kick after drift k of a step that began at t.
#[inline(always)]
pub(in crate::scheme) fn kick<S: Splitting<N>, const N: usize, R: Real>(k: usize, h: R, t: R) -> Kick<R> {
    let t = R::from_f64(S::ENDS[k]).mul_add(h, t);
    Kick { t, b: digits(S::JOINED[k], S::JOINED_LOW[k]), e: S::JOINED_GRADIENTS[k] }
}

/// Half of the kick that two steps share.
#[inline(always)]
fn half_kick<S: Splitting<N>, const N: usize, R: Real>(t: R) -> Kick<R> {
    Kick { t, b: digits(S::KICKS[0], S::KICKS_LOW[0]), e: S::GRADIENTS[0] }
}

#[inline(always)]
pub(in crate::scheme) fn drift<S: Splitting<N>, const N: usize, R: Real>(k: usize, h: R) -> R {
    digits::<R>(S::DRIFTS[k], S::DRIFTS_LOW[k]) * h
}

/// Where a step is made, and how long it is.
type With<'a, Y> = (&'a Y, &'a mut <Y as System>::Room, &'a <Y as System>::Stride);

impl<Y: System> SplittingMemory<Y> {
    /// A step begins from a state, with half a kick to either side where two steps share one.
    fn begin<S: Splitting<N>, const N: usize>((system, room, stride): With<'_, Y>, start: &Beginning<'_, Y>) -> Self {
        let (q, work, begun) = (start.q.clone(), system.no_work(), SharedKick::No);
        if matches!(S::FIRST, First::Drift) {
            return SplittingMemory { q, v_before: start.v.clone(), v_after: start.v.clone(), work, begun };
        }
        let half = half_kick::<S, N, Y::Scalar>(start.t);
        let [v_before, v_after] = system.kick_both_ways(room, stride, half, start);
        SplittingMemory { q, v_before, v_after, work, begun }
    }

    /// A drift, then kicks with a drift after each, from t on; of two that share a kick the first makes it.
    #[inline(always)]
    fn step<S: Splitting<N>, const N: usize>(&mut self, (system, room, stride): With<'_, Y>, t: Y::Scalar) {
        let h = Y::dt(stride);
        let (work, begun) = (&mut self.work, self.begun);
        self.begun = if begun == SharedKick::ToCome && !Y::IN_REGISTERS { SharedKick::Made } else { SharedKick::No };
        // Leap-frog has no kick within a step: many bodies are spared the clearing of nothing.
        let any = N > 1 || matches!(S::FIRST, First::Drift) || Y::IN_REGISTERS;
        if begun != SharedKick::ToCome && (any || begun == SharedKick::Made) {
            Y::clear(work);
        }
        Y::drift(&mut self.q, drift::<S, N, _>(0, h), &self.v_after);
        for k in 1..N {
            self.kick_and_drift::<S, N>((system, room, stride), kick::<S, N, _>(k - 1, h, t), drift::<S, N, _>(k, h));
        }
        let last = kick::<S, N, _>(N - 1, h, t);
        if matches!(S::FIRST, First::Drift) {
            self.kick_and_drift::<S, N>((system, room, stride), last, drift::<S, N, _>(0, h));
            self.v_before.clone_from(&self.v_after);
        } else {
            // Its work belongs to the step to come.
            let SplittingMemory { q, v_before, v_after, .. } = self;
            core::mem::swap(v_before, v_after);
            system.kick(room, stride, last, q, v_before, v_after);
        }
    }

    /// Of the kick that two steps share, the second half is that of the longer or shorter step to come: how many kicks that takes.
    #[inline(always)]
    fn stretch<S: Splitting<N>, const N: usize>(&mut self, (system, room, stride): With<'_, Y>, t: Y::Scalar) -> u32 {
        if matches!(S::FIRST, First::Drift) {
            return 0;
        }
        let v = self.velocity();
        let SplittingMemory { q, v_before, v_after, work, begun } = self;
        Y::clear(work);
        system.add_work(work, v_after, v_before);
        system.kick(room, stride, half_kick::<S, N, _>(t), q, &v, v_after);
        system.add_work(work, v_before, v_after);
        *begun = SharedKick::ToCome;
        1
    }

    /// The kick, then a drift in the time a, and the work of the kick.
    #[inline(always)]
    fn kick_and_drift<S: Splitting<N>, const N: usize>(
        &mut self,
        (system, room, stride): With<'_, Y>,
        kick: Kick<Y::Scalar>,
        a: Y::Scalar,
    ) {
        let SplittingMemory { q, v_before, v_after, work, .. } = self;
        core::mem::swap(v_before, v_after);
        if S::BY_MEAN {
            system.kick_and_drift::<true>(room, stride, kick, a, q, v_before, v_after, work);
        } else {
            system.kick_and_drift::<false>(room, stride, kick, a, q, v_before, v_after, work);
        }
    }

    /// The mean of the velocities around the last kick: half of it belongs to the step that ends.
    #[inline]
    fn velocity(&self) -> Y::Vector {
        Y::mean(&self.v_before, &self.v_after)
    }
}

/// The schemes that step so: what the forces must be like, and the parameters of the scheme.
macro_rules! stepped_by_drifts_and_kicks {
    ($($scheme:ty, $n:tt, $forces:ident, <$($coefficients:ident: $bound:path, const $m:ident: usize)?>;)*) => {$(
        impl<$($coefficients: $bound, const $m: usize,)? Y: System + $forces> Scheme<Y> for $scheme {
            const STRETCHES: bool = !matches!(Self::FIRST, First::Drift);
            const ALIKE: bool = true;

            type Memory = SplittingMemory<Y>;
            type Workspace = Y::Room;

            fn workspace(&self, system: &Y, _: &Y::Stride) -> Y::Room {
                system.room()
            }

            #[inline(always)]
            fn watch(&self, watched: bool, room: &mut Y::Room) {
                Y::watch(watched, room);
            }

            fn begin(
                &self,
                system: &Y,
                stride: &Y::Stride,
                start: &Beginning<'_, Y>,
                room: &mut Y::Room,
            ) -> Result<Self::Memory, NotConverged> {
                Ok(SplittingMemory::begin::<Self, { $n }>((system, room, stride), start))
            }

            #[inline(always)]
            fn step(
                &self,
                system: &Y,
                stride: &Y::Stride,
                t: Y::Scalar,
                memory: &mut Self::Memory,
                room: &mut Y::Room,
            ) -> Result<Effort<Y::Scalar>, NotConverged> {
                memory.step::<Self, { $n }>((system, room, stride), t);
                Ok(Effort::of($n as u32))
            }

            #[inline(always)]
            fn stretch(
                &self,
                system: &Y,
                stride: &Y::Stride,
                t: Y::Scalar,
                _: Y::Scalar,
                memory: &mut Self::Memory,
                room: &mut Y::Room,
            ) -> u32 {
                memory.stretch::<Self, { $n }>((system, room, stride), t)
            }

            #[inline]
            fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Y::Vector {
                &memory.q
            }

            #[inline]
            fn velocity(&self, _: &Y, _: &Y::Stride, _: Y::Scalar, memory: &Self::Memory) -> Y::Vector {
                memory.velocity()
            }

            #[inline]
            fn finite(&self, memory: &Self::Memory) -> bool {
                Y::is_finite(&memory.q) && Y::is_finite(&memory.v_after)
            }

            /// Σ m v²/2 before the kick that belongs half to the step to come.
            fn kinetic_energy(&self, system: &Y, memory: &Self::Memory) -> Y::Scalar {
                system.kinetic_energy(&memory.v_before)
            }

            /// Σ F·h (v₋ + v₊)/2 over the kicks, v₋ and v₊ being the velocities before and after; for leap-frog
            /// F_k·(q_{k+1} − q_{k−1})/2.
            fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
                let mut shared = system.no_work();
                if matches!(Self::FIRST, First::Kick) {
                    system.add_work(&mut shared, &before.v_before, &before.v_after);
                }
                system.total(&shared) + system.total(&after.work)
            }
        }
    )*};
}

stepped_by_drifts_and_kicks! {
    Leapfrog, 1, WithoutVelocities, <>;
    Composed<Leapfrog, C, N>, N, WithoutVelocities, <C: Coefficients<N>, const N: usize>;
    Boris, 1, LinearVelocities, <>;
    Composed<Boris, C, N>, N, LinearVelocities, <C: Coefficients<N>, const N: usize>;
    Nystrom<C, N>, N, WithoutVelocities, <C: NystromCoefficients<N>, const N: usize>;
    ForceGradient<C, N>, N, WithoutVelocities, <C: ForceGradientCoefficients<N>, const N: usize>;
}
