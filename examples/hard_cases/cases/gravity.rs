//! Three bodies under gravity: Burrau's, and the figure eight.

use dmech::prelude::*;

use super::trial::{Together, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, rounding, short};

/// −m_a m_b/r.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gravity;

#[dmech::law]
impl Gravity {
    #[pair]
    fn energy(&self, r: f64, ma: f64, mb: f64) -> f64 {
        -ma * mb / r
    }
}

pub(crate) fn pythagoras(length: Length) -> Case {
    let mut case = Case::new(
        "pythagoras",
        "The Pythagorean problem: masses 3, 4, 5 at rest opposite the sides 3, 4, 5 of a triangle, to t = 17",
        "Close encounters without end, the closest at t = 15.83 to 4e-4, after which the motion depends on every digit before. C. Burrau (1913) could not tell how it ends; V. Szebehely and C. F. Peters (Astron. J. 72 (1967) 876) found masses 4 and 5 in a binary and 3 escaping.",
        "Momentum, and angular momentum and energy where kept, stay whatever the step; the reference (order 8, dt = 2e-5) meets the encounter of 1967, where the mass 3 stands nearly still.",
        &["nearest", "at t", "speed of 3", "momentum", "ang. mom."],
    );
    let scene = Scene::new()
        .body(3.0, [1.0, 3.0], [0.0; 2])
        .body(4.0, [-2.0, -1.0], [0.0; 2])
        .body(5.0, [1.0, -1.0], [0.0; 2])
        .pairs(Gravity);
    let together = |dt: f64, record_every| Together {
        scene: scene.clone(),
        masses: vec![3.0, 4.0, 5.0],
        dt,
        steps: (17.0 / dt) as u64,
        record_every,
    };
    let mut drawn = Vec::new();
    for &dt in length.of(&[1e-3][..], &[1e-3, 1e-4]) {
        let motion = together(dt, 1);
        let trials = every_scheme!(positions: motion);
        for trial in &trials {
            encounter(&mut case, trial);
        }
        drawn = trials;
    }
    let reference = together(2e-5, 1).by(Composed::order8(Leapfrog));
    let [nearest, at, speed] = encounter(&mut case, &reference);
    // To the digits in which it is told.
    case.check("the reference: nearest 4e-4", (nearest - 4e-4).abs(), 0.5e-4);
    case.check("the reference: at t = 15.83", (at - 15.83).abs(), 0.005);
    case.check("the reference: mass 3 stands still, of the speed of the others", speed, 0.001);
    case.pictures.push(burrau(&reference, &drawn));
    case
}

/// Smallest distance, its time, and the speed of the first body then, of the largest.
fn encounter(case: &mut Case, trial: &Trial<SceneState<2>>) -> [f64; 3] {
    let distance = |s: &SceneState<2>, a: usize, b: usize| (s.q[a][0] - s.q[b][0]).hypot(s.q[a][1] - s.q[b][1]);
    let nearest = |s: &SceneState<2>| distance(s, 0, 1).min(distance(s, 1, 2)).min(distance(s, 2, 0));
    let closest = trial.states().min_by(|a, b| nearest(a).total_cmp(&nearest(b)));
    let Some(at) = closest else { return [f64::NAN; 3] };
    let speeds = [0, 1, 2].map(|body| at.v[body][0].hypot(at.v[body][1]));
    let moved = |invariant| trial.run.drift(invariant).map_or(f64::NAN, |drift| drift.max_abs());
    let [linear, angular] = [moved(Invariant::LinearMomentum), moved(Invariant::AngularMomentum)];
    case.row(trial, vec![short(nearest(at)), short(at.t), short(speeds[0]), short(linear), short(angular)]);
    momenta(case, trial, [linear, angular], speeds.into_iter().fold(0.0, f64::max));
    [nearest(at), at.t, speeds[0] / speeds.into_iter().fold(0.0, f64::max)]
}

/// Both momenta, where they are kept; their rounding is relative to what the bodies have each by themselves.
fn momenta(case: &mut Case, trial: &Trial<SceneState<2>>, moved: [f64; 2], speed: f64) {
    let Trial { scheme, dt, .. } = *trial;
    let fastest = (2.0 * trial.largest_kinetic_energy()).sqrt().max(speed);
    let reach = trial.states().flat_map(|s| s.q.iter()).map(|q| q[0].hypot(q[1])).fold(0.0, f64::max);
    let most = 5.0 * rounding(trial.run.steps()) * fastest;
    case.check(format!("{scheme} at dt = {dt}: momentum"), moved[0], most);
    if trial.run.kept(Invariant::AngularMomentum) == Kept::Exact {
        case.check(format!("{scheme} at dt = {dt}: angular momentum"), moved[1], most * reach);
    }
}

/// The fine motion over a coarse one.
fn burrau(reference: &Trial<SceneState<2>>, coarse: &[Trial<SceneState<2>>]) -> Picture {
    let path = |trial: &Trial<SceneState<2>>, every: usize| {
        let points = trial.run.states().iter().step_by(every);
        points.map(|s| (s.q[0][0], s.q[0][1])).take_while(|q| q.0.hypot(q.1) < 5.0).collect::<Vec<_>>()
    };
    let mut lines = vec![Line::new("reference", path(reference, 500))];
    for name in ["DiscreteGradient", "Leapfrog"] {
        if let Some(trial) = coarse.iter().find(|trial| trial.scheme == name) {
            lines.push(Line::new(name, path(trial, (0.01 / trial.dt) as usize)));
        }
    }
    Picture {
        name: "hard_pythagoras",
        title: format!("Burrau's problem: the mass 3 to t = 17, dt = {}", coarse[0].dt),
        x: Scale::equal("x", -1.0, 5.0),
        y: Scale::equal("y", -2.0, 3.2),
        lines,
    }
}

/// A. Chenciner and R. Montgomery, Ann. of Math. 152 (2000) 881; digits by C. Simó, quoted there.
const PERIOD: f64 = 6.325_913_98;

pub(crate) fn figure_eight(length: Length) -> Case {
    let mut case = Case::new(
        "figure_eight",
        "The figure eight of three equal masses, a hundred periods",
        "The orbit of A. Chenciner and R. Montgomery (2000) is stable, but barely: what a scheme adds to the motion must not lead out of it.",
        "The three return to their start, closer with the order of the scheme; momenta and energy stay to rounding where they are kept.",
        &["misses by", "momentum", "ang. mom."],
    );
    let (q, v) = ([0.97000436, -0.24308753], [-0.93240737, -0.86473146]);
    let half = [-0.5 * v[0], -0.5 * v[1]];
    let scene = Scene::new().body(1.0, q, half).body(1.0, [-q[0], -q[1]], half).body(1.0, [0.0; 2], v).pairs(Gravity);
    let turns = length.of(10, 100);
    for steps in [40, 200, 1000] {
        let (dt, asked) = (PERIOD / steps as f64, steps * turns);
        let motion = Together { scene: scene.clone(), masses: vec![1.0], dt, steps: asked, record_every: 1 };
        let trials = every_scheme!(positions: motion);
        for trial in &trials {
            let (first, last) = (&trial.run.states()[0], trial.run.last());
            let miss = |i: usize| (first.q[i][0] - last.q[i][0]).hypot(first.q[i][1] - last.q[i][1]);
            let miss = if trial.completed() { miss(0).max(miss(1)).max(miss(2)) } else { f64::NAN };
            let moved = |invariant| trial.run.drift(invariant).map_or(f64::NAN, |drift| drift.max_abs());
            let moved = [moved(Invariant::LinearMomentum), moved(Invariant::AngularMomentum)];
            case.row(trial, vec![short(miss), short(moved[0]), short(moved[1])]);
            momenta(&mut case, trial, moved, 0.0);
            if steps == 1000 && trial.run.report().order() > 2 {
                // The start is known to 5e-9, and periods add to what that leaves.
                case.check(format!("{} misses", trial.scheme), miss, 5e-8 * turns as f64);
            }
        }
        if steps == 40 {
            case.pictures.push(eight(&trials));
        }
    }
    case
}

fn eight(trials: &[Trial<SceneState<2>>]) -> Picture {
    let drawn = ["Leapfrog", "DiscreteGradient", "Composed(DiscreteGradient, Suzuki4)"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        let points = trial.run.states().iter().take(10 * 40 + 1);
        Some(Line::new(name, points.map(|s| (s.q[2][0], s.q[2][1])).collect()))
    });
    Picture {
        name: "hard_figure_eight",
        title: "The figure eight with 40 steps a period: one of the bodies for ten periods".to_owned(),
        x: Scale::equal("x", -1.5, 1.5),
        y: Scale::equal("y", -0.6, 0.6),
        lines: lines.collect(),
    }
}
