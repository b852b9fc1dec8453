//! Three bodies under gravity: Burrau's, and the figure eight.

use dmech::models::pairs::Gravity;
use dmech::prelude::*;

use super::trial::{Recorded, Together, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Row, Scale, rounding, short};

const GRAVITY: Gravity = Gravity { g: 1.0 };

pub(crate) fn pythagoras(length: Length) -> Case {
    let mut case = Case::new(
        "pythagoras",
        "The Pythagorean problem: masses 3, 4, 5 at rest opposite the sides 3, 4, 5 of a triangle, to t = 17",
        "Close encounters without end, the closest at t = 15.83 to 4e-4, after which the motion depends on every digit before. C. Burrau (1913) could not tell how it ends; V. Szebehely and C. F. Peters (Astron. J. 72 (1967) 876) found masses 4 and 5 in a binary and 3 escaping.",
        "Momentum, and angular momentum and energy where kept, stay whatever the step; a reference of order 8, whose steps follow the nearest pair, meets the encounter of 1967, where the mass 3 stands nearly still, and ends as told then: by t = 65 the mass 3 escapes, 4 and 5 are bound.",
        &["nearest", "at t", "speed of 3", "momentum", "ang. mom."],
    );
    let scene = Scene::new()
        .body(3.0, [1.0, 3.0], [0.0; 2])
        .body(4.0, [-2.0, -1.0], [0.0; 2])
        .body(5.0, [1.0, -1.0], [0.0; 2])
        .pairs(GRAVITY);
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
    let [reference, finer] = [0.01, 0.005].map(fine);
    told(&mut case, &reference, &finer);
    case.pictures.push(burrau(&reference, &drawn));
    case
}

/// The whole motion to t = 65 by steps that follow the nearest pair: `part` of √(r³/(m_a + m_b)) each, of order 8.
fn fine(part: f64) -> Vec<SceneState<2>> {
    let at_rest = vec![[0.0; 2]; 3];
    let mut state = SceneState { t: 0.0, q: vec![[1.0, 3.0], [-2.0, -1.0], [1.0, -1.0]], v: at_rest };
    let mut states = vec![state.clone()];
    while state.t < 65.0 {
        let time = |a: usize, b: usize| (distance(&state, a, b).powi(3) / (MASSES[a] + MASSES[b])).sqrt();
        let dt = part * time(0, 1).min(time(1, 2)).min(time(2, 0));
        let scene = (0..3).fold(Scene::new(), |scene, i| scene.body(MASSES[i], state.q[i], state.v[i]));
        let stepper = Simulation::scene(scene.pairs(GRAVITY)).scheme(Composed::order8(Leapfrog)).dt(dt).stepper();
        let Ok(mut stepper) = stepper else { break };
        if stepper.advance(4).is_err() {
            break;
        }
        state = SceneState { t: state.t + 4.0 * dt, ..stepper.state() };
        states.push(state.clone());
    }
    states
}

/// What is known of the motion, of one computed with small steps and with smaller ones.
fn told(case: &mut Case, reference: &[SceneState<2>], finer: &[SceneState<2>]) {
    let closest = reference.iter().min_by(|a, b| nearest(a).total_cmp(&nearest(b)));
    let (Some(at), Some(last), Some(check)) = (closest, reference.last(), finer.last()) else { return };
    let speeds = [0, 1, 2].map(|body| at.v[body][0].hypot(at.v[body][1]));
    let energy = |state: &SceneState<2>| {
        let pair = |a: usize, b: usize| GRAVITY.energy(distance(state, a, b), MASSES[a], MASSES[b]);
        state.kinetic_energy(&MASSES) + pair(0, 1) + pair(1, 2) + pair(2, 0)
    };
    let largest = reference.iter().map(|state| state.kinetic_energy(&MASSES)).fold(0.0, f64::max);
    let error =
        reference.iter().map(|state| (energy(state) - energy(&reference[0])).abs()).fold(0.0, f64::max) / largest;
    let cells = [nearest(at), at.t, speeds[0], f64::NAN, f64::NAN].map(short).to_vec();
    let ended = format!("t = {}, steps that follow the nearest pair", short(last.t));
    case.rows.push(Row { scheme: "Composed(Leapfrog, SofroniouSpaletta8)", dt: f64::NAN, energy: error, cells, ended });
    // To the digits in which they are told.
    case.check("the reference: energy", error, 1e-10);
    case.check("the reference: nearest 4e-4", (nearest(at) - 4e-4).abs(), 0.5e-4);
    case.check("the reference: at t = 15.83", (at.t - 15.83).abs(), 0.005);
    case.check("the reference: the mass 3 stands still, of the speed of the others", speeds[0], 0.001 * speeds[1]);
    for (name, state) in [("reference", last), ("finer reference", check)] {
        case.check(format!("the {name}: to the end"), -state.t, -65.0);
        let [escape, bond] = escape(state);
        case.check(format!("the {name}: the mass 3 escapes with the energy"), -escape, 0.0);
        case.check(format!("the {name}: 4 and 5 stay bound with the energy"), bond, 0.0);
    }
}

/// The energy of the mass 3 against the other two, and that of these two, each per reduced mass.
fn escape(state: &SceneState<2>) -> [f64; 2] {
    let both = |x: &[[f64; 2]], k: usize| (4.0 * x[1][k] + 5.0 * x[2][k]) / 9.0;
    let apart = |x: &[[f64; 2]]| [x[0][0] - both(x, 0), x[0][1] - both(x, 1)];
    let between = |x: &[[f64; 2]]| [x[1][0] - x[2][0], x[1][1] - x[2][1]];
    let energy = |q: [f64; 2], v: [f64; 2], m: f64| 0.5 * (v[0] * v[0] + v[1] * v[1]) - m / q[0].hypot(q[1]);
    [energy(apart(&state.q), apart(&state.v), 12.0), energy(between(&state.q), between(&state.v), 9.0)]
}

const MASSES: [f64; 3] = [3.0, 4.0, 5.0];

fn distance(state: &SceneState<2>, a: usize, b: usize) -> f64 {
    (state.q[a][0] - state.q[b][0]).hypot(state.q[a][1] - state.q[b][1])
}

fn nearest(state: &SceneState<2>) -> f64 {
    distance(state, 0, 1).min(distance(state, 1, 2)).min(distance(state, 2, 0))
}

/// The smallest distance and its time, the speed of the first body then, and the momenta.
fn encounter(case: &mut Case, trial: &Trial<SceneState<2>>) {
    let closest = trial.states().min_by(|a, b| nearest(a).total_cmp(&nearest(b)));
    let Some(at) = closest else { return };
    let speeds = [0, 1, 2].map(|body| at.v[body][0].hypot(at.v[body][1]));
    let moved = |invariant| trial.run.drift(invariant).map_or(f64::NAN, |drift| drift.max_abs());
    let [linear, angular] = [moved(Invariant::LinearMomentum), moved(Invariant::AngularMomentum)];
    case.row(trial, vec![short(nearest(at)), short(at.t), short(speeds[0]), short(linear), short(angular)]);
    momenta(case, trial, [linear, angular], speeds.into_iter().fold(0.0, f64::max));
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
fn burrau(reference: &[SceneState<2>], coarse: &[Trial<SceneState<2>>]) -> Picture {
    let path = |states: &[SceneState<2>], every: usize| {
        let points = states.iter().step_by(every).take_while(|s| s.t <= 17.0);
        points.map(|s| (s.q[0][0], s.q[0][1])).collect::<Vec<_>>()
    };
    let mut lines = Vec::new();
    for name in ["DiscreteGradient", "Leapfrog"] {
        if let Some(trial) = coarse.iter().find(|trial| trial.scheme == name) {
            lines.push(Line::new(trial, path(trial.run.states(), (0.01 / trial.dt) as usize)));
        }
    }
    Picture {
        name: "hard_pythagoras",
        title: format!("Burrau's problem: the mass 3 to t = 17, dt = {}", coarse[0].dt),
        words: vec!["Grey: a reference of order 8 with steps that follow the nearest pair. Close encounters magnify every error:".to_owned(), "either scheme follows it at first and is elsewhere at the end.".to_owned()],
        x: Scale::equal("x", -0.5, 4.0),
        y: Scale::equal("y", -2.0, 3.2),
        lines,
        behind: Some(path(reference, 1)),
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
    )
    .resolved_to(0.15);
    let (q, v) = ([0.97000436, -0.24308753], [-0.93240737, -0.86473146]);
    let half = [-0.5 * v[0], -0.5 * v[1]];
    let scene = Scene::new().body(1.0, q, half).body(1.0, [-q[0], -q[1]], half).body(1.0, [0.0; 2], v).pairs(GRAVITY);
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
            let fine =
                Together { scene: scene.clone(), masses: vec![1.0], dt: PERIOD / 400.0, steps: 401, record_every: 1 };
            case.pictures.push(eight(&trials, fine.by(Composed::order6(Leapfrog)).run.states()));
        }
    }
    case
}

fn eight(trials: &[Trial<SceneState<2>>], exact: &[SceneState<2>]) -> Picture {
    let path = |states: &[SceneState<2>]| states.iter().map(|s| (s.q[2][0], s.q[2][1])).collect::<Vec<_>>();
    let drawn = ["Leapfrog", "DiscreteGradient", "Composed(DiscreteGradient, Suzuki4)"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        Some(Line::new(trial, path(&trial.run.states()[..trial.run.states().len().min(10 * 40 + 1)])))
    });
    Picture {
        name: "hard_figure_eight",
        title: "The figure eight with 40 steps a period: one of the bodies for ten periods".to_owned(),
        words: vec!["The exact orbit is the grey figure, again and again. Order 4 stays on it, Leapfrog beside it;".to_owned(), "DiscreteGradient, of order 2, keeps the energy and yet leaves the orbit: an exact energy is not an exact position.".to_owned()],
        x: Scale::equal("x", -1.5, 1.5),
        y: Scale::equal("y", -0.6, 0.6),
        lines: lines.collect(),
        behind: Some(path(exact)),
    }
}
