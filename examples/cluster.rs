//! Thirteen atoms, released from a compressed icosahedron.
//!
//! ```text
//! cargo run --release --example cluster
//! ```
//!
//! Atoms of a noble gas attract and repel each other by 4 (r⁻¹² − r⁻⁶), in units of Lennard-Jones. Thirteen of them are
//! bound most strongly as an icosahedron, one in the middle and twelve about it, with the energy −44.3268 (M. R. Hoare and
//! P. Pal, Adv. Phys. 20 (1971) 161). The program makes the icosahedron a twentieth smaller, lets go, and follows the cluster
//! by leap-frog and by the energy-exact `DiscreteGradient` at small and large steps.
//!
//! The steep repulsion is what limits the step. The program shows what becomes of the energy, and beside it what an exact
//! energy does not promise: that the atoms are in the right place.

#[path = "shared/picture.rs"]
mod picture;

use std::path::PathBuf;

use dmech::models::pairs::LennardJones;
use dmech::prelude::*;
use picture::{Axis, Drawn, GREEN, INK, OCHRE};

/// 4 (r⁻¹² − r⁻⁶).
const ATOMS: LennardJones = LennardJones { epsilon: 1.0, sigma: 1.0 };
/// Where the motion ends.
const END: f64 = 40.0;
/// The size of the icosahedron at the start, of that at rest.
const COMPRESSION: f64 = 0.95;
const STEPS: [f64; 4] = [0.0025, 0.01, 0.02, 0.04];
/// The small and the large step of the pictures, and where they end.
const DRAWN: [f64; 2] = [0.0025, 0.02];
const DRAWN_END: f64 = 4.0;

/// An atom in the middle and twelve around it at the distance 1.
fn icosahedron() -> [[f64; 3]; 13] {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let (short, long) = (1.0 / golden.hypot(1.0), golden / golden.hypot(1.0));
    let mut atoms = [[0.0; 3]; 13];
    let signs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
    for (i, atom) in atoms[1..].iter_mut().enumerate() {
        let (sign, other) = signs[i / 3];
        atom[(i + 1) % 3] = sign * short;
        atom[(i + 2) % 3] = other * long;
    }
    atoms
}

fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2])
}

fn distances(atoms: &[[f64; 3]]) -> impl Iterator<Item = f64> {
    atoms.iter().enumerate().flat_map(|(i, a)| atoms[..i].iter().map(move |b| distance(a, b)))
}

fn potential(atoms: &[[f64; 3]]) -> f64 {
    distances(atoms).map(|r| ATOMS.energy(r)).sum()
}

/// The size R of the icosahedron at rest: Σ 4 ((R d)⁻¹² − (R d)⁻⁶) is smallest at R⁶ = 2 Σ d⁻¹²/Σ d⁻⁶.
fn size_at_rest() -> f64 {
    let sum = |power: i32| distances(&icosahedron()).map(|d| d.powi(-power)).sum::<f64>();
    (2.0 * sum(12) / sum(6)).powf(1.0 / 6.0)
}

fn cluster(size: f64) -> Scene<3> {
    let mut scene = Scene::new();
    for atom in icosahedron() {
        scene = scene.body(1.0, atom.map(|x| size * x), [0.0; 3]);
    }
    scene
}

type Outcome = Result<Run<SceneState<3>>, Interrupted<SceneState<3>>>;

/// States 0.01 apart, or a step if that is longer.
fn leapfrog(dt: f64) -> Outcome {
    let simulation = Simulation::scene(cluster(COMPRESSION * size_at_rest()).pairs(ATOMS)).scheme(Leapfrog);
    simulation.dt(dt).record_every((0.01 / dt).round().max(1.0) as u64).run_until(END)
}

fn discrete_gradient(dt: f64) -> Outcome {
    let scene = cluster(COMPRESSION * size_at_rest()).pairs(ATOMS);
    let simulation = Simulation::scene(scene).scheme(DiscreteGradient);
    simulation.dt(dt).record_every((0.01 / dt).round().max(1.0) as u64).run_until(END)
}

fn main() -> Drawn {
    let rest = size_at_rest();
    let at = |size: f64| potential(&icosahedron().map(|atom| atom.map(|x| size * x)));
    println!("{START}");
    println!("at rest      │ {rest:>8.6} │ {:>12.6}", at(rest));
    println!("at the start │ {:>8.6} │ {:>12.6}", COMPRESSION * rest, at(COMPRESSION * rest));
    println!("{ENERGIES}");
    let runs = STEPS.map(|dt| [leapfrog(dt), discrete_gradient(dt)]);
    for outcome in runs.iter().flatten() {
        match outcome {
            Ok(run) => line(run),
            Err(interrupted) => println!("{interrupted}"),
        }
    }
    println!("{NOTES}");
    let exact = discrete_gradient(STEPS[2])?;
    println!("The report at dt = {}, println!(\"{{run}}\"):\n\n{exact}\n", STEPS[2]);
    println!("Pictures: {}", energies()?.display());
    println!("          {}", sizes()?.display());
    Ok(())
}

fn line(run: &Run<SceneState<3>>) {
    let report = run.report();
    let error = run.drift(Invariant::Energy).map_or(f64::NAN, |drift| drift.max_abs());
    let angular = run.drift(Invariant::AngularMomentum).map_or(f64::NAN, |drift| drift.max_abs());
    let corrections = report.iterations() as f64 / report.steps() as f64;
    let per_step = 1e6 * report.elapsed().as_secs_f64() / report.steps() as f64;
    println!(
        "{:<6} {:<16} │ {error:>8.0e} {angular:>8.0e} │ {:>9.5} {:>10.1} │ {corrections:>11.2} {per_step:>8.2}",
        report.dt(),
        report.scheme(),
        period(run.states()),
        symmetric_until(run.states())
    );
}

/// The mean time between moments, early on, at which the cluster, growing, is as large as at rest.
fn period(states: &[SceneState<3>]) -> f64 {
    let rest = size_at_rest();
    let early = states.windows(2).take_while(|pair| pair[1].t <= DRAWN_END);
    let crossings = early.filter_map(|pair| {
        let [before, after] = [size(&pair[0]) - rest, size(&pair[1]) - rest];
        let part = before / (before - after);
        (before < 0.0 && after >= 0.0).then(|| pair[0].t + part * (pair[1].t - pair[0].t))
    });
    let crossings: Vec<f64> = crossings.collect();
    match crossings[..] {
        [first, .., last] => (last - first) / (crossings.len() - 1) as f64,
        _ => f64::NAN,
    }
}

/// When the distances of the twelve from the one in the middle begin to differ by a hundredth.
fn symmetric_until(states: &[SceneState<3>]) -> f64 {
    let spread = |state: &SceneState<3>| {
        let distances = state.q[1..].iter().map(|atom| distance(atom, &state.q[0]));
        let (low, high) = distances.fold((f64::MAX, 0.0), |(low, high), r| (f64::min(low, r), f64::max(high, r)));
        high - low
    };
    states.iter().find(|state| spread(state) > 0.01).map_or(f64::NAN, |state| state.t)
}

/// The mean distance of the twelve from the one in the middle.
fn size(state: &SceneState<3>) -> f64 {
    state.q[1..].iter().map(|atom| distance(atom, &state.q[0])).sum::<f64>() / 12.0
}

fn energy(state: &SceneState<3>) -> f64 {
    potential(&state.q) + 0.5 * state.v.as_flattened().iter().map(|v| v * v).sum::<f64>()
}

/// The energy by both schemes, above at a small step and below at a large one.
fn energies() -> Drawn<PathBuf> {
    picture::save("cluster_energy.svg", [960, 760], |area| {
        for (panel, dt) in area.split_evenly((2, 1)).iter().zip(DRAWN) {
            let runs = [(OCHRE, leapfrog(dt)?), (GREEN, discrete_gradient(dt)?)];
            let errors = runs.each_ref().map(|(_, run)| {
                let start = energy(&run.states()[0]);
                let points = run.states().iter().map(|state| (state.t, 1e3 * (energy(state) - start)));
                points.take_while(|point| point.0 <= DRAWN_END).collect::<Vec<_>>()
            });
            let all = errors.iter().flatten().map(|point| point.1);
            let (low, high) = all.fold((0.0, 0.0), |(low, high), x| (f64::min(low, x), f64::max(high, x)));
            let margin = 0.1 * (high - low);
            let (x, y) = (
                Axis::linear("time (units of Lennard-Jones)", 0.0..DRAWN_END),
                Axis::linear("1000 (E − E₀) / ε", low - margin..high + margin),
            );
            let mut chart = picture::chart(panel, &format!("Thirteen atoms: energy at dt = {dt}"), x, y, 150)?;
            let mut names = Vec::new();
            for ((colour, run), points) in runs.iter().zip(errors) {
                names.push((points[points.len() - 1], run.report().scheme(), *colour));
                picture::line(&mut chart, points, *colour, 1.6)?;
            }
            picture::name_ends(&chart, names)?;
        }
        Ok(())
    })
}

/// The size of the cluster at a small step and, by both schemes, at a large one.
fn sizes() -> Drawn<PathBuf> {
    let [small, large] = DRAWN;
    let runs = [(INK, leapfrog(small)?), (OCHRE, leapfrog(large)?), (GREEN, discrete_gradient(large)?)];
    picture::save("cluster_size.svg", [960, 480], |area| {
        let title = "Thirteen atoms: the mean distance from the middle";
        let (x, y) =
            (Axis::linear("time (units of Lennard-Jones)", 0.0..DRAWN_END), Axis::linear("distance / σ", 1.0..1.2));
        let mut chart = picture::chart(area, title, x, y, 220)?;
        let labels = runs.each_ref().map(|(_, run)| format!("{}, dt = {}", run.report().scheme(), run.report().dt()));
        let mut names = Vec::new();
        for ((colour, run), label) in runs.iter().zip(&labels) {
            let points = run.states().iter().map(|state| (state.t, size(state)));
            let points: Vec<_> = points.take_while(|point| point.0 <= DRAWN_END).collect();
            names.push((points[points.len() - 1], label.as_str(), *colour));
            picture::line(&mut chart, points, *colour, 1.6)?;
        }
        picture::name_ends(&chart, names)
    })
}

const START: &str = "
Thirteen Lennard-Jones atoms, m = 1; an icosahedron a twentieth smaller than at rest, let go

             │   size   │    energy
─────────────┼──────────┼─────────────";

const ENERGIES: &str = "
To t = 40
                        │ largest error of  │ period of  symmetric │ corrections       µs
dt     scheme           │ energy    L       │ breathing  until t = │      a step   a step
────────────────────────┼───────────────────┼──────────────────────┼─────────────────────";

const NOTES: &str = "
  L          the angular momentum, 0 at the start
  period     between moments, up to t = 4, at which the cluster, growing, is as large as at rest. Both schemes make an
             error of order two in it: for small swings −(ωh)²/24 of it by leap-frog, +(ωh)²/12 by DiscreteGradient
  symmetric  the icosahedron breathes as a whole until rounding, which this motion magnifies, has broken its symmetry:
             the twelve distances from the middle then differ by 0.01
";
