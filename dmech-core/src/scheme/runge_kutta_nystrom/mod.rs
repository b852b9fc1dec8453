//! An explicit Runge–Kutta–Nyström step of order 12.

mod coefficients;

use dmech_scalar::Real;

use self::coefficients::{COUNTED, KICKS, MOVES, PLACES, STAGES, TIMES};
use super::by_lane::by_lane;
use super::memory::{memory, q_and_v};
use super::splitting::digits;
use super::{Effort, Method, Scheme, WithoutVelocities};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::system::{Beginning, Kick, System};

/// Dormand, El-Mikkawy and Prince's explicit method of order 12 for q″ = a(q, t): the fewest forces to twelve digits, and nothing kept.
///
/// ```text
/// aᵢ = a(q + cᵢ h v + h² Σ_{j<i} aᵢⱼ aⱼ, t + cᵢ h),   q′ = q + h v + h² Σ bᵢ aᵢ,   v′ = v + h Σ b′ᵢ aᵢ
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 12 | its error, O(h¹²), grows with time | the same | no | no | 17 forces |
///
/// For motions of some hundred revolutions at most whose position is wanted to many digits. At errors of 10⁻⁹ to 10⁻¹² it asks for 0.4 to
/// 0.8 of the forces of [`Gauss`](crate::Gauss), and members of an [ensemble](crate::Ensemble) take about half the time; one
/// motion alone, or a few bodies, have eight forces of `Gauss` side by side, and are as fast or faster with that. Of the explicit
/// schemes it is the fastest from 10⁻⁶ on. For longer runs take one that keeps what the motion keeps. Linear momentum is
/// kept, and sums are compensated.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3])).scheme(RungeKuttaNystrom::order12());
/// let [coarse, fine] = [0.4, 0.2].map(|dt| quartic.clone().dt(dt).run_until(20.0).map(|run| run.last().q[0]));
/// assert!((coarse? - fine?).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Work is Σ m (v′ − v)·(v′ + v)/2, that of the mean force.
///
/// # Requires
/// Forces that do not depend on the velocity. The potential may depend on the time.
/// # Reference
/// J. R. Dormand, M. E. A. El-Mikkawy and P. J. Prince, IMA J. Numer. Anal. 7 (1987) 423–430: RKN12(10)17M. Its second result, of order 10,
/// is not formed: steps follow the motion by [`Simulation::adaptive`](crate::Simulation::adaptive).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RungeKuttaNystrom {
    _made_by_order: (),
}

impl RungeKuttaNystrom {
    /// Seventeen stages.
    pub const fn order12() -> Self {
        RungeKuttaNystrom { _made_by_order: () }
    }
}

memory! {
    /// What [`RungeKuttaNystrom`] carries.
    pub struct RungeKuttaNystromMemory<Y> {
        /// Position.
        pub q: Y::Sum,
        /// Velocity.
        pub v: Y::Sum,
    }
    lists {}
    uncarried {}
}

by_lane! { RungeKuttaNystromMemory { q, v }; }

/// Where steps are made.
#[derive(Clone, Debug)]
pub struct RungeKuttaNystromRoom<R, V> {
    room: R,
    /// No velocity.
    still: V,
    /// Where a stage is.
    place: V,
    /// Weighed accelerations.
    weighed: V,
    /// h aᵢ.
    gains: [V; STAGES],
}

/// The same for a system.
pub type RungeKuttaNystromStages<Y> = RungeKuttaNystromRoom<<Y as System>::Room, <Y as System>::Vector>;

/// out ← Σ wⱼ xⱼ, with what rounding to `f64` leaves out of the weights where the scalar has more digits.
#[inline(always)]
fn weigh<Y: System>([weights, low]: [&[f64]; 2], x: &[Y::Vector], out: &mut Y::Vector) {
    Y::weigh(weights, x, out);
    if Y::Scalar::EPSILON.to_f64() < f64::EPSILON {
        low.iter().zip(x).for_each(|(&low, x)| Y::add_scaled(out, Y::Scalar::from_f64(low), x));
    }
}

impl Method for RungeKuttaNystrom {
    const NAME: &'static str = "RungeKuttaNystrom(12)";
    const ORDER: u32 = 12;
    const SYMMETRIC: bool = false;

    fn keeps(invariant: Invariant) -> Kept {
        match invariant {
            Invariant::WorkEnergy | Invariant::LinearMomentum => Kept::Exact,
            Invariant::Energy | Invariant::AngularMomentum | Invariant::DiscreteEnergy => Kept::No,
        }
    }
}

impl<Y: System + WithoutVelocities> Scheme<Y> for RungeKuttaNystrom {
    const ALIKE: bool = true;
    const STRETCHES: bool = false;

    type Memory = RungeKuttaNystromMemory<Y>;
    type Workspace = RungeKuttaNystromStages<Y>;

    fn workspace(&self, system: &Y, _: &Y::Stride) -> Self::Workspace {
        let zero = || system.zero();
        let gains = core::array::from_fn(|_| zero());
        RungeKuttaNystromRoom { room: system.room(), still: zero(), place: zero(), weighed: zero(), gains }
    }

    fn begin(
        &self,
        _: &Y,
        _: &Y::Stride,
        start: &Beginning<'_, Y>,
        _: &mut Self::Workspace,
    ) -> Result<Self::Memory, NotConverged> {
        Ok(RungeKuttaNystromMemory { q: Y::sum(start.q), v: Y::sum(start.v) })
    }

    #[inline(always)]
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        memory: &mut Self::Memory,
        RungeKuttaNystromRoom { room, still, place, weighed, gains }: &mut Self::Workspace,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let h = Y::dt(stride);
        let RungeKuttaNystromMemory { q, v } = memory;
        for i in 0..STAGES {
            weigh::<Y>(PLACES[i], &gains[..i], weighed);
            let time = digits(TIMES[0][i], TIMES[1][i]);
            Y::add_scaled(weighed, time, Y::value(v));
            place.clone_from(Y::value(q));
            Y::add_scaled(place, h, weighed);
            let kick = Kick { t: time.mul_add(h, t), b: Y::Scalar::ONE, e: 0.0 };
            system.kick(room, stride, kick, place, still, &mut gains[i]);
        }
        // Stages 1 to 5 have no weight in the end.
        let at_the_end = |of: &[[f64; STAGES]; 2], weighed: &mut Y::Vector| {
            weigh::<Y>([&of[0][COUNTED], &of[1][COUNTED]], &gains[COUNTED], weighed);
            Y::add_scaled(weighed, digits(of[0][0], of[1][0]), &gains[0]);
        };
        Y::drift_sum(stride, q, v);
        at_the_end(&MOVES, weighed);
        Y::add_to_sum(q, h, weighed);
        at_the_end(&KICKS, weighed);
        Y::add_to_sum(v, Y::Scalar::ONE, weighed);
        Ok(Effort::of(STAGES as u32))
    }

    q_and_v! { Y::value }

    /// Σ m (v′ − v)·(v′ + v)/2.
    fn work(&self, system: &Y, _: &Y::Stride, before: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
        system.work_of_kick(Y::value(&before.v), Y::value(&after.v))
    }
}
