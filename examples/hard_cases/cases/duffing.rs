//! Chaos under a periodic force.

use dmech::models::Duffing;
use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, rounding, short};

/// Steps of the reference in a period of the force.
const FINE: u64 = 400;

pub(crate) fn case(length: Length) -> Case {
    let mut case = Case::new(
        "duffing",
        "Duffing's oscillator in two wells, driven into chaos",
        "Neighbouring motions part by a factor of about e in 7 units of time: each digit of the step is worth 16 units of time, and no scheme is right for ever.",
        "Every implicit scheme stays on the attractor, |q| < 1.6, and balances work and energy to rounding; higher order is right for longer, and a reference started 1e-12 aside is lost as late as that predicts.",
        &["largest q", "work−energy", "right until"],
    );
    let law = Duffing::default();
    let period = std::f64::consts::TAU / law.omega;
    let turns = length.of(100, 1000);
    let start = |aside: f64| State::new([0.5 + aside], [0.1]);
    let end = turns as f64 * period;
    let fine = |aside| Motion::until(law, start(aside), end, turns * FINE).by(Composed::order8(DiscreteGradient));
    let reference = fine(0.0);
    let lost = until(&reference, &fine(1e-12), 1);
    case.check("the neighbour at 1e-12 is lost no sooner than after 100", -lost, -100.0);
    case.check("the neighbour at 1e-12 is lost before 400", lost, 400.0);
    let mut sooner: Vec<f64> = Vec::new();
    for steps in [8, 40, 200] {
        let motion = Motion::until(law, start(0.0), end, turns * steps);
        let trials = every_scheme!(any: motion);
        for trial in &trials {
            let right = until(&reference, trial, (FINE / steps) as usize);
            measure(&mut case, trial, right);
            if steps == 200 {
                sooner.push(right);
            }
        }
        if steps == 40 {
            case.pictures.push(picture(&trials, &reference));
        }
    }
    // Explicit, Implicit, DiscreteGradient, then its compositions of order 4 and 6.
    case.check("order 2 is right for longer than order 4", sooner[2] - sooner[3], 0.0);
    case.check("order 4 is right for longer than order 6", sooner[3] - sooner[4], 0.0);
    case
}

/// When a motion is first 0.1 away from the reference, of which every n-th state is taken.
fn until(reference: &Trial<State<1>>, trial: &Trial<State<1>>, n: usize) -> f64 {
    let pairs = trial.run.states().iter().zip(reference.run.states().iter().step_by(n));
    let lost = pairs.into_iter().find(|(a, b)| (a.q[0] - b.q[0]).abs() > 0.1);
    lost.map_or(trial.run.last().t, |(a, _)| a.t)
}

fn measure(case: &mut Case, trial: &Trial<State<1>>, right: f64) {
    let Trial { scheme, dt, .. } = *trial;
    let largest = trial.states().map(|s| s.q[0].abs()).fold(0.0, f64::max);
    let work = trial.run.drift(Invariant::WorkEnergy).map_or(f64::NAN, |drift| drift.max_abs());
    case.row(trial, vec![short(largest), short(work), short(right)]);
    if scheme != "Explicit" {
        case.check(format!("{scheme} at dt = {dt}: largest"), largest, 1.6);
        case.check(format!("{scheme} at dt = {dt}: work"), work, rounding(trial.run.steps()));
    }
}

fn picture(trials: &[Trial<State<1>>], reference: &Trial<State<1>>) -> Picture {
    let points = |trial: &Trial<State<1>>| -> Vec<_> {
        trial.run.states().iter().take_while(|s| s.t <= 100.0).map(|s| (s.t, s.q[0])).collect()
    };
    let drawn = ["Implicit", "DiscreteGradient", "Composed(DiscreteGradient, Suzuki4)"];
    let find = |name: &&str| trials.iter().find(|trial| trial.scheme == *name);
    let lines = drawn.iter().filter_map(find).map(|trial| Line::new(trial, points(trial)));
    Picture {
        name: "hard_duffing",
        title: "Duffing's oscillator in chaos, 40 steps in a period of the force".to_owned(),
        words: vec![
            "Grey: a reference of order 8. The schemes part from it one after the other, the higher order later,"
                .to_owned(),
            "and stay on the same attractor, |q| < 1.6: a chaotic motion is right for a limited time only.".to_owned(),
        ],
        x: Scale::linear("time t", 0.0, 100.0),
        y: Scale::linear("position q", -1.8, 1.8),
        lines: lines.collect(),
        behind: Some(points(reference)),
    }
}
