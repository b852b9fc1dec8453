//! A Poincaré section: the motions of Hénon and Heiles at E = 1/8, where they cross x = 0.
//!
//! ```text
//! cargo run --release --example section
//! ```
//!
//! A star in the plane of a galaxy, Φ = (x² + y²)/2 + x²y − y³/3. A motion that has a second invariant beside the energy marks a
//! curve on the plane x = 0, v_x > 0; one that has none spreads over a region. At E = 1/8 there are both (M. Hénon and C. Heiles,
//! Astron. J. 69 (1964) 73–79, figure 5).

#[path = "shared/picture.rs"]
mod picture;

use std::time::Instant;

use dmech::models::HenonHeiles;
use dmech::prelude::*;
use picture::{BLUE, Drawn, GREEN, INK, OCHRE, PURPLE, RED};

const ENERGY: f64 = 0.125;

/// On the plane x = 0 at (y, v_y), with the velocity v_x > 0 that the energy leaves.
fn start([y, vy]: [f64; 2]) -> State<2> {
    let rest = 2.0 * ENERGY - vy * vy - y * y + 2.0 / 3.0 * y.powi(3);
    State::new([0.0, y], [rest.sqrt(), vy])
}

fn motion(from: [f64; 2]) -> Simulation<HenonHeiles, State<2>, Nystrom<coefficients::Blanes8S19, 19>> {
    Simulation::new(HenonHeiles { lambda: 1.0 }, start(from)).scheme(Nystrom::order8()).dt(0.125).record_every(u64::MAX)
}

/// Where a motion crosses the plane: that is all.
fn section(from: [f64; 2], end: f64) -> Result<Run<State<2>>, Interrupted<State<2>>> {
    motion(from).event(|state| state.q[0], Crossing::Rising).run_until(end)
}

fn main() -> Drawn {
    let starts = [
        ([0.0, 0.0], INK, 1.1),
        ([0.03, 0.0], BLUE, 0.8),
        ([0.16, 0.0], BLUE, 0.8),
        ([0.24, 0.0], BLUE, 0.8),
        ([-0.2, 0.0], GREEN, 0.8),
        ([-0.27, 0.0], GREEN, 0.8),
        ([0.0, 0.3], OCHRE, 0.8),
        ([0.0, 0.36], OCHRE, 0.8),
        ([0.0, -0.3], PURPLE, 0.8),
        ([0.0, -0.36], PURPLE, 0.8),
        ([-0.1, 0.0], RED, 0.6),
    ];
    let clock = Instant::now();
    let runs = starts.iter().map(|&(from, ..)| section(from, 6000.0)).collect::<Result<Vec<_>, _>>()?;
    let seconds = clock.elapsed().as_secs_f64();
    println!("   y      v_y  │ crossings   energy error");
    println!("───────────────┼──────────────────────────");
    for ((from, ..), run) in starts.iter().zip(&runs) {
        let worst = run.drift(Invariant::Energy).map_or(f64::NAN, |drift| drift.max_relative());
        println!("{:6.2}  {:6.2} │ {:9}   {worst:12.1e}", from[0], from[1], run.events().len());
    }
    let crossings: usize = runs.iter().map(|run| run.events().len()).sum();
    let steps: u64 = runs.iter().map(Run::steps).sum();
    let clock = Instant::now();
    for (from, ..) in starts {
        motion(from).run_until(6000.0)?;
    }
    let without = clock.elapsed().as_secs_f64();
    println!("\n{crossings} crossings in {steps} steps: {seconds:.3} s, without looking for them {without:.3} s");

    let path = picture::save("section.svg", [760, 640], |area| {
        let title = "Hénon and Heiles at E = 1/8: crossings of the plane x = 0 with v_x > 0";
        let (x, y) = (
            picture::Axis::linear("y (dimensionless)", -0.45..0.7),
            picture::Axis::linear("velocity of y (dimensionless)", -0.5..0.5),
        );
        let mut chart = picture::chart(area, title, x, y, 20)?;
        for ((_, colour, size), run) in starts.iter().zip(&runs) {
            let points: Vec<_> = run.events().iter().map(|event| (event.state().q[1], event.state().v[1])).collect();
            picture::dots(&mut chart, &points, *colour, *size)?;
        }
        Ok(())
    })?;
    println!("Picture: {}", path.display());
    Ok(())
}
