//! Contact that is shorter than the step.

use dmech::models::Wall;
use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, rounding, short};

pub(crate) fn case(length: Length) -> Case {
    let mut case = Case::new(
        "wall",
        "A body dropped from the height 1 on a wall of stiffness 1e4 or 1e8, dt = 0.01",
        "The contact lasts 3 steps or 3 hundredths of a step, and the force has a kink where it begins.",
        "Whoever keeps the energy bounces to the height 1 and no higher, however short the contact; others gain or lose with every contact.",
        &["highest", "deepest"],
    );
    let end = length.of(50.0, 500.0);
    for k in [1e4, 1e8] {
        let law = Wall { k, pull: 1.0 };
        let motion = Motion::until(law, State::new([1.0], [0.0]), end, (100.0 * end) as u64);
        let trials = every_scheme!(positions: motion);
        for trial in &trials {
            let high = trial.states().map(|s| s.q[0]).fold(f64::MIN, f64::max);
            let low = trial.states().map(|s| s.q[0]).fold(f64::MAX, f64::min);
            // A position is rounded where the body comes from, up to h v above the wall, and the force where it goes to is up
            // to √(2kE) = √(2k): the energy of a contact is not defined more closely. A fall from 1 and back takes 2√2.
            let speed = 2.0_f64.sqrt();
            let contacts = end / (2.0 * speed) + 1.0;
            let blurred = f64::EPSILON * 0.01 * speed * (2.0 * k).sqrt() * contacts.sqrt();
            let keeps = trial.run.kept(Invariant::Energy) == Kept::Exact;
            let most = if keeps { rounding(trial.asked) + blurred } else { f64::INFINITY };
            case.row_within(trial, vec![short(high), short(low)], most);
            if keeps {
                case.check(format!("{} at k = {k}: highest", trial.scheme), high - 1.0, most);
                case.check(format!("{} at k = {k}: deepest", trial.scheme), -low, 1.01 * (2.0 / k).sqrt());
                case.check(format!("{} at k = {k}: last", trial.scheme), trial.asked as f64, trial.run.steps() as f64);
            }
        }
        if k == 1e8 {
            case.pictures.push(picture(&trials));
        }
    }
    case
}

fn picture(trials: &[Trial<State<1>>]) -> Picture {
    let drawn = ["Leapfrog", "Implicit", "DiscreteGradient"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        let shown = trial.run.states().iter().take_while(|s| s.t <= 15.0);
        Some(Line::new(trial, shown.map(|s| (s.t, s.q[0])).collect()))
    });
    Picture {
        name: "hard_wall",
        title: "A body dropped on a wall of stiffness 10⁸ at height 0, dt = 0.01".to_owned(),
        words: vec![
            "The exact motion bounces back to the height 1. A contact lasts 3 hundredths of a step:".to_owned(),
            "Leapfrog and Implicit are thrown out of the picture, DiscreteGradient comes to the height 1 each time."
                .to_owned(),
        ],
        x: Scale::linear("time t", 0.0, 15.0),
        y: Scale::linear("height", -0.1, 3.0),
        lines: lines.collect(),
        behind: None,
    }
}
