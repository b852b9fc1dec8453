//! What can go wrong, with numbers: of a run here, of setting up a scene in `SceneError`.

#[cfg(feature = "serde")]
mod difference;
mod disagreement;
mod place;
#[cfg(feature = "scene")]
mod scene;
#[cfg(feature = "store")]
mod store;
#[cfg(test)]
mod tests;

#[cfg(feature = "serde")]
pub use difference::Difference;
pub(crate) use disagreement::Culprit;
pub use disagreement::Disagreement;
pub use place::Place;
#[cfg(feature = "scene")]
pub use scene::SceneError;
#[cfg(feature = "store")]
pub use store::{Reach, StoreError};

use thiserror::Error;

use crate::text::Number;
use crate::words::Word;

/// Why a simulation did not start or did not go on.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Error {
    /// No time step was given.
    #[error("the time step is missing: call .dt(h)")]
    MissingTimeStep,
    /// The time step is zero, negative, infinite or NaN, if not in `f64` then in the scalar of the motion.
    #[error("{}", not_positive("the time step", "dt = ", *dt, "take another unit of time"))]
    TimeStep {
        /// The refused time step.
        dt: f64,
    },
    /// The tolerance of [`Simulation::adaptive`](crate::Simulation::adaptive) is zero, negative, infinite or NaN.
    #[error("the tolerance must be positive and finite, not {}", Number(*tolerance))]
    Tolerance {
        /// The refused tolerance.
        tolerance: f64,
    },
    /// A tolerance so small that a step would turn the motion by less than the rounding of its numbers, and a turn take more than
    /// 2⁵² steps.
    #[error(
        "the tolerance {} asks for steps that turn the motion by {} rad, less than its rounding, {}: take a larger one, or a scheme of higher order",
        Number(*tolerance),
        Number(*angle),
        Number(f64::EPSILON)
    )]
    TurnVanished {
        /// The refused tolerance.
        tolerance: f64,
        /// The angle in radians by which a step would turn the linearised motion.
        angle: f64,
    },
    /// Nothing tells how long a step may be: the force does not vary where the motion is, the law names the time, or a body is driven.
    #[error(
        "the law does not tell how long step {step} from t = {} may be (its force is uniform there, it names the time, or a body is driven): give the longest step with .dt(h)",
        Number(*time)
    )]
    NoTimeScale {
        /// The number of the step, counted from 1.
        step: u64,
        /// The time at which the step begins.
        time: f64,
    },
    /// The step that the motion asks for is lost in the rounding of the time, as in a collision, or the end is beyond the reach of any
    /// number of such steps.
    #[error(
        "step {step} from t = {} would have to be as short as {}, where times are {} apart: as where bodies collide, or far from the origin \
         of time",
        Number(*time),
        Number(*dt),
        Number(time.abs().next_up() - time.abs())
    )]
    StepVanished {
        /// The number of the step, counted from 1.
        step: u64,
        /// The time at which the step begins.
        time: f64,
        /// The time step.
        dt: f64,
    },
    /// The mass is zero, negative, infinite or NaN, if not in `f64` then in the scalar of the motion, or times the unit of the masses.
    #[error("{}", not_positive("the mass", "", *mass, "take another unit of mass"))]
    Mass {
        /// The refused mass.
        mass: f64,
    },
    /// A component of the initial state is infinite or NaN.
    #[error("the state must be finite: {quantity} = {}", Number(*value))]
    State {
        /// `t`, `q` or `v`.
        #[cfg_attr(feature = "serde", serde(with = "crate::words"))]
        quantity: Word,
        /// The refused value.
        value: f64,
    },
    /// `record_every(0)`, or `look_every(0)` of an ensemble.
    #[error("record_every and look_every need a number of steps, 1 at least, not 0")]
    RecordEvery,
    /// `record_dt` of a distance that is zero, negative, infinite or NaN, or lost in the rounding of the time.
    #[error("record_dt needs a positive, finite distance that the time can tell, not {}", Number(*dt))]
    RecordDt {
        /// The refused distance.
        dt: f64,
    },
    /// A time of `record_at` is not finite, or lies before the start.
    #[error("no state can be recorded at t = {}: times are finite, and none is before the start at t = {}", Number(*time), Number(*start))]
    RecordAt {
        /// The refused time.
        time: f64,
        /// The time of the start.
        start: f64,
    },
    /// The states to be recorded do not fit into memory.
    #[error(
        "recording {states} states takes {} bytes, more than there are: record fewer with .record_every(n), or write them as they come with .stream(Csv::new(file))",
        Number(*bytes as f64)
    )]
    Recording {
        /// The states of the whole run.
        states: u64,
        /// The memory that they take.
        bytes: u64,
    },
    /// Two quantities of a run have one name: both are [watched](crate::Simulation::watch), or one is an invariant of the law.
    #[error("the run already has a quantity of the name {name:?}: what is watched needs a name of its own")]
    WatchedTwice {
        /// The name.
        #[cfg_attr(feature = "serde", serde(with = "crate::words"))]
        name: Word,
    },
    /// A time at which a stepper has no state: it lies outside the next step.
    #[error("t = {} does not lie in the next step, from t = {} to {}", Number(*time), Number(*from), Number(*to))]
    OutsideStep {
        /// The refused time.
        time: f64,
        /// The time now.
        from: f64,
        /// The end of the next step.
        to: f64,
    },
    /// The end of the run is infinite or NaN, or too many steps away.
    #[error("cannot run until t = {}{}: the end must be finite, and 2^53 steps away at most", Number(*end), in_steps(*dt))]
    EndTime {
        /// The refused end.
        end: f64,
        /// The time step, with a tolerance the longest; infinite where there is none.
        dt: f64,
    },
    /// The time is so large that a step does not change it, or by its rounding only: as an `f64` or, in a law that names it, as
    /// a number of the law's scalar.
    #[error(
        "at t = {} time stands still in steps of {}: the next number{} is {} later; count time from a later origin or take longer steps",
        Number(*time),
        Number(*dt),
        if *next > time.abs() * f64::EPSILON { " of the scalar, in which the law names it," } else { "" },
        Number(*next)
    )]
    TimeStandsStill {
        /// The time.
        time: f64,
        /// The time step.
        dt: f64,
        /// How much later the next number is.
        next: f64,
    },
    /// The law has no finite value where the motion starts, or where it is to go on under a law that was changed, or from another state.
    #[error("the {quantity} of the law is {} where the motion begins or goes on, at t = {}", Number(*value), Number(*time))]
    Law {
        /// `potential` or `force`.
        #[cfg_attr(feature = "serde", serde(with = "crate::words"))]
        quantity: Word,
        /// Its value, or that of its worst component.
        value: f64,
        /// The time of the start.
        time: f64,
    },
    /// The energy of the motion has been no finite number in a state that was looked at: what a step that is too long leaps over, as the wall
    /// of a logarithm, a scheme that asks for forces alone may not notice.
    #[error(
        "the motion has left where its energy is a finite number, at t = {} or before, as by a step that was too long over a wall, to where \
         there is no potential: take shorter steps",
        Number(*time)
    )]
    LeftDomain {
        /// The time of the last state.
        time: f64,
    },
    /// The force is zero where the potential has a slope: in these units it is lost below the smallest number of the
    /// scalar, as 1/r³ is for r = 10¹⁵⁰ where 1/r is not.
    #[error(
        "the force along coordinate {coordinate} is 0 where the motion begins or goes on, at t = {}, and the potential rises by {} per \
         length: what it is computed from is too small or too large for the scalar, take another unit of length",
        Number(*time),
        Number(*slope)
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
    /// A law between two bodies has no finite value where they are.
    #[error("{}, step {step}, t = {}", link(*a, *b, *distance), Number(*time))]
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
    #[error("what acts on body {body} at q = {place} is {}, step {step}, t = {}", Number(*value), Number(*time))]
    Body {
        /// The body.
        body: usize,
        /// The potential, or a component of the force.
        value: f64,
        /// Where the body is.
        place: Place,
        /// The step that led there; 0 at the start.
        step: u64,
        /// The time at which that step began.
        time: f64,
    },
    /// The path that a body of a scene is driven along has no finite place or velocity.
    #[error("the path that body {body} is driven along is not finite at t = {}, step {step}, t = {}", Number(*at), Number(*time))]
    Path {
        /// The body.
        body: usize,
        /// The time that the path was asked for.
        at: f64,
        /// The step that led there; 0 at the start.
        step: u64,
        /// The time at which that step began.
        time: f64,
    },
    /// A step led to an infinite position or velocity.
    #[error(
        "step {step} from t = {} with dt = {} led to a position or velocity that is not finite",
        Number(*time),
        Number(*dt)
    )]
    NotFinite {
        /// The number of the step, counted from 1.
        step: u64,
        /// The time at which the step began.
        time: f64,
        /// The time step.
        dt: f64,
    },
    /// The law is not finite where the equation of an implicit step looks for its solution, and there is none before.
    #[error(
        "step {step} from t = {} with dt = {} has no end: the {quantity} of the law is {} at q = {place}",
        Number(*time),
        Number(*dt),
        Number(*value)
    )]
    LawInStep {
        /// `force`, `potential`, `discrete gradient`, or the derivative of one of them.
        #[cfg_attr(feature = "serde", serde(with = "crate::words"))]
        quantity: Word,
        /// Its value, or that of its worst component.
        value: f64,
        /// Where on the way.
        place: Place,
        /// The number of the step, counted from 1; 0 for a scheme's own start.
        step: u64,
        /// The time at which the step began.
        time: f64,
        /// The time step.
        dt: f64,
    },
    /// The equation of an implicit step has no solution that can be reached from a shorter step, or none that the sweeps of
    /// [`Gauss`](crate::Gauss) and [`LineIntegral`](crate::LineIntegral) or the corrections of [`Relaxed`](crate::Relaxed) lead to.
    #[error(
        "step {step} from t = {} with dt = {} {}",
        Number(*time),
        Number(*dt),
        not_converged(*iterations, *residual)
    )]
    NotConverged {
        /// The number of the step, counted from 1; 0 for a scheme's own start.
        step: u64,
        /// The time at which the step began.
        time: f64,
        /// The time step.
        dt: f64,
        /// Newton corrections made, from all starting points together, and 0 where no root was found that continues the motion; sweeps
        /// made by `Gauss` and `LineIntegral`; corrections of λ made by `Relaxed`.
        iterations: u32,
        /// The last Newton correction, a length; of `Gauss` and `LineIntegral` the largest change of a push in the last sweep, in units
        /// of rounding; of `Relaxed` the last |λ|. Infinite where that was no number.
        residual: f64,
    },
    /// An event of [`bounce_off`](crate::Simulation::bounce_off), `collide_at` of a scene or
    /// [`change_when`](crate::Simulation::change_when) changes the motion more than 64 times within a step: what bounces with a loss comes to
    /// rest so.
    #[error("{}", comes_to_rest(*event, *time, *since))]
    ComesToRest {
        /// Which of the events of the simulation, counted from 0.
        event: usize,
        /// The time.
        time: f64,
        /// The time since it has happened before; 0 where the motion has not left the wall.
        since: f64,
    },
    /// A motion that is behind a wall of [`bounce_off`](crate::Simulation::bounce_off), where it has begun or something else has put it, goes
    /// further: nothing would hold it.
    #[error(
        "at t = {} the motion is behind the wall of event {event}, where its function is {}, and goes further: a wall holds what is in front \
         of it, where the function is positive",
        Number(*time),
        Number(*value)
    )]
    BehindWall {
        /// Which of the events of the simulation, counted from 0.
        event: usize,
        /// The time.
        time: f64,
        /// The value of the function.
        value: f64,
    },
    /// What an event changes, it has changed the time of, too.
    #[error("an event at t = {} may change positions and velocities, not the time, to {}", Number(*time), Number(*changed))]
    ChangedTime {
        /// The time of the event.
        time: f64,
        /// What it was changed to.
        changed: f64,
    },
    /// A study that does not end after it starts, or at no finite time, or a run that is to end before.
    #[error("the end must be finite and come after the start: from t = {} to t = {}", Number(*start), Number(*end))]
    Span {
        /// The time of the start.
        start: f64,
        /// The refused end.
        end: f64,
    },
    /// A rank has another ensemble: another program, or one whose law, start or settings differ there (feature `ranks`).
    #[cfg(feature = "ranks")]
    #[error(
        "rank {rank} has another ensemble: all ranks must run one program, with the same members, law, scheme and steps"
    )]
    OtherEnsemble {
        /// The rank.
        rank: usize,
    },
    /// The first rank has ended the ensemble; what went wrong is told there (feature `ranks`).
    #[cfg(feature = "ranks")]
    #[error("the first rank has ended the ensemble with an error")]
    FirstRank,
    // What does not travel from rank to rank comes last: serde counts the others only.
    /// A recorded state could not be written to a stream.
    #[error("{}", unwritten(*.0))]
    #[cfg_attr(feature = "serde", serde(skip))]
    Stream(std::io::ErrorKind),
    /// A scene that cannot be set up.
    #[cfg(feature = "scene")]
    #[error(transparent)]
    #[cfg_attr(feature = "serde", serde(skip))]
    Scene(#[from] SceneError),
    /// A checkpoint of another simulation (feature `serde`).
    #[cfg(feature = "serde")]
    #[error("cannot resume: {0}")]
    #[cfg_attr(feature = "serde", serde(skip))]
    Checkpoint(Difference),
    /// The store of an ensemble (feature `store`).
    #[cfg(feature = "store")]
    #[error("the store of the ensemble: {0}")]
    #[cfg_attr(feature = "serde", serde(skip))]
    Store(#[from] StoreError),
}

impl Error {
    /// That of a start on the way, after so many steps.
    pub(crate) fn after(mut self, steps: u64) -> Self {
        if let Error::Link { step, .. } | Error::Body { step, .. } | Error::Path { step, .. } = &mut self {
            *step = steps;
        }
        self
    }
}

/// What is no positive number: by itself, or where the numbers of the motion have a narrower range.
fn not_positive(what: &str, name: &str, x: f64, advice: &str) -> String {
    if x > 0.0 && x.is_finite() {
        return format!(
            "{what}, {name}{}, is no positive, finite number of the scalar of the motion: those of `f32` lie between 1e-45 and 3.4e38, of `f64` \
             between 5e-324 and 1.8e308; {advice}",
            Number(x)
        );
    }
    format!("{what} must be positive and finite, not {name}{}", Number(x))
}

/// A stream that has failed, with what its input may be that is no good.
fn unwritten(kind: std::io::ErrorKind) -> String {
    let names = match kind {
        std::io::ErrorKind::InvalidInput => ", for example more names than bodies, or two bodies of the same name",
        _ => "",
    };
    format!("a recorded state could not be written: {kind}{names}")
}

/// The steps of a run, if their length is known.
fn in_steps(dt: f64) -> String {
    if dt.is_finite() { format!(" in steps of {}", Number(dt)) } else { String::new() }
}

/// What became of the equation of a step.
fn not_converged(iterations: u32, residual: f64) -> String {
    if iterations == 0 {
        return "is too long: no root of its equation was found that continues the motion, as down a hill, where the only one lies \
                on the other side, or none that rounding leaves; take shorter steps"
            .into();
    }
    if residual == 0.0 {
        return format!(
            "did not converge: no root was found in {iterations} iterations, as at rest where the force jumps"
        );
    }
    format!(
        "did not converge: after {iterations} iterations the last correction was {} (in sweeps of `Gauss` and `LineIntegral` in units of \
            rounding), as where bodies collide, the potential jumps (`verify` looks for jumps) or most digits of a force cancel; take \
            shorter steps",
        Number(residual)
    )
}

/// What becomes of what bounces with a loss.
fn comes_to_rest(event: usize, time: f64, since: f64) -> String {
    let at = Number(time);
    if since == 0.0 {
        return format!(
            "at t = {at} the motion does not leave the wall of event {event}, however often it is changed there: it lies or slides on it, \
             where no event holds it; stop the run before, or let a law push back"
        );
    }
    format!(
        "event {event} changes the motion at t = {at} more than 64 times within a step, the last {} after another: take shorter steps; if it \
         comes to rest, no event holds it there: stop the run before, or let a law push back",
        Number(since)
    )
}

/// What is wrong between two bodies.
fn link(a: usize, b: usize, distance: f64) -> String {
    if distance == 0.0 {
        format!("bodies {a} and {b} coincide, where their law is not finite")
    } else {
        format!("what acts between bodies {a} and {b} at the distance {} is not finite", Number(distance))
    }
}
