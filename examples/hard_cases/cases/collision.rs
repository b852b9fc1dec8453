//! Head-on into a softened centre.

use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, rounding, short};

/// Φ(q) = −g/|q| + h/|q|³: attraction that turns into repulsion near the centre.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Softened {
    pub(crate) g: f64,
    pub(crate) h: f64,
}

#[dmech::law]
impl Softened {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        let r = (x * x + y * y).sqrt();
        -self.g / r + self.h / (r * r * r)
    }
}

const LAW: Softened = Softened { g: 1.0, h: 1e-6 };

pub(crate) fn case(length: Length) -> Case {
    let mut case = Case::new(
        "collision",
        "Head-on collision, softened: Φ = −1/r + 1e-6/r³, from rest at r = 1",
        "The body turns round at r = 0.001, where the force is a million times that at the start and lasts 1e-5 of the time.",
        "A scheme that keeps the energy never leaves the sphere that it started from, and none leaves the line; where the turn is not resolved the run stops and says so.",
        &["nearest", "farthest", "bounces", "off line"],
    )
    .resolved_to(9e-4);
    // Along a line that is not an axis.
    let start = State::new([0.6, 0.8], [0.0, 0.0]);
    for steps in length.of([1000, 10_000], [1000, 200_000]) {
        let motion = Motion::until(LAW, start, 10.0, steps);
        let trials = every_scheme!(positions: motion);
        for trial in &trials {
            measure(&mut case, trial);
        }
        if steps != 1000 {
            case.pictures.push(picture(&trials));
        }
    }
    case
}

fn distance(state: &State<2>) -> f64 {
    state.q[0].hypot(state.q[1])
}

fn measure(case: &mut Case, trial: &Trial<State<2>>) {
    let distances: Vec<_> = trial.run.states().iter().map(distance).collect();
    let off = trial.states().map(|s| (0.8 * s.q[0] - 0.6 * s.q[1]).abs()).fold(0.0, f64::max);
    let near = distances.iter().fold(f64::MAX, |a, b| a.min(*b));
    let far = distances.iter().fold(0.0_f64, |a, b| a.max(*b));
    let bounces = distances.windows(3).filter(|w| w[1] < w[0] && w[1] < w[2]).count();
    case.row(trial, vec![short(near), short(far), bounces.to_string(), short(off / far)]);
    let Trial { scheme, dt, .. } = *trial;
    if trial.exact_energy() {
        case.check(format!("{scheme} at dt = {dt}: farthest"), far, 1.0 + rounding(trial.run.steps()));
        // A rounding at the centre turns the line by as much as it is of the nearest distance.
        let most = rounding(trial.run.steps()) / near;
        case.check(format!("{scheme} at dt = {dt}: off the line"), off, most);
    }
}

fn picture(trials: &[Trial<State<2>>]) -> Picture {
    let every = trials[0].asked as usize / 1000;
    let drawn = ["Leapfrog", "Implicit", "DiscreteGradient", "Composed(DiscreteGradient, Suzuki4)"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        let shown = trial.states().enumerate().filter(|(k, s)| k % every == 0 || distance(s) < 0.01);
        Some(Line::new(trial, shown.map(|(_, s)| (s.t, distance(s))).collect()))
    });
    Picture {
        name: "hard_collision",
        title: format!("Head-on into a softened centre, Φ = −1/r + 10⁻⁶/r³, from rest at r = 1, dt = {}", trials[0].dt),
        words: vec!["The exact motion falls from r = 1 to r = 0.001 and back, again and again, in periods of 2.22.".to_owned(), "Where the turn is not resolved, only DiscreteGradient and its compositions come back to r = 1 and no farther.".to_owned()],
        x: Scale::linear("time t", 0.0, 10.0),
        y: Scale::linear("distance r", 0.0, 2.0),
        lines: lines.collect(),
        behind: None,
    }
}
