//! Relaxation oscillations.

use dmech::models::VanDerPol;
use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, short};

const LAW: VanDerPol = VanDerPol { mu: 1000.0 };

pub(crate) fn case(length: Length) -> Case {
    let mut case = Case::new(
        "van_der_pol",
        "Van der Pol's oscillator with μ = 1000",
        "For 800 units of time it creeps at a speed of 1e-3, then it leaps from −1 to 2 in a thousandth of a unit, at a speed of 1300.",
        "An implicit scheme creeps at any step; a leap that a step does not resolve has no root that continues the motion, and the run stops there with an error. Where it is half resolved the body leaps too far and the period is too long; resolved, it is that of Dorodnitsyn's expansion, 1614.41.",
        &["period", "fastest"],
    );
    let creep = |q: f64| State::new([q], [-q / (LAW.mu * (q * q - 1.0))]);
    // A little before the leap, and past it; then the whole cycle.
    for (start, end, dt, every) in [(creep(1.05), 10.0, 0.1, 1), (creep(1.05), 10.0, 0.0002, 1)] {
        let motion = Motion::until(LAW, start, end, (end / dt) as u64).record_every(every);
        for trial in every_scheme!(any: motion) {
            measure(&mut case, &trial);
            if dt == 0.0002 && trial.scheme != "Explicit" {
                let end = (trial.run.last().q[0] + 2.0).abs();
                case.check(format!("{}: from the other side", trial.scheme), end, 0.02);
            }
        }
    }
    if length == Length::Whole {
        let motion = Motion::until(LAW, creep(2.0), 2600.0, 5_200_000).record_every(10);
        let trials = every_scheme!(any: motion);
        for trial in &trials {
            let period = measure(&mut case, trial);
            if trial.scheme.contains('6') {
                // Terms left out: of order ln μ/μ.
                let expected = LAW.relaxation_period() + 7.014 / LAW.mu.cbrt();
                case.check(format!("{}: period", trial.scheme), (period - expected).abs(), 0.05);
            }
        }
        case.pictures.push(picture(&trials));
    }
    case
}

/// The time between two passages of q = 0 downwards, by a line through the states around them.
fn period(trial: &Trial<State<1>>) -> Option<f64> {
    let down = |pair: &&[State<1>]| pair[0].q[0] > 0.0 && pair[1].q[0] <= 0.0;
    let at = |pair: &[State<1>]| {
        let part = pair[0].q[0] / (pair[0].q[0] - pair[1].q[0]);
        pair[0].t + part * (pair[1].t - pair[0].t)
    };
    let passages: Vec<_> = trial.run.states().windows(2).filter(down).map(at).collect();
    (passages.len() == 2 && trial.completed()).then(|| passages[1] - passages[0])
}

fn measure(case: &mut Case, trial: &Trial<State<1>>) -> f64 {
    let period = period(trial).unwrap_or(f64::NAN);
    let fastest = trial.states().map(|s| s.v[0].abs()).fold(0.0, f64::max);
    let told = if period.is_nan() { "–".to_owned() } else { format!("{period:.3}") };
    case.row(trial, vec![told, short(fastest)]);
    period
}

fn picture(trials: &[Trial<State<1>>]) -> Picture {
    let drawn = ["Implicit", "DiscreteGradient"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        let states = trial.run.states();
        // Points of the creep are far apart, those of the leap all shown.
        let shown = states.windows(2).enumerate().filter(|(k, pair)| k % 200 == 0 || pair[1].v[0].abs() > 0.05);
        let mut line = Line::new(trial, shown.map(|(_, pair)| (pair[0].t, pair[0].q[0])).collect());
        if let Some(period) = period(trial) {
            line.note = Some(format!("period {period:.2}"));
        }
        Some(line)
    });
    Picture {
        name: "hard_van_der_pol",
        title: "Van der Pol's oscillator with μ = 1000, dt = 0.0005".to_owned(),
        words: vec![
            "It creeps for 800 units of time and leaps from −1 to 2 within a thousandth. The exact period is 1614.41."
                .to_owned(),
            "Both schemes take each leap in a few steps and leap a little too far: their periods are too long."
                .to_owned(),
        ],
        x: Scale::linear("time t", 0.0, 2600.0),
        y: Scale::linear("q", -2.2, 2.2),
        lines: lines.collect(),
        behind: None,
    }
}
