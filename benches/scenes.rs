//! Scenes of many bodies against hand-written loops, in one run.
//!
//! `cargo bench -p dmech-benches --bench scenes` prints the time of a step, or of a body and step, the best of many short runs, taken in
//! turn. With `RUSTFLAGS="-C target-cpu=native"` both sides use the widest registers and fused multiply-adds.
//! `cargo bench -p dmech-benches --bench scenes -- WORD` runs the scenes whose name contains the word.
//!
//! Hand-written loops of one scene must agree with each other before they are timed. The project's own start with half a
//! kick, which the twins leave out, so their numbers are others; the tests compare those.

use std::hint::black_box;
use std::time::Instant;

#[path = "twins/bodies.rs"]
mod bodies;
#[path = "twins/chain.rs"]
mod chain;
#[path = "twins/eight.rs"]
mod eight;
#[path = "twins/own.rs"]
mod own;
#[path = "twins/parallel.rs"]
mod parallel;

/// A loop of some steps that ends in a number, so that nothing is optimised away.
type Loop = Box<dyn FnMut(u64) -> f64>;

struct Scene {
    name: &'static str,
    /// What a time is divided by, besides the number of steps.
    bodies: usize,
    unit: &'static str,
    /// Steps of one timed run.
    steps: u64,
    runs: usize,
    loops: Box<dyn Fn() -> Vec<(&'static str, Loop)>>,
}

fn scenes() -> Vec<Scene> {
    let gravity = |name, n: usize, steps, runs| Scene {
        name,
        bodies: 1,
        unit: "µs/step",
        steps,
        runs,
        loops: Box::new(move || bodies::loops(n, 1e-4)),
    };
    let implicit = |name, n: usize, steps, runs| Scene {
        name,
        bodies: n,
        unit: "ns/body",
        steps,
        runs,
        loops: Box::new(move || chain::implicit(n, 1.1, 0.3, 0.05)),
    };
    let liquid = |name, n: usize, steps, runs| Scene {
        name,
        bodies: 4 * n.pow(3),
        unit: "ns/body",
        steps,
        runs,
        loops: Box::new(move || vec![("cut off at 2.5 by lists", own::liquid(n, 0.005))]),
    };
    vec![
        Scene {
            name: "figure eight",
            bodies: 1,
            unit: "ns/step",
            steps: 20_000,
            runs: 100,
            loops: Box::new(|| eight::loops(1e-3)),
        },
        Scene {
            name: "FPUT chain, 1024",
            bodies: 1024,
            unit: "ns/body",
            steps: 500,
            runs: 100,
            loops: Box::new(|| chain::loops(1024, 1.1, 0.3, 0.05)),
        },
        implicit("implicit chain, 1000", 1000, 100, 30),
        implicit("implicit chain, 100000", 100_000, 10, 8),
        gravity("gravity, 1000", 1000, 4, 50),
        gravity("gravity, 4000", 4000, 1, 20),
        liquid("liquid, 4000", 10, 40, 10),
        liquid("liquid, 32000", 20, 40, 4),
        liquid("liquid, 256000", 40, 20, 2),
    ]
}

/// The largest difference of the loops' numbers after a few steps, relative.
fn disagreement(scene: &Scene) -> f64 {
    let ends: Vec<f64> =
        (scene.loops)().iter_mut().filter(|(name, _)| name.starts_with("twin")).map(|(_, run)| run(20)).collect();
    ends.iter().map(|end| ((end - ends[0]) / ends[0]).abs()).fold(0.0, f64::max)
}

fn main() {
    let word = std::env::args().skip(1).find(|a| !a.starts_with('-')).unwrap_or_default();
    for scene in scenes().iter().filter(|s| s.name.contains(&word)) {
        let apart = disagreement(scene);
        assert!(apart < 1e-11, "{}: the loops differ by {apart:e}", scene.name);
        let mut loops = (scene.loops)();
        let mut best = vec![f64::INFINITY; loops.len()];
        for _ in 0..scene.runs {
            for ((_, run), best) in loops.iter_mut().zip(&mut best) {
                let clock = Instant::now();
                black_box(run(black_box(scene.steps)));
                *best = best.min(clock.elapsed().as_nanos() as f64 / scene.steps as f64);
            }
        }
        let per_unit = if scene.unit == "µs/step" { 1e-3 } else { 1.0 / scene.bodies as f64 };
        println!("\n{:<18} {:<34} {:>9} {:>9}", "scene", "loop", scene.unit, "× first");
        for ((name, _), ns) in loops.iter().zip(&best) {
            println!("{:<18} {name:<34} {:>9.3} {:>9.3}", scene.name, ns * per_unit, ns / best[0]);
        }
    }
}
