//! Greenspan's vibrating string, computed again.
//!
//! ```text
//! cargo run --release --example string
//! ```
//!
//! 201 particles on a line, a hundredth apart, move up and down; neighbours pull each other with the tension
//! T₀ (1 + s + ε s²), s the slope between them, and all have weight. The ends are pinned. D. Greenspan ("New Forms of
//! Discrete Mechanics", 1971, §7) holds the string up in the middle, lets it go, and draws it every 40 steps of leap-frog.
//!
//! The program makes the same steps twice: with the tension as a force, as in the paper, and with the potential energy
//! that belongs to it. Where both round alike they are one motion. It shows the energy, which only the second can keep
//! exactly, and draws Figures 7.1 and 7.2.

#[path = "shared/picture.rs"]
mod picture;
#[path = "shared/section_7.rs"]
mod section_7;

use std::ops::RangeInclusive;
use std::path::PathBuf;

use dmech::prelude::*;
use picture::{Axis, BLUE, Drawn, GREEN, INK, OCHRE};
use section_7::{
    DT, Energies, PARTICLES, SPACING, SPRING, WEIGHT, asymmetry, difference, force_form, potential_form, tent,
};

/// The steps of the paper's figures, and those between two of its curves.
const STEPS: u64 = 520;
const BETWEEN: usize = 40;

fn main() -> Drawn {
    let [force, potential] = [force_form(STEPS)?, potential_form(STEPS)?];
    let exact = Simulation::scene(tent().chain(SPRING).field(WEIGHT)).scheme(DiscreteGradient).dt(DT).run(STEPS)?;
    shapes(&force, &potential);
    energies(&potential, &exact);
    println!("The report of the energy-exact run, println!(\"{{run}}\"):\n\n{exact}\n");
    println!("Pictures: {}", figure("figure_7_1.svg", "Figure 7.1: the string falls", &force, 0..=280)?.display());
    println!("          {}", figure("figure_7_2.svg", "Figure 7.2: the string rises", &force, 320..=520)?.display());
    println!("          {}", energy_errors(&potential, &exact)?.display());
    Ok(())
}

fn shapes(force: &Run<SceneState<1>>, potential: &Run<SceneState<1>>) {
    println!("{SHAPES}");
    for step in (0..=STEPS as usize).step_by(BETWEEN) {
        let (state, other) = (&force.states()[step], &potential.states()[step]);
        let heights: Vec<_> = [25, 50, 75, 100].iter().map(|&j: &usize| format!("{:>11.8}", state.q[j][0])).collect();
        println!("{step:>5} │ {} │ {:>9.0e} │ {:>9.0e}", heights.join(" "), asymmetry(state), difference(state, other));
    }
    println!("{TENT}");
}

fn energies(leapfrog: &Run<SceneState<1>>, exact: &Run<SceneState<1>>) {
    println!("{ENERGIES}");
    let [start, start_exact] = [leapfrog, exact].map(|run| Energies::of(&run.states()[0]).total());
    for step in (0..=STEPS as usize).step_by(BETWEEN) {
        let energies = Energies::of(&leapfrog.states()[step]);
        let Energies { kinetic, weight, springs } = energies;
        let error = energies.total() - start;
        let exact = Energies::of(&exact.states()[step]).total() - start_exact;
        println!("{step:>5} │ {kinetic:>9.5} {weight:>10.5} {springs:>9.5} │ {error:>10.6} │ {exact:>+10.0e}");
    }
    let [a, b] = [leapfrog, exact].map(|run| 1e-3 * run.report().elapsed().as_nanos() as f64 / STEPS as f64);
    println!("\n  time per step, recording included: Leapfrog {a:.1} µs, DiscreteGradient {b:.1} µs\n");
}

/// The string every 40 steps.
fn figure(name: &str, title: &str, run: &Run<SceneState<1>>, steps: RangeInclusive<usize>) -> Drawn<PathBuf> {
    let title = format!("{title}: 201 particles, Δt = 0.001, leap-frog, every {BETWEEN} steps");
    picture::save(name, [900, 700], |area| {
        let (x, y) =
            (Axis::linear("x (the paper's units)", 0.0..2.0), Axis::linear("y (the paper's units)", -1.6..1.2));
        let mut chart = picture::chart(area, &title, x, y, 10)?;
        let colours = [BLUE, OCHRE, GREEN].into_iter().cycle();
        for (step, colour) in steps.step_by(BETWEEN).zip(colours) {
            let state = &run.states()[step];
            let shape: Vec<_> = state.q.iter().enumerate().map(|(j, [y])| (j as f64 * SPACING, *y)).collect();
            let middle = shape[PARTICLES / 2];
            picture::line(&mut chart, shape, colour, 1.6)?;
            picture::label(&chart, middle, (0, -10), &format!("t{}", subscript(step)), INK)?;
        }
        Ok(())
    })
}

fn subscript(step: usize) -> String {
    let digit = |c: char| c.to_digit(10).and_then(|d| char::from_u32('₀' as u32 + d)).unwrap_or(c);
    step.to_string().chars().map(digit).collect()
}

/// The energy error of both schemes.
fn energy_errors(leapfrog: &Run<SceneState<1>>, exact: &Run<SceneState<1>>) -> Drawn<PathBuf> {
    picture::save("string_energy.svg", [900, 440], |area| {
        let title = "The energy of the string, Δt = 0.001";
        let (x, y) = (Axis::linear("steps", 0.0..STEPS as f64), Axis::linear("100 (E − E₀) / E₀", -0.14..0.02));
        let mut chart = picture::chart(area, title, x, y, 140)?;
        let mut names = Vec::new();
        for (run, colour) in [(leapfrog, OCHRE), (exact, GREEN)] {
            let start = Energies::of(&run.states()[0]).total();
            let errors = run.states().iter().map(|state| 100.0 * (Energies::of(state).total() / start - 1.0));
            let points: Vec<_> = errors.enumerate().map(|(step, error)| (step as f64, error)).collect();
            names.push((points[points.len() - 1], run.report().scheme(), colour));
            picture::line(&mut chart, points, colour, 1.6)?;
        }
        picture::name_ends(&chart, names)
    })
}

const SHAPES: &str = "
A heavy string of 201 particles: D. Greenspan's §7 (1971), computed again; T₀ = 20, ε = 0.01, m = 0.005, g = 32.2

The string, with the tension as a force                 │ y_j −     │ from the
 step │        y₂₅         y₅₀         y₇₅        y₁₀₀ │   y₂₀₀₋ⱼ │ potential
──────┼─────────────────────────────────────────────────┼───────────┼──────────";

const TENT: &str = "
  y₂₀₀₋ⱼ     the largest difference between mirrored particles
  potential  the largest difference from the run with the potential
             T₀ Δx [(w − 1) + (s w − asinh s)/2 + ε (w³/3 − w + 2/3)],  s = |Δy|/Δx,  w = √(1 + s²)
  The paper prints y = −x + 1 for the right half at the start; the tent of its figure is y = 2 − x.
";

const ENERGIES: &str = "\
The energy, by leap-frog: its parts and their sum less that of the start; and the same of DiscreteGradient
 step │   kinetic     weight   springs │      error │      exact
──────┼────────────────────────────────┼────────────┼───────────";
