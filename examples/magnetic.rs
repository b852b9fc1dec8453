//! A charged particle in a magnetic field: a force that depends on the velocity and does no work.
//!
//! ```text
//! cargo run --release --example magnetic
//! ```
//!
//! The force is F = b v × e_z, with b the charge times the field. In a uniform field the particle runs round a circle
//! of radius m v/b in the time 2π m/b. Where the field is graded, or an electric field crosses it, the circle drifts
//! sideways. F is at right angles to v, so the kinetic energy stays what it is; the macro sees F·v = 0 in the expression,
//! and the energy is an invariant of the law, though it has a force.
//!
//! `Boris` turns the velocity by two cross products and solves no equation: it keeps the speed in any magnetic field, and
//! is the scheme to begin with. `DiscreteGradient` keeps the energy beside an electric field as well.
//!
//! The program measures the circle and the drifts beside what they should be, follows the energy over 10⁶ steps, and
//! draws the orbit in the graded field and the energy errors of four schemes.

#[path = "shared/gyration.rs"]
mod gyration;
#[path = "shared/picture.rs"]
mod picture;

use std::path::PathBuf;

use dmech::prelude::*;
use dmech::scheme::Scheme;
use gyration::{CROSSED, Circle, GRADED, IN_SPACE, IN_THE_PLANE, MASS, UNIFORM};
use picture::{Axis, BLUE, Drawn, GREEN, INK, OCHRE, RED};

/// The steps of the long runs.
const STEPS: u64 = 1_000_000;

fn main() -> Drawn {
    circles()?;
    drifts()?;
    energies()?;
    println!("Pictures: {}", orbit()?.display());
    println!("          {}", energy_errors()?.display());
    Ok(())
}

fn simulate<L: Law<D> + Copy, S: Scheme<Particle<L, D>>, const D: usize>(
    law: L,
    start: State<D>,
    scheme: S,
    (dt, steps): (f64, u64),
) -> Result<Run<State<D>>, Interrupted<State<D>>> {
    Simulation::new(law, start).mass(MASS).scheme(scheme).dt(dt).run(steps)
}

/// Radius and period in the uniform field.
fn circles() -> Drawn {
    println!("{CIRCLES}");
    let exact = Circle::exact();
    for dt in [0.1, 0.05, 0.01] {
        let run = simulate(UNIFORM, IN_SPACE, DiscreteGradient, (dt, STEPS))?;
        let (measured, step) = (Circle::measured(run.states()), Circle::of_the_step(dt));
        println!(
            "{dt:<4} │ {:>11.8} {:>11.8} │ {:>11.8} {:>11.8} {:>11.8}",
            measured.radius, exact.radius, measured.period, step.period, exact.period
        );
    }
    println!("{STEP}");
    Ok(())
}

/// The drift of the centre of gyration, along y in both laws.
fn drifts() -> Drawn {
    println!("{DRIFTS}");
    for dt in [0.1, 0.05, 0.01] {
        let crossed = simulate(CROSSED, IN_THE_PLANE, DiscreteGradient, (dt, STEPS))?;
        let graded = simulate(GRADED, IN_THE_PLANE, DiscreteGradient, (dt, STEPS))?;
        let field = |q: [f64; 2]| GRADED.b * (1.0 + q[0] / GRADED.length);
        let [_, by_e] = gyration::drift(&crossed.states()[0], crossed.last(), |_| CROSSED.b);
        let [_, by_gradient] = gyration::drift(&graded.states()[0], graded.last(), field);
        println!(
            "{dt:<4} │ {by_e:>12.9} {:>12.9} │ {by_gradient:>12.9} {:>12.9}",
            -CROSSED.e / CROSSED.b,
            gyration::graded_drift(&IN_THE_PLANE)
        );
    }
    println!();
    Ok(())
}

/// The largest relative error of the energy.
fn energies() -> Drawn {
    println!("{ENERGIES}");
    for dt in [0.1, 0.05, 0.01] {
        let run = [
            relative(&simulate(UNIFORM, IN_SPACE, Boris, (dt, STEPS))?),
            relative(&simulate(GRADED, IN_THE_PLANE, Boris, (dt, STEPS))?),
            relative(&simulate(CROSSED, IN_THE_PLANE, Boris, (dt, STEPS))?),
            relative(&simulate(UNIFORM, IN_SPACE, DiscreteGradient, (dt, STEPS))?),
            relative(&simulate(GRADED, IN_THE_PLANE, DiscreteGradient, (dt, STEPS))?),
            relative(&simulate(CROSSED, IN_THE_PLANE, DiscreteGradient, (dt, STEPS))?),
            relative(&simulate(GRADED, IN_THE_PLANE, Implicit, (dt, STEPS))?),
        ];
        let [a, b, c, d, e, f, implicit] = run.map(|error| format!("{error:.0e}"));
        println!("{dt:<4} │ {a:>8} {b:>8} {c:>8} │ {d:>8} {e:>8} {f:>8} │ {implicit:>8}");
    }
    println!();
    Ok(())
}

fn relative<X: Clone>(run: &Run<X>) -> f64 {
    run.drift(Invariant::Energy).map_or(f64::NAN, |drift| drift.max_relative())
}

/// Five turns in the graded field.
fn orbit() -> Drawn<PathBuf> {
    let run = simulate(GRADED, IN_THE_PLANE, DiscreteGradient, (0.05, 310))?;
    let path: Vec<_> = run.states().iter().map(|state| (state.q[0], state.q[1])).collect();
    let start = path[0];
    let arm = MASS / (GRADED.b * (1.0 + start.0 / GRADED.length));
    let centre = start.0 + arm * IN_THE_PLANE.v[1];
    let drift = gyration::graded_drift(&IN_THE_PLANE);
    let low = start.1 - arm * IN_THE_PLANE.v[0];
    let end = low + drift * run.last().t;
    picture::save("magnetic_orbit.svg", [760, 640], |area| {
        let title = "A charge in a field that grows to the right: its circles drift along y";
        let x = Axis::linear("x (dimensionless)", -0.9..3.4);
        let y = Axis::linear("y (dimensionless)", -1.35..1.8);
        let mut chart = picture::equal_axes(area, title, x, y, 10)?;
        let line = vec![(centre, low), (centre, end)];
        picture::line(&mut chart, path.clone(), BLUE, 2.0)?;
        picture::line(&mut chart, line.clone(), OCHRE, 2.0)?;
        picture::rings(&mut chart, &[start], BLUE, 5.0)?;
        picture::dots(&mut chart, &[(centre, low)], OCHRE, 4.0)?;
        picture::dots(&mut chart, &path[path.len() - 1..], BLUE, 4.0)?;
        let words = [(start, "start"), (path[path.len() - 1], "end")].map(|(at, word)| (at, word.to_owned(), INK));
        picture::label(&chart, (1.7, end), (8, 0), "the line: ½ v² (m/b) ∇b/b · t,", OCHRE)?;
        picture::label(&chart, (1.7, end), (8, 20), "the drift to first order", OCHRE)?;
        picture::label_beside(&chart, &[path, line], &words)
    })
}

/// The energy error in the graded field, on a logarithmic scale: the largest up to each time.
fn energy_errors() -> Drawn<PathBuf> {
    let length = (0.01, 10_000);
    let runs = [
        (RED, simulate(GRADED, IN_THE_PLANE, Explicit, length)?),
        (OCHRE, simulate(GRADED, IN_THE_PLANE, Implicit, length)?),
        (GREEN, simulate(GRADED, IN_THE_PLANE, DiscreteGradient, length)?),
        (BLUE, simulate(GRADED, IN_THE_PLANE, Boris, length)?),
    ];
    picture::save("magnetic_energy.svg", [900, 520], |area| {
        let title = "Energy error in the graded field, dt = 0.01: the largest so far";
        let y = Axis::powers_of_ten("|E − E₀| / E₀", -16.0..2.0);
        let mut chart = picture::chart(area, title, Axis::linear("time (dimensionless)", 0.0..100.0), y, 150)?;
        let mut names = Vec::new();
        for (colour, run) in &runs {
            let points = largest_so_far(run.states());
            names.push((points[points.len() - 1], run.report().scheme(), *colour));
            picture::line(&mut chart, points, *colour, 2.0)?;
        }
        picture::name_ends(&chart, names)
    })
}

fn largest_so_far(states: &[State<2>]) -> Vec<(f64, f64)> {
    let energy = |state: &State<2>| state.v[0].powi(2) + state.v[1].powi(2);
    let (start, mut largest) = (energy(&states[0]), 1e-16);
    let errors = states.iter().map(|state| {
        largest = f64::max(largest, (energy(state) / start - 1.0).abs());
        (state.t, largest.log10())
    });
    errors.step_by(20).collect()
}

const CIRCLES: &str = "
A charge in magnetic fields: m = 1.3, b = 2.1, a speed of 1.5 across the field; DiscreteGradient, 10⁶ steps

The circle in a uniform field
     │ radius                  │ period
dt   │    measured       exact │    measured of the step       exact
─────┼─────────────────────────┼────────────────────────────────────";

const STEP: &str = "
  of the step  a step turns the velocity by 2 atan(ωh/2) in place of ωh, ω = b/m: the period is longer by (ωh)²/12
               and the radius exact
";

const DRIFTS: &str = "\
The drift of its centre along y
     │ crossed fields, −E/B      │ graded field
dt   │     measured        exact │     measured  first order
─────┼───────────────────────────┼──────────────────────────";

const ENERGIES: &str = "\
Largest relative error of the energy over 10⁶ steps
     │ Boris                      │ DiscreteGradient           │ Implicit
dt   │  uniform   graded  crossed │  uniform   graded  crossed │   graded
─────┼────────────────────────────┼────────────────────────────┼─────────";
