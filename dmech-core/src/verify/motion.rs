//! What a scheme keeps under the law, and whether it finds the way back.

use super::Borrowed;
use super::points::norm;
use super::report::Check;
use super::trial::{Halvings, Trial};
use crate::error::Error;
use crate::invariant::{Invariant, Kept};
use crate::law::{Field, Law, Potential};
use crate::run::Run;
use crate::scheme::Scheme;
use crate::state::State;
use crate::system::Particle;

/// Steps in one unit of time, and steps in all.
const PER_TIME: f64 = 50.0;
const STEPS: u64 = 2000;
/// The explicit formulas spiral outward, some orbits to infinity.
const EXPLICIT_STEPS: u64 = 200;

impl<L, S, const D: usize> Trial<'_, L, S, D>
where
    L: Law<D>,
    S: for<'b> Scheme<Particle<Borrowed<'b, L>, D>>,
{
    /// The largest deviation of an invariant, over the largest |Φ| + m v²/2 or the largest m |q||v| of the run.
    fn deviation(&self, run: &Run<State<D>>, invariant: Invariant) -> Option<f64> {
        let mass = self.scales.mass;
        let size = |state: &State<D>| {
            let speed = norm(state.v);
            match invariant {
                Invariant::AngularMomentum => mass * norm(state.q) * speed,
                _ => self.law.field(mass, state.t).potential(state.q).abs() + 0.5 * mass * speed * speed,
            }
        };
        let drift = run.drift(invariant)?;
        let size = run.states().iter().map(size).fold(0.0, f64::max);
        Some(if drift.max_abs() == 0.0 { 0.0 } else { drift.max_abs() / size })
    }

    /// Exact invariants to round-off; bounded ones by their order: half the step must leave much less than half.
    pub(super) fn invariants(&self, checks: &mut Vec<Check>) {
        let steps = if S::ORDER == 1 { EXPLICIT_STEPS } else { STEPS };
        let first = match self.run(self.scales.time / PER_TIME, steps) {
            Ok(run) => run,
            Err(error) => {
                checks.push(Check::failed(format!("{}: invariants", S::NAME), error));
                return;
            }
        };
        for invariant in Invariant::ALL {
            let name = format!("{}: {invariant}", S::NAME);
            match (S::keeps(invariant), self.deviation(&first, invariant)) {
                (Kept::No, _) => {}
                (_, None) => {
                    if invariant == Invariant::Energy {
                        checks.push(Check::not_applicable(name, "the law does not conserve it"));
                    }
                }
                (Kept::Exact, Some(measured)) => {
                    // A random walk of one unit of rounding per step has √n of them; a few in each of the sums.
                    let bound = 32.0 * f64::EPSILON * (steps as f64).sqrt();
                    checks.push(Check::at_most(name, measured, bound, format!("exact over {steps} steps, relative")));
                }
                (Kept::Bounded, Some(measured)) => checks.push(self.bounded(measured, invariant, name)),
            }
        }
    }

    fn bounded(&self, measured: f64, invariant: Invariant, name: String) -> Check {
        // The deviation is O(h²); 1.5 leaves room for a step that is not yet small, and first order does not reach it.
        const POWER: f64 = 1.5;
        const ROUNDING: f64 = 1e-12;
        let deviation = |level| {
            if level == 0 {
                return Ok(Some(measured));
            }
            let run = self.run(self.scales.time / (PER_TIME * f64::from(1 << level)), STEPS << level)?;
            Ok(self.deviation(&run, invariant))
        };
        let reached = |powers: &[f64]| powers.last().is_some_and(|&power| power >= POWER);
        match Halvings::measure(5, ROUNDING, deviation, reached) {
            Err(error) => Check::failed(name, error),
            Ok(Halvings { error, .. }) if error < ROUNDING => Check::at_most(name, error, ROUNDING, "kept to rounding"),
            Ok(Halvings { powers, error, .. }) => {
                let power = powers.last().copied().unwrap_or(f64::NAN);
                Check::at_least(name, power, POWER, format!("bounded: power of the step; deviates by {error:.0e}"))
            }
        }
    }

    /// Forward, velocity reversed, back.
    pub(super) fn reversibility(&self) -> Check {
        const STEPS: u64 = 200;
        let name = format!("{}: reversibility", S::NAME);
        let reason = if !S::SYMMETRIC {
            "the scheme is not symmetric"
        } else if S::keeps(Invariant::DiscreteEnergy) == Kept::Exact {
            "a two-step scheme: reversed in its own variables, not in the velocity"
        } else if !L::AUTONOMOUS {
            "the law names the time"
        } else if <L::Field<'_> as Field<D>>::FORCED {
            "a force acts beside the potential"
        } else {
            ""
        };
        if !reason.is_empty() {
            return Check::not_applicable(name, reason);
        }
        let (start, dt) = (self.start, self.scales.time / PER_TIME);
        let turned = |state: &State<D>| State { t: start.t, q: state.q, v: state.v.map(|v| -v) };
        let trip = || -> Result<(f64, f64), Error> {
            let there = self.end(start, dt, STEPS)?;
            let back = self.end(&turned(&there), dt, STEPS)?;
            // How much the motion itself magnifies a displacement on the way back.
            let nudge = 1e-7;
            let mut beside = turned(&there);
            beside.q = beside.q.map(|q| q + nudge * self.scales.length);
            let off = self.end(&beside, dt, STEPS)?;
            let growth = self.distance(&off, &back) / nudge;
            Ok((self.distance(&turned(&back), start), growth.max(1.0)))
        };
        match trip() {
            Ok((miss, growth)) => {
                let bound = 16.0 * f64::EPSILON * STEPS as f64 * growth;
                Check::at_most(name, miss, bound, format!("{STEPS} steps and back, relative to the length"))
            }
            Err(error) => Check::failed(name, error.to_string()),
        }
    }
}
