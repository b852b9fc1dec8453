//! Hénon and Heiles at the energy of escape.

use dmech::models::HenonHeiles;
use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, short};

const LAW: HenonHeiles = HenonHeiles { lambda: 1.0 };

pub(crate) fn case(length: Length) -> Case {
    let mut case = Case::new(
        "henon_heiles",
        "Hénon and Heiles at the energy of escape, E = 1/6",
        "The chaotic orbit fills a triangle whose three corners are saddles of just this energy: with any energy too much it gets out there, and falls to infinity in a finite time.",
        "Whoever keeps the energy stays inside, at any step and for any time; whoever escapes ends with an error and not with NaN.",
        &["outside", "escapes at"],
    );
    let q = [0.0, -0.15];
    let rest = 2.0 * (LAW.escape_energy() - LAW.energy(q)) - 0.11 * 0.11;
    let start = State::new(q, [rest.sqrt(), 0.11]);
    let end = length.of(2000.0, 20_000.0);
    for dt in [0.05, 0.25, 0.5] {
        let motion = Motion::until(LAW, start, end, (end / dt) as u64);
        let trials = every_scheme!(positions: motion);
        for trial in &trials {
            let most = trial.states().map(outside).fold(0.0, f64::max);
            let escapes = trial.states().find(|s| outside(s) > 0.1).map_or(f64::NAN, |s| s.t);
            case.row(trial, vec![short(most), short(escapes)]);
            if trial.run.kept(Invariant::Energy) == Kept::Exact {
                // An energy that is 1e-15 too large opens the corners by the root of it.
                case.check(format!("{} at dt = {dt}: outside", trial.scheme), most, 1e-7);
            }
        }
        if dt == 0.5 {
            case.pictures.push(picture(&trials));
        }
    }
    case
}

/// How far a position is beyond the triangle with corners (0, 1), (±√3/2, −1/2), on which Φ = 1/6.
fn outside(state: &State<2>) -> f64 {
    let [x, y] = state.q;
    let side = 3.0_f64.sqrt() * x.abs();
    (-0.5 - y).max(0.5 * (y + side - 1.0))
}

fn picture(trials: &[Trial<State<2>>]) -> Picture {
    let corner = 0.5 * 3.0_f64.sqrt();
    let triangle = vec![(0.0, 1.0), (corner, -0.5), (-corner, -0.5), (0.0, 1.0)];
    let mut lines = Vec::new();
    for name in ["DiscreteGradient", "Kanatani", "Implicit"] {
        let Some(trial) = trials.iter().find(|trial| trial.scheme == name) else { continue };
        // The last of the motion: the way out, or as many steps inside.
        let states: Vec<_> = trial.run.states().iter().collect();
        let inside = states.iter().take_while(|s| s.q[0].hypot(s.q[1]) < 1.5).count();
        let shown = &states[inside.saturating_sub(120)..(inside + 1).min(states.len())];
        lines.push(Line::new(trial, shown.iter().map(|s| (s.q[0], s.q[1])).collect()));
    }
    Picture {
        name: "hard_henon_heiles",
        title: "Hénon and Heiles at E = 1/6, dt = 0.5: the last 120 steps".to_owned(),
        words: vec!["Grey: the triangle on which Φ = 1/6, with saddles in its corners; the exact motion stays inside for ever.".to_owned(), "DiscreteGradient stays inside. Kanatani and Implicit, whose energy errs, get out at a corner. Shown are its last 120 steps, from the dot on.".to_owned()],
        x: Scale::equal("x", -1.3, 1.3),
        y: Scale::equal("y", -0.8, 1.2),
        lines,
        behind: Some(triangle),
    }
}
