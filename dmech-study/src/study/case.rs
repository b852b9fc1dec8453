//! What all schemes of a study run.

use std::hint::black_box;

use dmech_core::extend::{DoubleDouble, Real, Scheme};
use dmech_core::{Error, Explicit, Stepper};

use crate::error::StudyError;
use crate::motion::{Coordinates, Motion, PositionOf, Repeatable, Scales, StateOf, norm};

/// Steps of a reference, at least.
const FEWEST: f64 = 64.0;

/// A motion from a state until a time.
#[derive(Clone, Debug)]
pub(super) struct Case<L, X: Repeatable<L>> {
    pub(super) motion: Motion<L, X>,
    pub(super) start: StateOf<L, X>,
    /// The longest step of a scheme that follows the motion.
    pub(super) longest: f64,
    pub(super) end: f64,
}

impl<L: Clone, X: Repeatable<L>> Case<L, X> {
    /// The time of the start.
    pub(super) fn t(&self) -> f64 {
        self.start.time()
    }

    /// From the start to the end.
    pub(super) fn span(&self) -> f64 {
        self.end - self.t()
    }

    /// The longest step of a reference. In fewer a motion that is simple at both ends may pass what acts between, and seem to have settled.
    pub(super) fn longest_of_reference(&self) -> f64 {
        self.longest.min(self.span() / FEWEST)
    }

    /// Refuses what every scheme would refuse.
    pub(super) fn check(&self) -> Result<(), Error> {
        let span = self.span();
        // A start at NaN is named by the stepper.
        if self.t().is_finite() && !(span > 0.0 && span.is_finite()) {
            return Err(Error::Span { start: self.t(), end: self.end });
        }
        self.stepper(Explicit, span.max(f64::MIN_POSITIVE)).map(|_| ())
    }

    /// The motion by a scheme.
    pub(super) fn stepper<S: Scheme<X::System>>(&self, scheme: S, dt: f64) -> Result<Stepper<X::System, S>, Error> {
        black_box(self.motion.clone()).scheme(scheme).dt(dt).stepper()
    }

    /// The number of steps of at most this length, and the length with which they end at the end.
    pub(super) fn whole_steps(&self, dt: f64) -> Result<(u64, f64), Error> {
        let steps = dmech_core::extend::steps_until(self.t(), self.end, dt)?.max(1);
        Ok((steps, self.span() / steps as f64))
    }

    /// How much later than the end so many steps end: t₀ + n h − t_end in exact arithmetic.
    pub(super) fn late(&self, steps: u64, dt: f64) -> f64 {
        let [start, end, steps, dt] = [self.t(), self.end, steps as f64, dt].map(DoubleDouble::from);
        (start - end + steps * dt).to_f64()
    }

    /// Lengths and times typical of the start.
    pub(super) fn scales(&self) -> Result<Scales, Error> {
        let stepper = self.stepper(Explicit, self.span())?;
        Ok(Scales::of(stepper.system(), &self.start))
    }

    /// The numbers of an exact position that is one.
    pub(super) fn exact(&self, exact: &PositionOf<L, X>) -> Result<Vec<f64>, StudyError> {
        let (needed, numbers) = (numbers(&self.start).len(), StateOf::<L, X>::numbers(exact).to_vec());
        if numbers.len() != needed {
            return Err(StudyError::Coordinates { given: numbers.len(), needed });
        }
        match numbers.iter().find(|x| !x.is_finite()) {
            Some(&value) => Err(StudyError::Exact { value, time: self.end }),
            None => Ok(numbers),
        }
    }
}

/// The coordinates of a state.
pub(super) fn numbers<C: Coordinates>(state: &C) -> Vec<f64> {
    C::numbers(&state.position()).to_vec()
}

/// The distance between neighbouring numbers where q is.
pub(super) fn rounding(q: &[f64]) -> f64 {
    q.iter().fold(f64::MIN_POSITIVE, |most, x| x.abs().max(most)) * f64::EPSILON
}

/// |a − b|; `None` where it is not finite.
pub(super) fn distance(a: &[f64], b: &[f64]) -> Option<f64> {
    let distance = norm(a.iter().zip(b).map(|(a, b)| a - b));
    (a.iter().all(|x| x.is_finite()) && distance.is_finite()).then_some(distance)
}
