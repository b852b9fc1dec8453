//! Friction that stops everything within a step.

use dmech::models::DampedPendulum;
use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, rounding, short};

pub(crate) fn case(_: Length) -> Case {
    let mut case = Case::new(
        "damping",
        "A pendulum in syrup: α h = 3 and 1e5, from 2 radians at speed 1",
        "The velocity is lost in a part of a step, and what follows creeps down to rest, in units of time for α = 30 and of a million for 1e6.",
        "An implicit scheme creeps as the motion does and its energy never grows, though at large α h the velocity changes sign at every step (the trapezoid damps it by 1 − 4/αh only); `Explicit` ends with an error or far out, never with NaN.",
        &["α h", "q at end", "error", "E rises by", "work−energy"],
    );
    for alpha in [30.0, 1e6] {
        let law = DampedPendulum { k: 1.0, alpha };
        let motion = Motion::until(law, State::new([2.0], [1.0]), 100.0, 1000);
        let trials = every_scheme!(any: motion);
        for trial in &trials {
            measure(&mut case, trial, alpha);
        }
        if alpha == 1e6 {
            case.pictures.push(picture(&trials));
        }
    }
    case
}

fn measure(case: &mut Case, trial: &Trial<State<1>>, alpha: f64) {
    let Trial { scheme, dt, .. } = *trial;
    let energies: Vec<_> = trial.states().map(|s| 0.5 * s.v[0] * s.v[0] - s.q[0].cos()).collect();
    let rise = energies.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    let last = trial.run.last();
    // α q′ = −sin q once the velocity is gone, which takes it v/α further; what is left out is of order 1/α².
    let exact = 2.0 * ((0.5 * (2.0 + 1.0 / alpha)).tan() * (-last.t / alpha).exp()).atan();
    let off = (last.q[0] - exact).abs();
    let work = trial.run.drift(Invariant::WorkEnergy).map_or(f64::NAN, |drift| drift.max_abs());
    let alpha_h = alpha * dt;
    case.row(trial, vec![short(alpha_h), short(last.q[0]), short(off), short(rise), short(work)]);
    if scheme != "Explicit" {
        let name = format!("{scheme} at α h = {alpha_h}");
        case.check(format!("{name}: error"), off, 10.0 / (alpha * alpha) + 4.0 / alpha);
        case.check(format!("{name}: rise of the energy"), rise, 4.0 * f64::EPSILON);
        // The balance is of forces α v, which are larger than their work by α h.
        case.check(format!("{name}: work"), work, rounding(trial.run.steps()) * (1.0 + alpha_h));
    }
}

fn picture(trials: &[Trial<State<1>>]) -> Picture {
    let drawn = ["Implicit", "DiscreteGradient", "Composed(DiscreteGradient, Suzuki4)"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        let speeds = trial.run.states().iter().step_by(10);
        Some(Line::new(trial, speeds.map(|s| (s.t, s.v[0].abs().log10())).collect()))
    });
    Picture {
        name: "hard_damping",
        title: "A pendulum in syrup from 2 radians at speed 1, α h = 10⁵: the speed".to_owned(),
        words: vec![
            "Grey: the exact speed, 10⁻⁶. Each implicit step turns the velocity round and damps it by 1 − 4/αh only:"
                .to_owned(),
            "the body creeps rightly in the mean while its speed stays near that of the start.".to_owned(),
        ],
        x: Scale::linear("time t", 0.0, 100.0),
        y: Scale::powers("speed |v|", -7.0, 1.0),
        lines: lines.collect(),
        // α v = −sin q, and q hardly moves from 2.
        behind: Some([0.0, 100.0].map(|t| (t, (2.0_f64.sin() / 1e6).log10())).to_vec()),
    }
}
