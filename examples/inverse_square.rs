//! What Kanatani's scheme keeps under the inverse square law: his second example, with a factor set right.
//!
//! ```text
//! cargo run --release --example inverse_square
//! ```
//!
//! Under Φ(r) = −k/|r| the scheme's force is not k/r² at the present position but
//!
//! ```text
//! f = −k n̄/r̄²,   r̄² = |r₊| |r₋|,   n̄ = (r₊ + r₋)/(|r₊| + |r₋|)                              (3.25)–(3.27)
//! ```
//!
//! which is the discrete gradient −∇̄Φ(r₋, r₊): it does exactly the work Φ(r₋) − Φ(r₊) on the way from r₋ to r₊. dmech
//! finds it from the potential. With z = (r − r₋)/h it follows that
//!
//! ```text
//! m z²/2 − k (1/|r| + 1/|r₋|)/2 = const.                                                      (3.28)
//! ```
//!
//! where the paper prints 1/4 in place of 1/2; its own definition (3.9) gives 1/2. The program follows Greenspan's
//! planet, prints both quantities and the angular momentum over 100 000 steps, and shows what is *not* kept: the orbit turns.
//!
//! K. Kanatani, "The Accuracy and the Preservation Property of the Discrete Mechanics", J. Comput. Phys. (1983–84).

#[path = "shared/picture.rs"]
mod picture;

use dmech::models::Kepler;
use dmech::prelude::*;
use picture::{Axis, BLUE, Drawn, GREEN, INK, OCHRE, PALE, RED};

/// The inverse square law Φ(q) = −k/|q|; k is called gm there.
const SUN: Kepler = Kepler { gm: 1.0 };
const START: State<2> = State::new([0.5, 0.0], [0.0, 1.63]);
/// Of the exact motion.
const PERIOD: f64 = 4.036615;

fn main() -> Drawn {
    println!("{FIRST_STEPS}");
    first_steps(0.1)?;
    println!("{KEPT}");
    what_is_kept(0.02)?;
    println!("{TURNING}");
    for dt in [0.04, 0.02, 0.01] {
        let turn = turning(dt)?;
        println!("  {dt:>5} │ {turn:>8.4}° {:>13.0}°", turn / (dt * dt));
    }
    println!("\nPicture: {}", draw()?.display());
    Ok(())
}

type Planet = Stepper<Particle<Kepler, 2>, Kanatani>;

fn planet(dt: f64) -> Result<Planet, Error> {
    Simulation::new(SUN, START).scheme(Kanatani).dt(dt).stepper()
}

/// m z²/2 and −k (1/|r| + 1/|r₋|), with m = 1.
fn kinetic_and_potential(planet: &Planet) -> (f64, f64) {
    let memory = planet.memory();
    let [x, y] = memory.z();
    (0.5 * (x * x + y * y), SUN.energy(memory.q()) + SUN.energy(memory.q_before()))
}

/// (3.28) with 1/2, (3.28) with the printed 1/4, and r × z (3.11).
fn candidates(planet: &Planet) -> [f64; 3] {
    let (kinetic, potential) = kinetic_and_potential(planet);
    let ([x, y], [zx, zy]) = (planet.q(), planet.memory().z());
    [kinetic + potential / 2.0, kinetic + potential / 4.0, x * zy - y * zx]
}

fn first_steps(dt: f64) -> Drawn {
    let mut planet = planet(dt)?;
    for i in 0..=6 {
        let ([x, y], [zx, zy]) = (planet.q(), planet.memory().z());
        let [half, quarter, _] = candidates(&planet);
        println!("  {i} {:>4.1} │ {x:>9.6} {y:>9.6} │ {zx:>9.6} {zy:>9.6} │ {half:>16.13} {quarter:>9.6}", planet.t());
        planet.step()?;
    }
    Ok(())
}

/// The largest relative change so far of each candidate.
fn what_is_kept(dt: f64) -> Drawn {
    let mut planet = planet(dt)?;
    let start = candidates(&planet);
    let mut largest = [0.0_f64; 3];
    for steps in [100, 1_000, 10_000, 100_000] {
        while planet.steps() < steps {
            planet.step()?;
            let now = candidates(&planet);
            largest = [0, 1, 2].map(|i| largest[i].max((now[i] / start[i] - 1.0).abs()));
        }
        let [half, quarter, momentum] = largest;
        println!("  {steps:>7} │ {half:>9.0e} {quarter:>9.2} {momentum:>9.0e}");
    }
    println!();
    Ok(())
}

/// By how many degrees the orbit turns in a revolution, over 80 of them.
fn turning(dt: f64) -> Drawn<f64> {
    let run = Simulation::new(SUN, START).scheme(Kanatani).dt(dt).run_until(80.0 * PERIOD)?;
    let mut turned = 0.0;
    for pair in run.states().windows(2) {
        let [before, after] = [pericentre(&pair[0]), pericentre(&pair[1])];
        turned += (before[0] * after[1] - before[1] * after[0]).atan2(before[0] * after[0] + before[1] * after[1]);
    }
    Ok(turned.to_degrees() / 80.0)
}

/// The vector of Laplace, v × L − k r/|r|: it points to the pericentre, and would stand still in exact motion.
fn pericentre(State { q: [x, y], v: [vx, vy], .. }: &State<2>) -> [f64; 2] {
    let momentum = x * vy - y * vx;
    let r = x.hypot(*y);
    [vy * momentum - SUN.gm * x / r, -vx * momentum - SUN.gm * y / r]
}

/// Left: 60 revolutions at h = 0.04, the first of them dark. Right: (3.28) and its parts at h = 0.02.
fn draw() -> Drawn<std::path::PathBuf> {
    let run = Simulation::new(SUN, START).scheme(Kanatani).dt(0.04).run(101 * 60)?;
    let path: Vec<_> = run.states().iter().map(|state| (state.q[0], state.q[1])).collect();
    let mut planet = planet(0.02)?;
    let mut curves = [const { Vec::new() }; 4];
    while planet.t() < 9.0 {
        let (kinetic, potential) = kinetic_and_potential(&planet);
        let values = [kinetic, potential / 2.0, kinetic + potential / 2.0, kinetic + potential / 4.0];
        for (curve, value) in curves.iter_mut().zip(values) {
            curve.push((planet.t(), value));
        }
        planet.step()?;
    }
    picture::save("inverse_square.svg", [1200, 560], |area| {
        let (left, right) = area.split_horizontally(560 * 4);
        let [x, y] = ["x (dimensionless)", "y (dimensionless)"].map(|name| Axis::linear(name, -1.2..1.2));
        let title = "60 revolutions, h = 0.04: the orbit turns; the first is dark";
        let mut orbit = picture::equal_axes(&left, title, x, y, 10)?;
        picture::line(&mut orbit, path.clone(), PALE, 1.0)?;
        picture::line(&mut orbit, path[..102].to_vec(), BLUE, 2.0)?;
        picture::dots(&mut orbit, &[(0.0, 0.0)], OCHRE, 8.0)?;
        picture::dots(&mut orbit, &[path[0]], BLUE, 4.0)?;
        picture::label(&orbit, (0.0, 0.0), (0, 18), "sun", INK)?;
        picture::label(&orbit, path[0], (-10, 0), "start", INK)?;
        let x = Axis::linear("time (dimensionless)", 0.0..9.0);
        let y = Axis::linear("energy (dimensionless)", -2.2..1.6);
        let mut energy = picture::chart(&right, "The energy that is kept, h = 0.02", x, y, 170)?;
        let names = ["m z²/2", "−k (1/|r| + 1/|r₋|)/2", "their sum (3.28)", "with 1/4 as printed"];
        let mut ends = Vec::new();
        for ((curve, name), colour) in curves.into_iter().zip(names).zip([GREEN, OCHRE, BLUE, RED]) {
            ends.push((curve[curve.len() - 1], name, colour));
            picture::line(&mut energy, curve, colour, 2.0)?;
        }
        picture::name_ends(&energy, ends)
    })
}

const FIRST_STEPS: &str = "
Greenspan's planet by Kanatani's scheme: Φ = −k/r, k = m = 1, from (0.5, 0) with velocity (0, 1.63)

The first steps, h = 0.1; z = (r − r₋)/h
         │ position            │ z                   │ (3.28) with
  i    t │         x         y │         x         y │              1/2       1/4
─────────┼─────────────────────┼─────────────────────┼───────────────────────────";

const KEPT: &str = "
The largest relative change, h = 0.02
          │ (3.28) with         │   angular
    steps │       1/2       1/4 │  momentum
──────────┼─────────────────────┼──────────";

const TURNING: &str = "\
What is not kept: the direction of the pericentre. The ellipse turns backward, a quarter as much for half the h
        │ turn in a
      h │ revolution      turn / h²
────────┼──────────────────────────";
