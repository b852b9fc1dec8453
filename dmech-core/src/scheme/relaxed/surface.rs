//! The way back onto the energy surface.

use dmech_scalar::{Mask, Real};

use crate::newton::NotConverged;
use crate::system::{Kick, System};

/// Corrections of one step, and the largest that is one.
const CORRECTIONS: u32 = 6;
const LARGEST: f64 = 1.0 / 16.0;
/// An energy that is off by no more than so many roundings stays so where next to nothing moves that could make it up.
const ROUNDINGS: f64 = 64.0;
/// A correction below the root of this many roundings leaves its square: less than one.
const SQUARE: f64 = 1.0 / 64.0;

/// Where steps are made and corrected.
pub struct RelaxedRoom<Y: System> {
    pub(super) kicks: Y::Room,
    /// Somebody asks for the work.
    pub(super) watched: bool,
    /// No velocity.
    still: Y::Vector,
    /// −h M⁻¹∇Φ, and v, of the bodies that count in the energy.
    fall: Y::Vector,
    speed: Y::Vector,
}

impl<Y: System> RelaxedRoom<Y> {
    pub(super) fn new(system: &Y) -> Self {
        let [still, fall, speed] = [(); 3].map(|()| system.zero());
        RelaxedRoom { kicks: system.room(), watched: true, still, fall, speed }
    }

    /// Moves position and velocity along (h² M⁻¹∇Φ, v) to where the energy is `level`. Returns the corrections made.
    #[inline(always)]
    pub(super) fn correct(
        &mut self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        level: Y::Scalar,
        [q, v]: [&mut Y::Vector; 2],
    ) -> Result<u32, NotConverged> {
        let RelaxedRoom { kicks, still, fall, speed, .. } = self;
        let mut share = Y::Scalar::ZERO;
        for made in 0..CORRECTIONS {
            let (potential, kinetic) = (system.potential(t, q), system.kinetic_energy(v));
            let excess = potential + kinetic - level;
            let rounding = Y::Scalar::EPSILON * (potential.abs() + kinetic);
            if excess.abs().less_or_equal(rounding).all() {
                return Ok(made);
            }
            system.kick(kicks, stride, Kick { t, b: Y::Scalar::ONE, e: 0.0 }, q, still, fall);
            system.leave_uncounted(fall);
            speed.clone_from(v);
            system.leave_uncounted(speed);
            // Along the way the energy rises by h² ∇Φ M⁻¹ ∇Φ + v M v.
            share = excess / (Y::Scalar::from_f64(-2.0) * (system.kinetic_energy(fall) + kinetic));
            if !share.abs().less_or_equal(Y::Scalar::from_f64(LARGEST)).all() {
                let at_rest = excess.abs().less_or_equal(Y::Scalar::from_f64(ROUNDINGS) * rounding).all();
                let told = !at_rest && Y::is_finite(q) && Y::is_finite(v);
                return if told { Err(astray(made + 1, share)) } else { Ok(made) };
            }
            Y::add_scaled(q, -share * Y::dt(stride), fall);
            Y::add_scaled(v, share, speed);
            if (share * share).less_or_equal(Y::Scalar::from_f64(SQUARE) * Y::Scalar::EPSILON).all() {
                return Ok(made + 1);
            }
        }
        Err(astray(CORRECTIONS, share))
    }
}

#[cold]
fn astray<R: Real>(made: u32, share: R) -> NotConverged {
    NotConverged { iterations: made.into(), residual: share.to_f64().abs() }
}

impl<Y: System> Clone for RelaxedRoom<Y> {
    fn clone(&self) -> Self {
        RelaxedRoom {
            kicks: self.kicks.clone(),
            watched: self.watched,
            still: self.still.clone(),
            fall: self.fall.clone(),
            speed: self.speed.clone(),
        }
    }
}

impl<Y: System> core::fmt::Debug for RelaxedRoom<Y> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("RelaxedRoom").field("kicks", &self.kicks).field("watched", &self.watched).finish()
    }
}
