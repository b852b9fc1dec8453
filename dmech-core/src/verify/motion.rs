//! What a scheme keeps under the law, and whether it finds the way back.

use super::Borrowed;
use super::order::distance;
use super::points::{MASS, Scales, norm};
use super::report::Check;
use crate::error::Error;
use crate::invariant::{Invariant, Kept};
use crate::law::{Field, Law, Potential};
use crate::run::Run;
use crate::scheme::Scheme;
use crate::simulation::Simulation;
use crate::state::State;

/// Steps in one unit of time, and steps in all.
const PER_TIME: f64 = 50.0;
const STEPS: u64 = 2000;
/// The explicit formulas spiral outward, some orbits to infinity.
const EXPLICIT_STEPS: u64 = 200;

/// The state after a number of steps.
pub(super) fn end<L, S, const D: usize>(
    law: &L,
    scheme: S,
    start: &State<D>,
    dt: f64,
    steps: u64,
) -> Result<State<D>, Error>
where
    L: Law<D>,
    S: for<'a> Scheme<Borrowed<'a, L>, D>,
{
    let mut stepper = Simulation::new(Borrowed(law), *start).mass(MASS).scheme(scheme).dt(dt).stepper()?;
    stepper.advance(steps)?;
    Ok(stepper.state())
}

fn run<L, S, const D: usize>(law: &L, scheme: S, start: &State<D>, dt: f64, steps: u64) -> Result<Run<State<D>>, String>
where
    L: Law<D>,
    S: for<'a> Scheme<Borrowed<'a, L>, D>,
{
    let run = Simulation::new(Borrowed(law), *start).mass(MASS).scheme(scheme).dt(dt).run(steps);
    run.map_err(|interrupted| interrupted.to_string())
}

/// The largest |Φ| + m v²/2, and the largest m |q||v|: what deviations are compared with.
fn sizes<L: Law<D>, const D: usize>(law: &L, run: &Run<State<D>>) -> (f64, f64) {
    let mut sizes = (0.0_f64, 0.0_f64);
    for state in run.states() {
        let speed = norm(state.v);
        let energy = law.field(MASS, state.t).potential(state.q).abs() + 0.5 * MASS * speed * speed;
        sizes = (sizes.0.max(energy), sizes.1.max(MASS * norm(state.q) * speed));
    }
    sizes
}

fn deviation<L: Law<D>, const D: usize>(law: &L, run: &Run<State<D>>, invariant: Invariant) -> Option<f64> {
    let (energy, turn) = sizes(law, run);
    let size = if invariant == Invariant::AngularMomentum { turn } else { energy };
    let drift = run.drift(invariant)?;
    Some(if drift.max_abs() == 0.0 { 0.0 } else { drift.max_abs() / size })
}

/// Exact invariants to round-off; bounded ones by their order: half the step must leave much less than half.
pub(super) fn invariants<L, S, const D: usize>(
    law: &L,
    scheme: S,
    start: &State<D>,
    scales: &Scales,
    checks: &mut Vec<Check>,
) where
    L: Law<D>,
    S: for<'a> Scheme<Borrowed<'a, L>, D>,
{
    let steps = if S::ORDER == 1 { EXPLICIT_STEPS } else { STEPS };
    let dt = scales.time / PER_TIME;
    let first = match run(law, scheme, start, dt, steps) {
        Ok(run) => run,
        Err(error) => {
            checks.push(Check::failed(format!("{}: invariants", S::NAME), error));
            return;
        }
    };
    for invariant in Invariant::ALL {
        let name = format!("{}: {invariant}", S::NAME);
        match (S::keeps(invariant), deviation(law, &first, invariant)) {
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
            (Kept::Bounded, Some(measured)) => {
                checks.push(bounded(law, scheme, start, (dt, measured), invariant, name));
            }
        }
    }
}

fn bounded<L, S, const D: usize>(
    law: &L,
    scheme: S,
    start: &State<D>,
    (mut dt, mut coarse): (f64, f64),
    invariant: Invariant,
    name: String,
) -> Check
where
    L: Law<D>,
    S: for<'a> Scheme<Borrowed<'a, L>, D>,
{
    // The deviation is O(h²); 1.5 leaves room for a step that is not yet small, and first order does not reach it.
    const EXPONENT: f64 = 1.5;
    let (mut steps, mut exponent) = (STEPS, f64::NAN);
    for _ in 0..5 {
        if coarse < 1e-12 {
            return Check::at_most(name, coarse, 1e-12, "kept to rounding");
        }
        (dt, steps) = (0.5 * dt, 2 * steps);
        let fine = match run(law, scheme, start, dt, steps) {
            Ok(run) => deviation(law, &run, invariant).unwrap_or(f64::NAN),
            Err(error) => return Check::failed(name, error),
        };
        exponent = (coarse / fine).log2();
        coarse = fine;
        if exponent >= EXPONENT {
            break;
        }
    }
    Check::at_least(name, exponent, EXPONENT, format!("bounded: power of the step; deviates by {coarse:.0e}"))
}

/// Forward, velocity reversed, back.
pub(super) fn reversibility<L, S, const D: usize>(
    law: &L,
    scheme: S,
    start: &State<D>,
    scales: &Scales,
    checks: &mut Vec<Check>,
) where
    L: Law<D>,
    S: for<'a> Scheme<Borrowed<'a, L>, D>,
{
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
        checks.push(Check::not_applicable(name, reason));
        return;
    }
    let dt = scales.time / PER_TIME;
    let turned = |state: &State<D>| State { t: start.t, q: state.q, v: state.v.map(|v| -v) };
    let trip = || -> Result<(f64, f64), Error> {
        let there = end(law, scheme, start, dt, STEPS)?;
        let back = end(law, scheme, &turned(&there), dt, STEPS)?;
        // How much the motion itself magnifies a displacement on the way back.
        let nudge = 1e-7;
        let mut beside = turned(&there);
        beside.q = beside.q.map(|q| q + nudge * scales.length);
        let off = end(law, scheme, &beside, dt, STEPS)?;
        let growth = distance(&off, &back, scales) / nudge;
        Ok((distance(&turned(&back), start, scales), growth.max(1.0)))
    };
    checks.push(match trip() {
        Ok((miss, growth)) => {
            let bound = 16.0 * f64::EPSILON * STEPS as f64 * growth;
            Check::at_most(name, miss, bound, format!("{STEPS} steps and back, relative to the length"))
        }
        Err(error) => Check::failed(name, error.to_string()),
    });
}
