//! A scheme on trial under a law, and errors that shrink with its step.

use core::array::from_fn;

use super::Borrowed;
use super::points::{Scales, norm};
use crate::error::Error;
use crate::law::Law;
use crate::run::Run;
use crate::scheme::Scheme;
use crate::simulation::Simulation;
use crate::state::State;
use crate::system::Particle;

/// What the checks of a scheme share.
pub(super) struct Trial<'a, L, S, const D: usize> {
    pub(super) law: &'a L,
    pub(super) scheme: S,
    pub(super) start: &'a State<D>,
    pub(super) scales: &'a Scales,
}

impl<L, S, const D: usize> Trial<'_, L, S, D>
where
    L: Law<D>,
    S: for<'b> Scheme<Particle<Borrowed<'b, L>, D>>,
{
    fn motion(&self, start: &State<D>, dt: f64) -> Simulation<Borrowed<'_, L>, State<D>, S> {
        Simulation::new(Borrowed(self.law), *start).mass(self.scales.mass).scheme(self.scheme).dt(dt)
    }

    /// The state after a number of steps from some start.
    pub(super) fn end(&self, start: &State<D>, dt: f64, steps: u64) -> Result<State<D>, Error> {
        let mut stepper = self.motion(start, dt).stepper()?;
        stepper.advance(steps)?;
        Ok(stepper.state())
    }

    /// A run from the start of the trial.
    pub(super) fn run(&self, dt: f64, steps: u64) -> Result<Run<State<D>>, String> {
        self.motion(self.start, dt).run(steps).map_err(|interrupted| interrupted.to_string())
    }

    /// Positions in units of the length, velocities in units of length by time.
    pub(super) fn distance(&self, a: &State<D>, b: &State<D>) -> f64 {
        let Scales { length, time, .. } = *self.scales;
        let position: [f64; D] = from_fn(|i| (a.q[i] - b.q[i]) / length);
        let velocity: [f64; D] = from_fn(|i| (a.v[i] - b.v[i]) * time / length);
        norm(position).hypot(norm(velocity))
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
