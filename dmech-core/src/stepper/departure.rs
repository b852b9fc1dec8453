//! Where a step begins.

use dmech_scalar::Real;

use crate::error::Error;
use crate::newton::NotConverged;
use crate::scheme::Reached;
use crate::system::{Beginning, Effort, System};

/// Where a step begins: position, velocity, and the slope there.
pub(super) struct Departure<Y: System> {
    q: Y::Vector,
    v: Y::Vector,
    slope: Y::Vector,
    t: f64,
}

impl<Y: System> Departure<Y> {
    /// From which a motion starts.
    pub(super) fn prepared(system: &Y, start: &Y::State) -> Result<Self, Error> {
        let mut slope = system.zero();
        system.prepare(start, &mut slope)?;
        let [q, v] = system.vectors(start);
        Ok(Departure { q, v, slope, t: Y::time(start) })
    }

    /// Through which it comes.
    pub(super) fn passed(system: &Y, state: &Y::State) -> Self {
        let ([q, v], mut slope, t) = (system.vectors(state), system.zero(), Y::time(state));
        system.slope(Y::Scalar::from_f64(t), &q, &v, &mut slope);
        Departure { q, v, slope, t }
    }

    pub(super) fn beginning(&self) -> Beginning<'_, Y> {
        Beginning { t: Y::Scalar::from_f64(self.t), q: &self.q, v: &self.v, slope: &self.slope }
    }

    /// The state at a time that a step from here has led to, and what it has cost with the slope.
    pub(super) fn reached(
        &self,
        system: &Y,
        step: u64,
        t: f64,
        ([q, v], mut effort): Reached<Y>,
    ) -> Result<(Y::State, Effort<Y::Scalar>), Error> {
        if !Y::is_finite(&q) || !Y::is_finite(&v) || !system.is_placed(t) {
            return Err(system.not_finite(step, [&q, &v], self.t, t - self.t));
        }
        effort += Effort::of(1);
        Ok((system.state(t, &q, &v), effort))
    }

    /// Why a step of some length from here has not been solved.
    pub(super) fn unsolved(&self, system: &Y, step: u64, dt: f64, cause: NotConverged) -> Error {
        system.unsolved(step, [&self.q, &self.v], self.t, dt, cause)
    }
}
