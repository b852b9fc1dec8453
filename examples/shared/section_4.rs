//! Greenspan §4: the pendulum x″ = −sin x − α x′, its extrema, and where the explicit method stops being stable.

use std::f64::consts::FRAC_PI_4;

use dmech::models::{DampedPendulum, Pendulum};
use dmech::prelude::*;

/// x″ = −sin x − α x′ (4.1), unit mass, α ≥ 0.
pub(crate) const fn damped(alpha: f64) -> DampedPendulum {
    DampedPendulum { k: 1.0, alpha }
}

/// x″ = −sin x: a law of its own, since leap-frog is refused for one that has a velocity in it, even with α = 0.
pub(crate) const PENDULUM: Pendulum = Pendulum { k: 1.0 };

/// x₀ = π/4, v₀ = 0.
pub(crate) const START: State<1> = State::new([FRAC_PI_4], [0.0]);
/// The steps of each case.
pub(crate) const STEPS: u64 = 10_000;
pub(crate) const ALPHAS: [f64; 4] = [0.003, 0.002, 0.001, 0.0];
pub(crate) const TIME_STEPS: [f64; 3] = [1.0, 0.1, 0.01];

pub(crate) type Outcome = Result<Run<State<1>>, Interrupted<State<1>>>;

/// One of the twelve cases of the implicit formulas (4.3)–(4.5).
///
/// # Errors
/// Those of the run.
pub(crate) fn implicit(alpha: f64, dt: f64) -> Outcome {
    Simulation::new(damped(alpha), START).scheme(Implicit).dt(dt).run(STEPS)
}

/// One of the three cases of the leap-frog formulas (3.2)–(3.6).
///
/// # Errors
/// Those of the run.
pub(crate) fn leapfrog(dt: f64) -> Outcome {
    Simulation::new(PENDULUM, START).scheme(Leapfrog).dt(dt).run(STEPS)
}

/// How far the relative extrema of an undamped motion are from ±π/4.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extrema {
    /// The number of relative maxima and minima after the start.
    pub(crate) count: usize,
    /// The largest ||x| − π/4| of them as they stand in the sequence x_k.
    pub(crate) raw: f64,
    /// The same at the vertex of the parabola through the extremum and its neighbours.
    pub(crate) parabola: f64,
    /// The largest |x_k| − π/4 of all: above 0 if the pendulum ever swings too far.
    pub(crate) overshoot: f64,
}

impl Extrema {
    pub(crate) fn of(states: &[State<1>]) -> Self {
        let mut extrema = Extrema { count: 0, raw: 0.0, parabola: 0.0, overshoot: f64::NEG_INFINITY };
        for state in &states[1..] {
            extrema.overshoot = extrema.overshoot.max(state.q[0].abs() - FRAC_PI_4);
        }
        for three in states.windows(3) {
            let [before, here, after] = [three[0].q[0], three[1].q[0], three[2].q[0]];
            if (here - before) * (after - here) > 0.0 || here == before {
                continue;
            }
            extrema.count += 1;
            extrema.raw = extrema.raw.max((here.abs() - FRAC_PI_4).abs());
            extrema.parabola = extrema.parabola.max((vertex(before, here, after).abs() - FRAC_PI_4).abs());
        }
        extrema
    }
}

/// The extreme value of the parabola through three values at equal distances.
fn vertex(before: f64, here: f64, after: f64) -> f64 {
    let (slope, bend) = (after - before, (here - before) - (after - here));
    here + slope * slope / (8.0 * bend)
}

/// min(2α, 2/α), where the paper prints max: `Explicit` is stable for the linear pendulum x″ = −x − αx′ with a shorter
/// step, and with no other.
///
/// A step multiplies (x, v) by a matrix with determinant 1 − αh + h²/2 and trace 2 − αh − h²/2. Both eigenvalues are
/// in the unit circle when |trace| < 1 + determinant < 2: on the left 2 − αh > 0, on the right h < 2α.
pub(crate) fn explicit_limit(alpha: f64) -> f64 {
    (2.0 * alpha).min(2.0 / alpha)
}

/// The larger absolute eigenvalue of that matrix: the growth of the amplitude in a step.
pub(crate) fn predicted_growth(alpha: f64, dt: f64) -> f64 {
    let determinant = 1.0 - alpha * dt + 0.5 * dt * dt;
    let half_trace = 1.0 - 0.5 * alpha * dt - 0.25 * dt * dt;
    let discriminant = half_trace * half_trace - determinant;
    if discriminant < 0.0 { determinant.sqrt() } else { half_trace.abs() + discriminant.sqrt() }
}

/// The growth of the amplitude √(x² + v²) in a step of `Explicit`: the mean over the second half of 2n steps, from an
/// amplitude so small that sin x is x.
///
/// # Errors
/// Those of the steps.
pub(crate) fn measured_growth(alpha: f64, dt: f64, n: u64) -> Result<f64, Error> {
    let start: State<1> = State::new([1e-100], [0.0]);
    let mut stepper = Simulation::new(damped(alpha), start).scheme(Explicit).dt(dt).stepper()?;
    let mut amplitudes = [0.0; 2];
    for amplitude in &mut amplitudes {
        stepper.advance(n)?;
        let state = stepper.state();
        *amplitude = state.q[0].hypot(state.v[0]);
    }
    Ok((amplitudes[1] / amplitudes[0]).powf(1.0 / n as f64))
}

/// α, and the n that shows its growth 2 % below and above the limit.
pub(crate) const STABILITY: [(f64, u64); 3] = [(0.003, 2_000_000), (0.2, 2_000), (3.0, 1_000)];
