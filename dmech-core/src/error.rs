//! What can go wrong, with numbers.

use thiserror::Error;

use crate::run::Run;

/// Why a simulation did not start or did not go on.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// No time step was given.
    #[error("the time step is missing: call .dt(h)")]
    MissingTimeStep,
    /// The time step is zero, negative, infinite or NaN.
    #[error("the time step must be positive and finite, not dt = {dt}")]
    TimeStep {
        /// The refused time step.
        dt: f64,
    },
    /// The mass is zero, negative, infinite or NaN.
    #[error("the mass must be positive and finite, not {mass}")]
    Mass {
        /// The refused mass.
        mass: f64,
    },
    /// A component of the initial state is infinite or NaN.
    #[error("the initial state must be finite: {quantity} = {value}")]
    State {
        /// `t`, `q` or `v`.
        quantity: &'static str,
        /// The refused value.
        value: f64,
    },
    /// `record_every(0)`.
    #[error("record_every needs at least 1")]
    RecordEvery,
    /// The end of `run_until` is infinite or NaN, or too many steps away.
    #[error("cannot run until t = {end} in steps of {dt}")]
    EndTime {
        /// The refused end.
        end: f64,
        /// The time step.
        dt: f64,
    },
    /// The law has no finite value where the motion starts.
    #[error("the {quantity} of the law is {value} at the start, t = {time}")]
    Law {
        /// `potential` or `force`.
        quantity: &'static str,
        /// Its value, or that of its worst component.
        value: f64,
        /// The time of the start.
        time: f64,
    },
    /// A step led to an infinite position or velocity.
    #[error("step {step} from t = {time} with dt = {dt} led to a position or velocity that is not finite")]
    NotFinite {
        /// The number of the step, counted from 1.
        step: u64,
        /// The time at which the step began.
        time: f64,
        /// The time step.
        dt: f64,
    },
    /// The equation of an implicit step has no solution that can be reached from a shorter step.
    #[error(
        "step {step} from t = {time} with dt = {dt} did not converge: after {iterations} iterations the last correction was {residual:e}"
    )]
    NotConverged {
        /// The number of the step, counted from 1; 0 for a scheme's own start.
        step: u64,
        /// The time at which the step began.
        time: f64,
        /// The time step.
        dt: f64,
        /// Newton corrections made.
        iterations: u32,
        /// Largest component of the last correction (a length).
        residual: f64,
    },
}

/// A run that ended early: what it computed, and why it ended.
#[derive(Clone)]
pub struct Interrupted<X> {
    inner: Box<(Run<X>, Error)>,
}

impl<X> Interrupted<X> {
    pub(crate) fn new(run: Run<X>, cause: Error) -> Self {
        Interrupted { inner: Box::new((run, cause)) }
    }

    /// Everything up to the failed step; no states at all if the input was refused.
    pub fn run(&self) -> &Run<X> {
        &self.inner.0
    }

    /// The same, by value.
    pub fn into_run(self) -> Run<X> {
        self.inner.0
    }

    /// Why the run ended.
    pub fn cause(&self) -> Error {
        self.inner.1
    }
}

impl<X> core::fmt::Display for Interrupted<X> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let recorded = self.run().states().len();
        write!(f, "{}", self.cause())?;
        if recorded > 0 {
            write!(f, " ({} steps done, {recorded} states recorded)", self.run().steps())?;
        }
        Ok(())
    }
}

/// The cause in words and not every recorded state: this is what `unwrap` and a failing `main` print.
impl<X> core::fmt::Debug for Interrupted<X> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_tuple("Interrupted").field(&self.to_string()).finish()
    }
}

impl<X> std::error::Error for Interrupted<X> {}
