//! Orbits that are nearly straight lines.

use dmech::models::Kepler;
use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, rounding, short};

const SUN: Kepler = Kepler { gm: 1.0 };

/// Largest distance that an orbit from the apocentre 1 + e may reach: the apocentre, and a thousandth.
const FAR: f64 = 2.002;

pub(crate) fn case(length: Length) -> Case {
    let mut case = Case::new(
        "kepler",
        "Kepler orbits of eccentricity 0.99 and 0.9999, ten periods from the apocentre",
        "The body falls to within 1e-2 or 1e-4 of the sun and turns round there in 1e-3 or 1e-6 of a period: no fixed step is right both far out and there.",
        "A scheme that keeps the energy goes through with the energy and the angular momentum that it came with, and on a bound orbit, or it stops and says so; the others may throw the body out.",
        &["ang. mom.", "farthest"],
    )
    .resolved_to(1e-4);
    let mut paths = Vec::new();
    for e in [0.99, 0.9999] {
        for steps in length.of([200, 2000], [1000, 50_000]) {
            let start = State::new([-1.0 - e, 0.0], [0.0, -((1.0 - e) / (1.0 + e)).sqrt()]);
            let motion = Motion::until(SUN, start, 10.0 * SUN.period(1.0), 10 * steps);
            for trial in every_scheme!(positions: motion) {
                case.row(&trial, vec![short(turned(&trial)), short(farthest(&trial))]);
                kept(&mut case, &trial);
                if e == 0.99 && steps == length.of(200, 1000) {
                    paths.push(trial);
                }
            }
        }
    }
    case.pictures.push(picture(&paths));
    case
}

/// |L − L₀| over the largest |q||v|, which is what rounding is relative to.
fn turned(trial: &Trial<State<2>>) -> f64 {
    let lever = |s: &State<2>| s.q[0].hypot(s.q[1]) * s.v[0].hypot(s.v[1]);
    let largest = trial.states().map(lever).fold(0.0, f64::max);
    trial.run.drift(Invariant::AngularMomentum).map_or(f64::NAN, |drift| drift.max_abs() / largest)
}

fn farthest(trial: &Trial<State<2>>) -> f64 {
    trial.states().map(|s| s.q[0].hypot(s.q[1])).fold(0.0, f64::max)
}

fn kept(case: &mut Case, trial: &Trial<State<2>>) {
    let Trial { scheme, dt, .. } = *trial;
    if trial.run.kept(Invariant::AngularMomentum) == Kept::Exact {
        // Leap-frog rounds position and velocity in each of its stages, and carries nothing of that along.
        let most = 2.0 * rounding(trial.run.report().evaluations());
        case.check(format!("{scheme} at dt = {dt}: angular momentum"), turned(trial), most);
    }
    if trial.exact_energy() {
        case.check(format!("{scheme} at dt = {dt}: farthest"), farthest(trial), FAR);
    }
}

/// Orbits of one step length.
fn picture(trials: &[Trial<State<2>>]) -> Picture {
    let steps = (SUN.period(1.0) / trials[0].dt).round() as usize;
    let drawn = ["Leapfrog", "Implicit", "Kanatani", "DiscreteGradient"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        let near = trial.states().take(3 * steps);
        Some(Line::new(trial, near.map(|s| (s.q[0], s.q[1])).collect()))
    });
    Picture {
        name: "hard_kepler",
        title: format!(
            "Kepler orbit of eccentricity 0.99 from its apocentre, {steps} steps a period: three periods"
        ),
        words: vec!["The exact orbit is one narrow ellipse along y = 0, between the sun at (0, 0) and x = −1.99.".to_owned(), "DiscreteGradient stays bound with its energy, though its ellipse turns; Kanatani stays bound; Leapfrog and Implicit do not return.".to_owned()],
        x: Scale::equal("x", -2.1, 2.1),
        y: Scale::equal("y", -2.1, 2.1),
        lines: lines.collect(),
        behind: None,
    }
}
