//! Where a step begins.

use dmech_scalar::{Count, Real};

use crate::error::Error;
use crate::newton::NotConverged;
use crate::scheme::Reached;
use crate::span::is_possible;
use crate::system::{Beginning, Effort, System};

/// A system where its motion begins, whatever scheme moves it, and the length of the steps.
pub(crate) struct Opening<Y: System> {
    pub(crate) system: Y,
    pub(crate) start: Y::State,
    pub(crate) departure: Departure<Y>,
    pub(crate) dt: f64,
}

/// Where a step begins: position, velocity, and the slope there.
pub(crate) struct Departure<Y: System> {
    q: Y::Vector,
    v: Y::Vector,
    slope: Y::Vector,
    t: f64,
}

impl<Y: System> Departure<Y> {
    /// From which a motion starts.
    pub(crate) fn prepared(system: &Y, start: &Y::State) -> Result<Self, Error> {
        let mut slope = system.zero();
        system.prepare(start, &mut slope)?;
        let [q, v] = system.vectors(start);
        Ok(Departure { q, v, slope, t: Y::time(start) })
    }

    /// The same of a motion that has made some steps.
    pub(super) fn after(steps: u64, system: &Y, start: Y::State) -> Result<(Y::State, Self), Error> {
        let departure = Departure::prepared(system, &start).map_err(|error| error.after(steps))?;
        Ok((start, departure))
    }

    /// From which it goes on as from another, with driven bodies where their paths lead; in steps that change a time by more than this
    /// resolution, if by any.
    pub(crate) fn another(
        steps: u64,
        system: &Y,
        state: &Y::State,
        dt: f64,
        resolution: Option<f64>,
    ) -> Result<(Y::State, Self), Error> {
        system.check(state)?;
        let t = Y::time(state);
        is_possible(t, dt, resolution)?;
        let [q, v] = system.vectors(state);
        Self::after(steps, system, system.state(t, &q, &v))
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

    /// The state at a time to which a step from here has led, and the evaluations, with that of the slope, and corrections that it took.
    pub(super) fn reached(
        &self,
        system: &Y,
        step: u64,
        t: f64,
        reached: Result<Reached<Y>, NotConverged>,
    ) -> Result<(Y::State, [u64; 2]), Error> {
        let dt = t - self.t;
        match reached {
            Err(cause) => Err(self.unsolved(system, step, dt, cause)),
            Ok(([q, v], _)) if !Y::is_finite(&q) || !Y::is_finite(&v) || !system.is_placed(t) => {
                Err(system.not_finite(step, [&q, &v], self.t, dt))
            }
            Ok(([q, v], mut effort)) => {
                effort += Effort::of(1);
                let spent = [effort.evaluations.to_u64(), effort.iterations.to_u64()];
                Ok((system.state(t, &q, &v), spent))
            }
        }
    }

    /// Why a step of some length from here has not been solved.
    pub(super) fn unsolved(&self, system: &Y, step: u64, dt: f64, cause: NotConverged) -> Error {
        system.unsolved(step, [&self.q, &self.v], self.t, dt, cause)
    }
}
