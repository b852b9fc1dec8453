//! The pendulum that is let go at its highest point, nearly.

use std::f64::consts::PI;

use dmech::models::Pendulum;
use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, short};

const LAW: Pendulum = Pendulum { k: 1.0 };

pub(crate) fn case(_: Length) -> Case {
    let mut case = Case::new(
        "summit",
        "The pendulum released at rest 1e-9 from the top",
        "It falls after 22.8, a quarter of a period that a larger step makes shorter or longer; half a period later it stands 1e-9 from the top again, where 5e-19 of energy, less than a rounding, decides whether it swings back or turns over.",
        "The fall is at the exact time, with the order of the scheme; whoever keeps the energy stands at the top once more with |v| below 1e-7. What comes then is chance.",
        &["falls at", "too late", "order", "top again"],
    );
    let start = State::new([PI - 1e-9], [0.0]);
    let quarter = 0.25 * LAW.period(start.q[0]);
    let mut before: Vec<f64> = Vec::new();
    for steps in [600, 1200, 2400] {
        let motion = Motion::until(LAW, start, 60.0, steps);
        let trials = every_scheme!(positions: motion);
        let late: Vec<_> = trials.iter().map(|trial| passage(trial.run.states()) - quarter).collect();
        for (k, trial) in trials.iter().enumerate() {
            let order = before.get(k).map_or(f64::NAN, |before| (before / late[k]).abs().log2());
            measure(&mut case, trial, late[k] + quarter, late[k], order);
        }
        if steps == 600 {
            case.pictures.push(picture(&trials));
        }
        before = late;
    }
    case
}

/// The angle is known to 4e-16 of 1e-9, and so is the logarithm of it: a time of 1e-5 or so that no scheme can better.
const KNOWN: f64 = 2e-5;

fn measure(case: &mut Case, trial: &Trial<State<1>>, falls: f64, late: f64, order: f64) {
    let Trial { scheme, dt, .. } = *trial;
    // Near the other top, the smallest speed.
    let turn = trial.states().filter(|s| s.t > falls + 5.0 && s.t < 60.0);
    let slowest = turn.map(|s| s.v[0].abs()).fold(f64::INFINITY, f64::min);
    case.row(trial, vec![short(falls), short(late), short(order), short(slowest)]);
    if trial.exact_energy() && trial.run.kept(Invariant::Energy) == Kept::Exact {
        case.check(format!("{scheme} at dt = {dt}: speed at the top"), slowest, 1e-7);
    }
    let declared = f64::from(trial.run.report().order());
    if late.abs() > 10.0 * KNOWN && order.is_finite() {
        let most = if declared == 1.0 { 0.2 } else { 0.1 };
        case.check(format!("{scheme} at dt = {dt}: order {order:.3} is off by"), (order - declared).abs(), most);
    }
    if scheme.contains('6') {
        case.check(format!("{scheme} at dt = {dt}: late"), late.abs(), KNOWN);
    }
}

/// When q = 0 is first passed, by a cubic through position and velocity at both ends of the step.
fn passage(states: &[State<1>]) -> f64 {
    let Some(pair) = states.windows(2).find(|pair| pair[1].q[0] <= 0.0) else { return f64::NAN };
    let h = pair[1].t - pair[0].t;
    let (a, b, u, w) = (pair[0].q[0], pair[1].q[0], h * pair[0].v[0], h * pair[1].v[0]);
    let at = |s: f64| {
        let r = 1.0 - s;
        r * r * (1.0 + 2.0 * s) * a + s * r * r * u + s * s * (3.0 - 2.0 * s) * b - s * s * r * w
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if at(middle) > 0.0 { low = middle } else { high = middle }
    }
    pair[0].t + h * low
}

fn picture(trials: &[Trial<State<1>>]) -> Picture {
    let drawn = ["Leapfrog", "Implicit", "DiscreteGradient", "Kanatani"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        Some(Line::new(trial, trial.run.states().iter().map(|s| (s.t, s.q[0] / PI)).collect()))
    });
    Picture {
        name: "hard_summit",
        title: "A pendulum released 10⁻⁹ from the top, dt = 0.1".to_owned(),
        words: vec![
            "At rest near angle π it falls at t = 22.8, and at t = 45.6 stands near the other top, at −π, once more."
                .to_owned(),
            "Up to there all schemes agree; what comes then (back, or over) is decided by less than a rounding."
                .to_owned(),
        ],
        x: Scale::linear("time t", 0.0, 60.0),
        y: Scale::linear("angle / π", -2.2, 1.2),
        lines: lines.collect(),
        behind: None,
    }
}
