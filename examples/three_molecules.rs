//! Greenspan's three molecules, computed again.
//!
//! ```text
//! cargo run --release --example three_molecules
//! ```
//!
//! Three equal particles in the plane act on each other by −G/r² + H/r³ − α|v| along their separations. D. Greenspan
//! ("New Forms of Discrete Mechanics", 1971, §6) followed them for 15 000 steps of Δt = 0.01 by the implicit formulas, six
//! unknowns in each step, and drew the first 1700 in steps of 50. The run took "under 14 minutes".
//!
//! The program makes the same steps, prints positions beside the kinetic energy, tells how far the figures can be trusted,
//! and draws Figure 6.1. The positions of all 15 000 steps, every 50th, go into a table for other programs.

#[path = "shared/picture.rs"]
mod picture;
#[path = "shared/section_6.rs"]
mod section_6;

use std::path::PathBuf;

use dmech::prelude::*;
use picture::{Axis, BLUE, Drawn, GREEN, RED};
use section_6::{DT, LAW, Outcome, implicit, kinetic_energy, molecules};

/// The steps of the paper, those of its figure, and those between two of its positions.
const STEPS: u64 = 15_000;
const DRAWN: usize = 1700;
const BETWEEN: usize = 50;

fn main() -> Drawn {
    let run = implicit(Newton::predicted(), STEPS)?;
    positions(run.states());
    speeds(run.states());
    let paper = implicit(Newton::from_previous(), STEPS)?;
    trust(&run, &paper)?;
    work(&run, &paper);
    let table = picture::place("three_molecules.csv")?;
    every_fiftieth()?.save_csv(&table)?;
    println!("Table:   {} (all steps, every {BETWEEN}th)", table.display());
    println!("Picture: {}", figure_6_1(run.states())?.display());
    Ok(())
}

/// What the paper would have printed.
fn every_fiftieth() -> Outcome {
    Simulation::scene(molecules().pairs(LAW)).scheme(Implicit).dt(DT).record_every(BETWEEN as u64).run(STEPS)
}

fn positions(states: &[SceneState<2>]) {
    println!("{POSITIONS}");
    for step in (0..=DRAWN).step_by(2 * BETWEEN) {
        let state = &states[step];
        let columns: Vec<_> = state.q.iter().map(|[x, y]| format!("{x:>9.4} {y:>9.4}")).collect();
        println!("{step:>5} │ {} │ {:>9.0}", columns.join(" │ "), kinetic_energy(state));
    }
    println!("{DRIVEN}");
}

/// "The motion is marked by constant speeding up or slowing down by the individual particles."
fn speeds(states: &[SceneState<2>]) {
    println!("{SPEEDS}");
    for body in 0..3 {
        let speeds: Vec<f64> = states.iter().map(|state| state.v[body][0].hypot(state.v[body][1])).collect();
        let (slowest, fastest) = speeds.iter().fold((f64::MAX, 0.0_f64), |(low, high), &v| (low.min(v), high.max(v)));
        let turns = speeds.windows(3).filter(|v| (v[1] - v[0]) * (v[2] - v[1]) < 0.0).count();
        println!("P{}    │ {slowest:>8.2} {fastest:>9.2} │ {turns:>8}", body + 1);
    }
    let nearest = states.iter().flat_map(distances).fold(f64::MAX, f64::min);
    let farthest = states.iter().flat_map(distances).fold(0.0, f64::max);
    println!("\n  distances between {nearest:.2} and {farthest:.0}\n");
}

fn distances(state: &SceneState<2>) -> [f64; 3] {
    [(0, 1), (0, 2), (1, 2)].map(|(i, j)| {
        let (a, b) = (state.q[i], state.q[j]);
        (a[0] - b[0]).hypot(a[1] - b[1])
    })
}

/// How far two computations are apart that differ in rounding only, and two motions that start 10⁻⁸ apart.
fn trust(run: &Run<SceneState<2>>, paper: &Run<SceneState<2>>) -> Drawn {
    const SHIFT: f64 = 1e-8;
    let shifted = Scene::new()
        .body(section_6::MASS, [0.0, 100.0 + SHIFT], [0.0, -10.0])
        .body(section_6::MASS, [100.0, 0.0], [-10.0, 0.0])
        .body(section_6::MASS, [-100.0, 0.0], [1.0, 0.0]);
    let shifted = Simulation::scene(shifted.pairs(LAW)).scheme(Implicit).dt(DT).run(STEPS)?;
    println!("{TRUST}");
    for step in [50, 500, 1000, DRAWN, 3000, 5000, 10_000, STEPS as usize] {
        let from = |other: &Run<SceneState<2>>| largest_difference(&run.states()[step], &other.states()[step]);
        println!("{step:>6} │ {:>11.1e} │ {:>11.1e}", from(paper), from(&shifted));
    }
    println!("{CHAOS}");
    Ok(())
}

fn largest_difference(a: &SceneState<2>, b: &SceneState<2>) -> f64 {
    let pairs = a.q.as_flattened().iter().zip(b.q.as_flattened());
    pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

fn work(run: &Run<SceneState<2>>, paper: &Run<SceneState<2>>) {
    println!("{WORK}");
    for (guess, run) in [("predicted", run), ("previous position (the paper)", paper)] {
        let corrections = run.report().iterations() as f64 / run.report().steps() as f64;
        let elapsed = run.report().elapsed().as_secs_f64();
        let ratio = 14.0 * 60.0 / elapsed;
        println!("{guess:<29} │ {corrections:>11.2} │ {:>7.1} ms │ {:>9.0}", 1e3 * elapsed, ratio);
    }
    println!("\nThe report, println!(\"{{run}}\"): what the law does not keep is not listed\n\n{run}\n");
}

/// The three paths to step 1700, a dot every 50 steps, and letters at the same times.
fn figure_6_1(states: &[SceneState<2>]) -> Drawn<PathBuf> {
    picture::save("figure_6_1.svg", [960, 700], |area| {
        let title = "Figure 6.1: three molecules, 1700 implicit steps of 0.01; a dot every 50, a letter every 300 from A, the start";
        let mut chart = picture::equal_axes(
            area,
            title,
            Axis::linear("x (dimensionless)", -260.0..200.0),
            Axis::linear("y (dimensionless)", -25.0..-25.0),
            10,
        )?;
        let (mut lines, mut labels) = (Vec::new(), Vec::new());
        for (body, colour) in [BLUE, RED, GREEN].into_iter().enumerate() {
            let path: Vec<_> = states[..=DRAWN].iter().map(|state| (state.q[body][0], state.q[body][1])).collect();
            let dots: Vec<_> = path.iter().copied().step_by(BETWEEN).collect();
            let lettered = ('A'..).zip(path.iter().step_by(LETTERED));
            labels.extend(lettered.map(|(letter, &at)| (at, format!("{}{letter}", body + 1), colour)));
            lines.push(path.clone());
            picture::line(&mut chart, path, colour, 1.5)?;
            picture::dots(&mut chart, &dots, colour, 2.6)?;
        }
        picture::label_beside(&chart, &lines, &labels)
    })
}

/// Steps between two letters.
const LETTERED: usize = 300;

const POSITIONS: &str = "
Three molecules: D. Greenspan's §6 (1971), computed again; m = 10, G = H = 1, α = 0.08, Δt = 0.01, implicit

 step │       x₁        y₁ │       x₂        y₂ │       x₃        y₃ │   kinetic
──────┼─────────────────────┼─────────────────────┼─────────────────────┼──────────";

const DRIVEN: &str = "
  The paper calls −α|v| viscous damping. It acts along the separation, with the speed of the particle itself: an
  attraction that grows with the speed. It is not reciprocal and not dissipative, and the molecules gain energy from it.
";

const SPEEDS: &str = "\
Speeds over 15 000 steps
      │ slowest   fastest │ reversals
──────┼───────────────────┼──────────";

const TRUST: &str = "\
How far the positions can be trusted: the largest change of a coordinate when Newton starts from the previous position,
which rounds differently, and when a molecule starts 10⁻⁸ higher
  step │ by rounding │ by a shift
───────┼─────────────┼────────────";

const CHAOS: &str = "
  To step 1700, where the figure ends, the positions are those of the formulas; at 15 000 not a digit is.
";

const WORK: &str = "\
15 000 steps; the paper: \"under 14 minutes\" on a computer of 1971
                              │ corrections │            │ 14 minutes
Newton starts from            │      a step │       time │ are × more
──────────────────────────────┼─────────────┼────────────┼───────────";
