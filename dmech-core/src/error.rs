//! What can go wrong, with numbers.

use thiserror::Error;

use crate::run::Run;
use crate::written::Disagreement;

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
    /// The tolerance of [`Simulation::adaptive`](crate::Simulation::adaptive) is zero, negative, infinite or NaN.
    #[error("the tolerance must be positive and finite, not {tolerance}")]
    Tolerance {
        /// The refused tolerance.
        tolerance: f64,
    },
    /// Nothing tells how long a step may be: the force does not vary where the motion is, or the law names the time.
    #[error(
        "the law does not tell how long step {step} from t = {time} may be (its force is uniform there, or it names the time): give the longest step with .dt(h)"
    )]
    NoTimeScale {
        /// The number of the step, counted from 1.
        step: u64,
        /// The time at which the step begins.
        time: f64,
    },
    /// The step that the motion asks for is lost in the rounding of the time, as in a collision.
    #[error("step {step} from t = {time} would have to be as short as {dt:e}")]
    StepVanished {
        /// The number of the step, counted from 1.
        step: u64,
        /// The time at which the step begins.
        time: f64,
        /// The time step.
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
    /// The force is zero where the potential has a slope: in these units it is lost below the smallest number of the
    /// scalar, as 1/r³ is for r = 10¹⁵⁰ where 1/r is not.
    #[error(
        "the force along coordinate {coordinate} is 0 at the start, t = {time}, where the potential rises by {slope:e} per length: \
         a power of the position is too small for the scalar, take a larger unit of length"
    )]
    Underflow {
        /// The coordinate, counted from 0.
        coordinate: usize,
        /// The slope of the potential along it, as a difference shows it.
        slope: f64,
        /// The time of the start.
        time: f64,
    },
    /// What a macro derived from the text of a law is not what the method gives: a name means something else than its text.
    #[error("{0}")]
    NotAsWritten(Disagreement),
    /// A scene without bodies.
    #[error("the scene has no bodies")]
    EmptyScene,
    /// The mass of a body is zero, negative, infinite or NaN.
    #[error("the mass of body {body} must be positive and finite, not {mass}")]
    BodyMass {
        /// The body, counted from 0.
        body: usize,
        /// The refused mass.
        mass: f64,
    },
    /// A component of the position or velocity of a body is infinite or NaN.
    #[error("body {body} must start from a finite state: {quantity} = {value}")]
    BodyState {
        /// The body, counted from 0.
        body: usize,
        /// `q` or `v`.
        quantity: &'static str,
        /// The refused value.
        value: f64,
    },
    /// A pin on a body that is not there.
    #[error("body {body} cannot be pinned: the bodies are 0 to {}", bodies - 1)]
    Pin {
        /// The body.
        body: usize,
        /// The number of bodies.
        bodies: usize,
    },
    /// A pinned body with a velocity.
    #[error("body {body} is pinned and must start at rest: a component of its velocity is {speed}")]
    PinnedMoves {
        /// The body.
        body: usize,
        /// A component of its velocity.
        speed: f64,
    },
    /// A bond with a body that is not there.
    #[error("no bond between {a} and {b}: the bodies are 0 to {}", bodies - 1)]
    Bond {
        /// The first body.
        a: usize,
        /// The second body.
        b: usize,
        /// The number of bodies.
        bodies: usize,
    },
    /// A bond of a body with itself.
    #[error("body {body} is bonded to itself")]
    SelfBond {
        /// The body.
        body: usize,
    },
    /// A bond that is listed twice.
    #[error("the bond between bodies {a} and {b} is listed twice")]
    DuplicateBond {
        /// The first body.
        a: usize,
        /// The second body.
        b: usize,
    },
    /// A law between two bodies has no finite value where they are.
    #[error("{}, step {step}, t = {time}", link(*a, *b, *distance))]
    Link {
        /// The first body.
        a: usize,
        /// The second body.
        b: usize,
        /// Their distance.
        distance: f64,
        /// The step that led there; 0 at the start.
        step: u64,
        /// The time at which that step began.
        time: f64,
    },
    /// A law on one body has no finite value where it is.
    #[error("what acts on body {body} is {value}, step {step}, t = {time}")]
    Body {
        /// The body.
        body: usize,
        /// The potential, or a component of the force.
        value: f64,
        /// The step that led there; 0 at the start.
        step: u64,
        /// The time at which that step began.
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
    /// A study without schemes.
    #[error("the study has no schemes: call .scheme(...)")]
    NoSchemes,
    /// A study that does not end after it starts.
    #[error("a study must end after its start: from t = {start} to t = {end}")]
    Span {
        /// The time of the start.
        start: f64,
        /// The refused end.
        end: f64,
    },
    /// The exact solution given to a study is infinite or NaN.
    #[error("the exact solution has the component {value} at the end, t = {time}")]
    Exact {
        /// The refused component.
        value: f64,
        /// The time of the end.
        time: f64,
    },
    /// A checkpoint of another simulation (feature `serde`).
    #[cfg(feature = "serde")]
    #[error("cannot resume: {0}")]
    Checkpoint(crate::checkpoint::Difference),
}

/// What is wrong between two bodies.
fn link(a: usize, b: usize, distance: f64) -> String {
    if distance == 0.0 {
        format!("bodies {a} and {b} coincide, where their law is not finite")
    } else {
        // Bodies that a step too long has thrown apart: not hundreds of digits.
        let distance = if (1e-3..1e6).contains(&distance) { format!("{distance}") } else { format!("{distance:e}") };
        format!("what acts between bodies {a} and {b} at the distance {distance} is not finite")
    }
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
