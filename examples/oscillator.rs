//! A linear oscillator that never asks for an iteration: Kanatani's first example.
//!
//! ```text
//! cargo run --release --example oscillator
//! ```
//!
//! A mass m on a spring with Φ(r) = k r²/2 moves in a plane, on an ellipse about the origin. Kanatani's scheme takes
//! the force −∇̄Φ at the mean of the positions before and after, which makes the step an implicit one; but since the force is
//! linear, the equation can be solved in advance:
//!
//! ```text
//! r₊ = [r − c r₋ + h z] / (1 + c),   z₊ = [z − (c/h)(r + r₋)] / (1 + c),   c = k h²/2m      (3.20), (3.21)
//! m z²/2 + k (r² + r₋²)/4 = const.                                                          (3.22)
//! ```
//!
//! K. Kanatani, J. Comput. Phys. (1983–84), "The Accuracy and the Preservation Property of the Discrete Mechanics".
//! The program runs the step that dmech makes of the potential beside (3.20)–(3.21) as printed, and shows how well each
//! keeps (3.22) over a million steps: in exact arithmetic they are the same, in rounded arithmetic they are not.

#[path = "shared/picture.rs"]
mod picture;

use dmech::prelude::*;
use picture::{Axis, BLUE, Drawn, INK, PALE, RED};

/// A spring: Φ(q) = k |q|²/2.
#[derive(Clone, Copy, Debug)]
struct Spring {
    k: f64,
}

#[dmech::law]
impl Spring {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        0.5 * self.k * (x * x + y * y)
    }
}

const SPRING: Spring = Spring { k: 3.7 };
const MASS: f64 = 1.3;
const START: State<2> = State::new([0.8, -0.3], [0.4, 1.1]);

fn main() -> Drawn {
    println!("{HEAD}");
    first_steps(0.1)?;
    period(0.1)?;
    let growth = growth_of_rounding(0.01)?;
    println!("{GROWTH}");
    for (steps, [generated, printed]) in growth.iter().step_by(POINTS_PER_DECADE) {
        println!("  {steps:>8} │ {generated:>10.1e} {printed:>12.1e}");
    }
    println!("\nPicture: {}", draw(&growth)?.display());
    Ok(())
}

/// (3.20) and (3.21), letter for letter.
struct AsPrinted {
    dt: f64,
    r_before: [f64; 2],
    r: [f64; 2],
    z: [f64; 2],
}

impl AsPrinted {
    /// From r₀ with z₀ = v₀ − (h/2) a₀ and r₋₁ = r₀ − h z₀, a₀ = −(k/m) r₀.
    fn start(dt: f64) -> Self {
        let State { q, v, .. } = START;
        let z = [0, 1].map(|i| v[i] + 0.5 * dt * SPRING.k / MASS * q[i]);
        AsPrinted { dt, r_before: [0, 1].map(|i| q[i] - dt * z[i]), r: q, z }
    }

    fn step(&mut self) {
        let AsPrinted { dt, r_before, r, z } = *self;
        let c = SPRING.k * dt * dt / (2.0 * MASS);
        self.r_before = r;
        self.r = [0, 1].map(|i| (r[i] - c * r_before[i] + dt * z[i]) / (1.0 + c));
        self.z = [0, 1].map(|i| (z[i] - c / dt * (r[i] + r_before[i])) / (1.0 + c));
    }
}

/// (3.22): m z²/2 + k (r² + r₋²)/4, which is the kinetic energy of z and the mean potential energy.
fn kept([zx, zy]: [f64; 2], r: [f64; 2], r_before: [f64; 2]) -> f64 {
    0.5 * MASS * (zx * zx + zy * zy) + 0.5 * (SPRING.energy(r) + SPRING.energy(r_before))
}

/// The first positions beside (3.20) and beside the exact motion.
fn first_steps(dt: f64) -> Drawn {
    println!("{FIRST_STEPS}");
    let mut stepper = Simulation::new(SPRING, START).mass(MASS).scheme(Kanatani).dt(dt).stepper()?;
    let mut printed = AsPrinted::start(dt);
    for i in 1..=6 {
        stepper.step()?;
        printed.step();
        let ([x, y], [exact_x, exact_y]) = (stepper.q(), exact(stepper.t()));
        let apart = (x - printed.r[0]).hypot(y - printed.r[1]);
        println!(
            "  {i:>2} {:>5.1} │ {x:>10.6} {y:>10.6} │ {apart:>9.0e}  │ {exact_x:>10.6} {exact_y:>10.6}",
            stepper.t()
        );
    }
    println!(
        "\n  Newton iterations so far: {}. The potential is quadratic, so its step has a closed form.\n",
        stepper.iterations()
    );
    Ok(())
}

/// r₀ cos ωt + (v₀/ω) sin ωt, ω² = k/m.
fn exact(t: f64) -> [f64; 2] {
    let omega = (SPRING.k / MASS).sqrt();
    let (sin, cos) = (omega * t).sin_cos();
    [0, 1].map(|i| START.q[i] * cos + START.v[i] / omega * sin)
}

/// Energy kept is not position kept: the scheme turns by the angle θ a step, cos θ = 1/(1 + c), and ωh > θ.
fn period(dt: f64) -> Drawn {
    let run = Simulation::new(SPRING, START).mass(MASS).scheme(Kanatani).dt(dt).run(40_000)?;
    let upward: Vec<f64> = run
        .states()
        .windows(2)
        .filter(|pair| pair[0].q[1] < 0.0 && pair[1].q[1] >= 0.0)
        .map(|pair| pair[0].t + dt * pair[0].q[1] / (pair[0].q[1] - pair[1].q[1]))
        .collect();
    let revolutions = (upward.len() - 1) as f64;
    let measured = (upward[upward.len() - 1] - upward[0]) / revolutions;
    let turn = std::f64::consts::TAU;
    let theta = (1.0 / (1.0 + 0.5 * SPRING.k / MASS * dt * dt)).acos();
    println!("Period: exact {:.6}; of the scheme at h = {dt}", turn / (SPRING.k / MASS).sqrt());
    println!("  2πh/θ with cos θ = 1/(1 + c)   {:.6}", turn * dt / theta);
    println!("  measured over {revolutions} revolutions  {measured:.6}\n");
    Ok(())
}

const POINTS_PER_DECADE: usize = 8;

/// After 10 to 10⁶ steps: the largest relative change of (3.22) so far, by the generated step and as printed.
fn growth_of_rounding(dt: f64) -> Drawn<Vec<(u64, [f64; 2])>> {
    let mut stepper = Simulation::new(SPRING, START).mass(MASS).scheme(Kanatani).dt(dt).stepper()?;
    let mut printed = AsPrinted::start(dt);
    let start = kept(printed.z, printed.r, printed.r_before);
    let (mut largest, mut growth) = ([0.0_f64; 2], Vec::new());
    for j in POINTS_PER_DECADE..=6 * POINTS_PER_DECADE {
        let steps = 10_f64.powf(j as f64 / POINTS_PER_DECADE as f64).round() as u64;
        while stepper.steps() < steps {
            stepper.step()?;
            printed.step();
            let memory = stepper.memory();
            let now = [kept(memory.z(), memory.q(), memory.q_before()), kept(printed.z, printed.r, printed.r_before)];
            largest = [0, 1].map(|i| largest[i].max((now[i] / start - 1.0).abs()));
        }
        growth.push((steps, largest));
    }
    Ok(growth)
}

/// Left: ten revolutions at h = 0.1. Right: how rounding adds up.
fn draw(growth: &[(u64, [f64; 2])]) -> Drawn<std::path::PathBuf> {
    let run = Simulation::new(SPRING, START).mass(MASS).scheme(Kanatani).dt(0.1).run(37)?;
    let steps: Vec<_> = run.states().iter().map(|state| (state.q[0], state.q[1])).collect();
    let ellipse = (0..=400).map(|i| exact(0.01 * f64::from(i))).map(|[x, y]| (x, y)).collect();
    picture::save("oscillator.svg", [1120, 520], |area| {
        let (left, right) = area.split_horizontally(520 * 4);
        let mut path = picture::equal_axes(
            &left,
            "One revolution, h = 0.1",
            Axis::linear("x (dimensionless)", -1.1..1.1),
            Axis::linear("y (dimensionless)", 0.0..0.0),
            10,
        )?;
        picture::line(&mut path, ellipse, PALE, 7.0)?;
        picture::line(&mut path, steps.clone(), BLUE, 1.0)?;
        picture::dots(&mut path, &steps, BLUE, 3.5)?;
        picture::label(&path, (0.0, 0.0), (0, -10), "a dot at each step", BLUE)?;
        picture::label(&path, (0.0, 0.0), (0, 10), "wide and pale: exact", INK)?;
        picture::rings(&mut path, &steps[..1], INK, 6.0)?;
        picture::label(&path, steps[0], (12, -6), "start", INK)?;

        let x = Axis::powers_of_ten("steps", 1.0..6.0);
        let y = Axis::powers_of_ten("largest relative change of (3.22)", -16.0..-9.0);
        let mut drift = picture::chart(&right, "A million steps, h = 0.01", x, y, 150)?;
        let curve = |i: usize| -> Vec<(f64, f64)> {
            growth.iter().map(|(steps, change)| ((*steps as f64).log10(), change[i].max(1e-16).log10())).collect()
        };
        let (generated, printed) = (curve(0), curve(1));
        let end = growth.len() - 1;
        picture::name_ends(
            &drift,
            vec![(generated[end], "generated step", BLUE), (printed[end], "(3.20) as printed", RED)],
        )?;
        picture::line(&mut drift, generated, BLUE, 2.0)?;
        picture::line(&mut drift, printed, RED, 2.0)?;
        Ok(())
    })
}

const HEAD: &str = "
A linear oscillator by Kanatani's scheme: Φ = k r²/2, k = 3.7, m = 1.3, from (0.8, −0.3) with velocity (0.4, 1.1)
";

const FIRST_STEPS: &str = "\
The first steps, h = 0.1
            │ generated step        │ apart from │ exact motion
   i     t  │         x          y  │ (3.20)     │         x          y
────────────┼───────────────────────┼────────────┼──────────────────────";

const GROWTH: &str = "\
The largest relative change of (3.22), h = 0.01
           │  generated  (3.20)-(3.21)
     steps │       step     as printed
───────────┼──────────────────────────";
