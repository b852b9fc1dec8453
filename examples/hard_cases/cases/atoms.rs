//! Two atoms head-on at ten times the thermal speed.

use dmech::models::LennardJones;
use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, rounding, short};

const LAW: LennardJones = LennardJones { epsilon: 1.0, sigma: 1.0 };
/// Ten times √(kT/m) at kT = ε.
const SPEED: f64 = 10.0;

pub(crate) fn case(_: Length) -> Case {
    let mut case = Case::new(
        "atoms",
        "Two Lennard-Jones atoms head-on at ten times the thermal speed",
        "Within a hundredth of a unit of time they run up a wall of r⁻¹²; a usual step of 0.005 takes them over a twentieth of a diameter, and one of 0.05 over half of it, to where the force is a thousand times what they can bear.",
        "The atoms separate with the speed they came with where the energy is kept, at any step and wherever the step meets the wall, and never pass through each other.",
        &["nearest", "speed", "worst of 32"],
    );
    for dt in [0.0005, 0.005, 0.02, 0.05] {
        let motion = |part: u32| {
            let start = State::new([3.0 + f64::from(part) / 32.0 * SPEED * dt], [-SPEED]);
            Motion { mass: MASS, ..Motion::until(LAW, start, 1.0, (1.0 / dt).round() as u64) }
        };
        let trials = every_scheme!(positions: motion(0));
        let mut worst: Vec<f64> = trials.iter().map(speed_error).collect();
        for part in 1..32 {
            let others = every_scheme!(positions: motion(part));
            for (worst, trial) in worst.iter_mut().zip(&others) {
                *worst = worst.max(speed_error(trial));
                sound(&mut case, trial);
            }
        }
        for (trial, worst) in trials.iter().zip(worst) {
            sound(&mut case, trial);
            let nearest = trial.states().map(|s| s.q[0]).fold(f64::MAX, f64::min);
            case.row(trial, vec![short(nearest), short(trial.run.last().v[0]), short(worst)]);
            if trial.run.kept(Invariant::Energy) == Kept::Exact {
                case.check(format!("{} at dt = {dt}: speed", trial.scheme), worst, rounding(trial.asked));
            }
        }
        if dt == 0.02 {
            case.pictures.push(picture(&trials));
        }
    }
    case
}

/// Of each other: half of that of an atom.
const MASS: f64 = 0.5;

/// By how much the last speed, of 10, differs from that which the energy gives it there.
fn speed_error(trial: &Trial<State<1>>) -> f64 {
    let (start, last) = (&trial.run.states()[0], trial.run.last());
    let gained = 2.0 / MASS * (LAW.energy(start.q[0]) - LAW.energy(last.q[0]));
    (last.v[0] - (SPEED * SPEED + gained).sqrt()).abs() / SPEED
}

fn sound(case: &mut Case, trial: &Trial<State<1>>) {
    let Trial { scheme, dt, .. } = *trial;
    if let Err(what) = trial.sound() {
        case.check(what, f64::NAN, 0.0);
    }
    if trial.exact_energy() {
        let nearest = trial.states().map(|s| s.q[0]).fold(f64::MAX, f64::min);
        // Where Φ alone is twice the energy.
        case.check(format!("{scheme} at dt = {dt}: nearest"), -nearest, -0.78);
    }
}

fn picture(trials: &[Trial<State<1>>]) -> Picture {
    let drawn = ["Explicit", "Leapfrog", "Implicit", "DiscreteGradient", "Kanatani"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        Some(Line::new(trial, trial.run.states().iter().take(26).map(|s| (s.t, s.v[0])).collect()))
    });
    Picture {
        name: "hard_atoms",
        title: "Two Lennard-Jones atoms head-on, dt = 0.02: the relative velocity".to_owned(),
        words: vec!["They come with relative velocity −10 and must part with +10 after t = 0.24.".to_owned(), "Explicit and Leapfrog throw them apart with 25 and 17; DiscreteGradient gives back the energy to the last digit.".to_owned()],
        x: Scale::linear("time t", 0.0, 0.5),
        y: Scale::linear("velocity v", -12.0, 28.0),
        lines: lines.collect(),
        behind: None,
    }
}
