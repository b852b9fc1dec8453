//! A scheme on trial in a motion, and errors that shrink with its step.

use dmech_core::extend::{Scheme, System};
use dmech_core::{Error, Run, Simulation, Stepper};

use super::report::Check;
use crate::motion::{Coordinates, Motion, Repeatable, Scales, StateOf, norm};

/// What the checks of a scheme share.
pub(super) struct Trial<L, X, S> {
    pub(super) motion: Motion<L, X>,
    pub(super) scheme: S,
    pub(super) scales: Scales,
    /// Why the motion has no way back, if it has none.
    pub(super) one_way: Option<&'static str>,
}

impl<L: Clone, X: Repeatable<L>, S: Scheme<X::System>> Trial<L, X, S> {
    /// Every check of a scheme.
    pub(super) fn check(&self, name: &str, checks: &mut Vec<Check>) {
        let so_far = checks.len();
        checks.push(self.order(name));
        self.invariants(name, checks);
        checks.push(self.reversibility(name));
        if X::System::PIECEWISE {
            checks[so_far..].iter_mut().for_each(Check::hint_at_seams);
        }
    }

    fn by_scheme(&self, dt: f64) -> Simulation<L, X, S> {
        self.motion.clone().scheme(self.scheme).dt(dt)
    }

    /// The start.
    pub(super) fn start(&self) -> StateOf<L, X> {
        self.motion.start()
    }

    /// The state after a number of steps from some start.
    pub(super) fn end(&self, start: &StateOf<L, X>, dt: f64, steps: u64) -> Result<StateOf<L, X>, Error> {
        let mut stepper = self.by_scheme(dt).starting_from(start).stepper()?;
        stepper.advance(steps)?;
        Ok(stepper.state())
    }

    /// From the start of the trial.
    pub(super) fn stepper(&self, dt: f64) -> Result<Stepper<X::System, S>, Error> {
        self.by_scheme(dt).stepper()
    }

    /// A run from there.
    pub(super) fn run(&self, dt: f64, steps: u64) -> Result<Run<StateOf<L, X>>, String> {
        self.by_scheme(dt).run(steps).map_err(|interrupted| interrupted.to_string())
    }

    /// Positions in units of the length, velocities in units of length by time.
    pub(super) fn distance(&self, a: &StateOf<L, X>, b: &StateOf<L, X>) -> f64 {
        let Scales { length, time } = self.scales;
        let apart = |a: &[f64], b: &[f64], unit: f64| norm(a.iter().zip(b).map(|(a, b)| (a - b) / unit));
        let (qa, qb) = (a.position(), b.position());
        let numbers = StateOf::<L, X>::numbers;
        apart(numbers(&qa), numbers(&qb), length).hypot(apart(a.velocities(), b.velocities(), length / time))
    }
}

/// Errors e(h), e(h/2), e(h/4), … and the powers of the step that they show.
pub(super) struct Halvings {
    /// log₂ of e(h)/e(h/2), for each halving.
    pub(super) powers: Vec<f64>,
    /// The last error.
    pub(super) error: f64,
    /// How often the step was halved when the loop ended.
    pub(super) level: u32,
}

impl Halvings {
    /// Halves the step up to `most` times, until the powers are `settled` or an error is below `rounding`. `error` gets the
    /// number of halvings; where it has none yet, because a step was too large, the powers begin later.
    pub(super) fn measure(
        most: u32,
        rounding: f64,
        mut error: impl FnMut(u32) -> Result<Option<f64>, String>,
        settled: impl Fn(&[f64]) -> bool,
    ) -> Result<Self, String> {
        let mut halvings = Halvings { powers: Vec::new(), error: f64::NAN, level: 0 };
        for level in 0..=most {
            let coarse = core::mem::replace(&mut halvings.error, error(level)?.unwrap_or(f64::NAN));
            halvings.level = level;
            if halvings.error < rounding {
                break;
            }
            let power = (coarse / halvings.error).log2();
            if !power.is_nan() {
                halvings.powers.push(power);
            }
            if settled(&halvings.powers) {
                break;
            }
        }
        Ok(halvings)
    }
}
