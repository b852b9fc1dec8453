//! What all schemes of a study run.

use std::hint::black_box;

use dmech_scalar::{DoubleDouble, Real};

use crate::error::Error;
use crate::law::Law;
use crate::motion::steps_until;
use crate::scheme::{Explicit, Scheme};
use crate::setup::Setup;
use crate::state::State;
use crate::stepper::{Stepper, check_step};
use crate::system::Particle;
use crate::system::vector::finite;
use crate::verify::Scales;

/// A motion from a state until a time.
#[derive(Clone, Debug)]
pub(super) struct Case<L, const D: usize> {
    pub(super) law: L,
    pub(super) start: State<D>,
    pub(super) end: f64,
    pub(super) mass: f64,
}

impl<L: Law<D> + Clone, const D: usize> Case<L, D> {
    /// Refuses what every scheme would refuse.
    pub(super) fn check(&self) -> Result<(), Error> {
        let span = self.end - self.start.t;
        // A start at NaN is named by the stepper.
        if self.start.t.is_finite() && !(span > 0.0 && span.is_finite()) {
            return Err(Error::Span { start: self.start.t, end: self.end });
        }
        self.stepper(Explicit, span.max(f64::MIN_POSITIVE)).map(|_| ())
    }

    /// The motion by a scheme.
    pub(super) fn stepper<S: Scheme<Particle<L, D>>>(
        &self,
        scheme: S,
        dt: f64,
    ) -> Result<Stepper<Particle<L, D>, S>, Error> {
        check_step::<f64>(scheme.tolerance(), dt)?;
        let start = black_box(self.start);
        Stepper::new(start.system(self.law.clone(), self.mass, dt)?, scheme, start, dt)
    }

    /// The number of steps of at most this length, and the length with which they end at the end.
    pub(super) fn whole_steps(&self, dt: f64) -> Result<(u64, f64), Error> {
        let steps = steps_until(self.start.t, self.end, dt)?.max(1);
        Ok((steps, (self.end - self.start.t) / steps as f64))
    }

    /// How much later than the end so many steps end: t₀ + n h − t_end in exact arithmetic.
    pub(super) fn late(&self, steps: u64, dt: f64) -> f64 {
        let [start, end, steps, dt] = [self.start.t, self.end, steps as f64, dt].map(DoubleDouble::from);
        (start - end + steps * dt).to_f64()
    }

    /// Lengths and times typical of the start.
    pub(super) fn scales(&self) -> Scales {
        Scales::new(&self.law, &self.start, self.mass)
    }

    /// An exact position that is one.
    pub(super) fn finite(&self, exact: [f64; D]) -> Result<[f64; D], Error> {
        match exact.into_iter().find(|x| !x.is_finite()) {
            Some(value) => Err(Error::Exact { value, time: self.end }),
            None => Ok(exact),
        }
    }
}

/// The distance between neighbouring numbers where q is.
pub(super) fn rounding<const D: usize>(q: &[f64; D]) -> f64 {
    q.iter().fold(f64::MIN_POSITIVE, |most, x| x.abs().max(most)) * f64::EPSILON
}

/// |a − b|; `None` where it is not finite.
pub(super) fn distance<const D: usize>(a: &[f64; D], b: &[f64; D]) -> Option<f64> {
    let distance = a.iter().zip(b).fold(0.0_f64, |sum, (a, b)| sum.hypot(a - b));
    (finite(*a) && distance.is_finite()).then_some(distance)
}
