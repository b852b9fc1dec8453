//! Generated steps against hand-written loops, in one run.
//!
//! `cargo bench -p dmech-benches --bench schemes` prints nanoseconds per step: the best of many short runs, taken in turn, so that all
//! share the machine's good and bad moments; ratios are what counts. With `RUSTFLAGS="-C target-cpu=native"` both sides
//! use fused multiply-adds.
//!
//! `cargo bench -p dmech-benches --bench schemes -- --only NAME STEPS` runs one loop once, for counting instructions:
//! see `benches/instructions`.

use std::hint::black_box;
use std::time::Instant;

use dmech::models::{DampedPendulum, Kepler, Pendulum};
use dmech::prelude::*;
use dmech::{Error, Stepper};

mod twins;

/// A charge in a magnetic field that grows along its axis.
#[derive(Clone, Copy, Debug)]
struct Bottle {
    b0: f64,
    length: f64,
}

#[dmech::law]
impl Bottle {
    #[force]
    fn lorentz(&self, q: [f64; 3], v: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = q;
        let c = self.b0 / (self.length * self.length);
        let (bx, by, bz) = (-c * x * z, -c * y * z, self.b0 + c * z * z);
        [v[1] * bz - v[2] * by, v[2] * bx - v[0] * bz, v[0] * by - v[1] * bx]
    }
}

/// A loop of some steps that ends in a number, so that nothing is optimised away.
type Loop = Box<dyn FnMut(u64) -> f64>;

#[inline(never)]
fn advance<L: Law<D>, S: Scheme<Particle<L, D>>, const D: usize>(
    stepper: &mut Stepper<Particle<L, D>, S>,
    steps: u64,
) -> Result<(), Error> {
    stepper.advance(steps)
}

fn generated<L, S, const D: usize>(law: L, start: State<D>, dt: f64, scheme: S) -> Loop
where
    L: Law<D> + Copy + 'static,
    S: Scheme<Particle<L, D>> + Copy + 'static,
    S::Memory: 'static,
{
    let simulation = Simulation::new(black_box(law), black_box(start)).scheme(scheme).dt(black_box(dt));
    let mut stepper = simulation.stepper().expect("the bench starts from good input");
    Box::new(move |steps| {
        advance(&mut stepper, steps).expect("the orbit is resolved");
        stepper.q()[0]
    })
}

fn loops() -> Vec<(&'static str, &'static str, Loop)> {
    let (sun, dt) = (Kepler { gm: 1.0 }, 1e-3);
    let planet = State::new([0.5, 0.0], [0.0, 1.63]);
    let (pendulum, bob) = (Pendulum { k: 1.3 }, State::new([0.8], [0.0]));
    // The same law with a force that names the velocity, so weak that it still swings when all is timed.
    let damped = DampedPendulum { k: 1.3, alpha: 1e-4 };
    let bottle = Bottle { b0: 1.0, length: 3.0 };
    let charge = State::new([0.8, 0.0, 0.0], [0.0, 0.7, 0.4]);
    vec![
        ("kepler", "twin: leap-frog, √s·(1/s²)", twins::kepler_leapfrog(1.0, planet, dt)),
        ("kepler", "Leapfrog", generated(sun, planet, dt, Leapfrog)),
        ("kepler", "CompensatedLeapfrog", generated(sun, planet, dt, CompensatedLeapfrog)),
        ("kepler", "twin: leap-frog, 1/(s√s)", twins::kepler_leapfrog_naive(1.0, planet, dt)),
        ("kepler", "Explicit", generated(sun, planet, dt, Explicit)),
        ("kepler", "twin: trapezoid, Newton", twins::kepler_trapezoid(1.0, planet, dt)),
        ("kepler", "Implicit", generated(sun, planet, dt, Implicit)),
        ("kepler", "DiscreteGradient", generated(sun, planet, dt, DiscreteGradient)),
        ("kepler", "Kanatani", generated(sun, planet, dt, Kanatani)),
        ("pendulum", "twin: leap-frog", twins::pendulum_leapfrog(1.3, bob, dt)),
        ("pendulum", "Leapfrog", generated(pendulum, bob, dt, Leapfrog)),
        ("pendulum", "twin: explicit", twins::pendulum::pendulum_explicit(1.3, bob, dt)),
        ("pendulum", "Explicit", generated(pendulum, bob, dt, Explicit)),
        ("pendulum", "twin: trapezoid, Newton", twins::pendulum::pendulum_trapezoid(1.3, bob, dt)),
        ("pendulum", "Implicit", generated(pendulum, bob, dt, Implicit)),
        ("pendulum", "DiscreteGradient", generated(pendulum, bob, dt, DiscreteGradient)),
        ("bottle", "twin: Boris", twins::bottle::boris([1.0, 3.0], charge, 0.05)),
        ("bottle", "Boris", generated(bottle, charge, 0.05, Boris)),
        ("bottle", "DiscreteGradient", generated(bottle, charge, 0.05, DiscreteGradient)),
        ("damped", "twin: explicit", twins::pendulum::damped_pendulum_explicit((1.3, 1e-4), bob, dt)),
        ("damped", "Explicit", generated(damped, bob, dt, Explicit)),
        ("damped", "twin: trapezoid, Newton", twins::pendulum::damped_pendulum_trapezoid((1.3, 1e-4), bob, dt)),
        ("damped", "Implicit", generated(damped, bob, dt, Implicit)),
        ("damped", "DiscreteGradient", generated(damped, bob, dt, DiscreteGradient)),
    ]
}

/// The loop after a twin of the explicit or trapezoidal formulas, or of Boris's, goes where the twin goes. (Those of leap-frog start
/// without half a kick.)
fn twins_agree() {
    let ends: Vec<_> = loops().into_iter().map(|(of, name, mut run)| (of, name, run(1000))).collect();
    let mut compared = 0;
    for pair in ends.windows(2) {
        let [(of, twin, by_hand), (_, name, end)] = [pair[0], pair[1]];
        if ["twin: explicit", "twin: Boris"].contains(&twin) || twin.starts_with("twin: trapezoid") {
            assert!((end - by_hand).abs() < 1e-11, "{of}: {twin} ends at {by_hand}, {name} at {end}");
            compared += 1;
        }
    }
    assert_eq!(compared, 6);
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let mut loops = loops();
    if let Some(i) = arguments.iter().position(|a| a == "--only") {
        let (name, steps) = (&arguments[i + 1], arguments[i + 2].parse().expect("a number of steps"));
        let (law, scheme) = name.split_once('/').expect("LAW/SCHEME");
        let (_, _, run) = loops.iter_mut().find(|l| l.0 == law && l.1 == scheme).expect("a known loop");
        black_box(run(steps));
        return;
    }
    twins_agree();
    const STEPS: u64 = 20_000;
    let mut best = vec![f64::INFINITY; loops.len()];
    for _ in 0..100 {
        for ((_, _, run), best) in loops.iter_mut().zip(&mut best) {
            let clock = Instant::now();
            black_box(run(black_box(STEPS)));
            *best = best.min(clock.elapsed().as_nanos() as f64 / STEPS as f64);
        }
    }
    println!("\n{:<10} {:<28} {:>9} {:>9} {:>12}", "law", "loop", "ns/step", "× twin", "× leap-frog");
    let mut law = "";
    let (mut twin, mut leapfrog) = (f64::NAN, f64::NAN);
    for ((of, name, _), ns) in loops.iter().zip(best) {
        if *of != law {
            (law, twin, leapfrog) = (of, ns, f64::NAN);
        }
        if *name == "Leapfrog" {
            leapfrog = ns;
        }
        println!("{of:<10} {name:<28} {ns:>9.2} {:>9.3} {:>12.3}", ns / twin, ns / leapfrog);
    }
}
