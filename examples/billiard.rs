//! A billiard under gravity: a ball that falls in a wedge and bounces off its walls, to and fro for ever.
//!
//! ```text
//! cargo run --release --example billiard
//! ```
//!
//! A wall is an event that changes the motion: where the distance from it falls to 0, the velocity across it is turned round. Between two
//! bounces the ball flies on a parabola, which leap-frog steps exactly, so that energy and bounces are right to rounding. With walls 45° from
//! the vertical every motion is regular; steeper ones leave islands of regular motion in a sea of chaos (H. E. Lehtihet and B. N. Miller,
//! Physica D 21 (1986) 93–104).

#[path = "shared/picture.rs"]
mod picture;

use std::time::Instant;

use dmech::prelude::*;
use picture::{BLUE, Drawn, GREEN, INK, OCHRE, PURPLE, RED};

/// Half of the angle between the walls.
const HALF: f64 = 40.0_f64.to_radians();
const ENERGY: f64 = 0.5;

/// Φ = g y.
#[derive(Clone, Copy, Debug)]
struct Fall {
    g: f64,
}

#[dmech::law]
impl Fall {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.g * q[1]
    }
}

/// The way along a wall, up and away from the tip, and the way off it; the left one is at −1.
fn wall(side: f64) -> [[f64; 2]; 2] {
    let (sin, cos) = HALF.sin_cos();
    [[side * sin, cos], [-side * cos, sin]]
}

fn along(way: [f64; 2], v: [f64; 2]) -> f64 {
    way[0] * v[0] + way[1] * v[1]
}

/// What a wall does to a ball.
fn bounce(off: [f64; 2]) -> impl FnMut(&mut State<2>) {
    move |ball| {
        let across = along(off, ball.v);
        ball.v = [ball.v[0] - 2.0 * across * off[0], ball.v[1] - 2.0 * across * off[1]];
    }
}

/// A ball that leaves the right wall, with this velocity along it and that square of the one across.
fn motion([up, across_squared]: [f64; 2], end: f64) -> Result<Run<State<2>>, Interrupted<State<2>>> {
    let ([ways, [_, left]], across) = ([wall(1.0), wall(-1.0)], across_squared.sqrt());
    let [way, right] = ways;
    // As high as the energy leaves it.
    let s = (ENERGY - 0.5 * (up * up + across_squared)) / way[1];
    let start = State::new(way.map(|x| s * x), [up * way[0] + across * right[0], up * way[1] + across * right[1]]);
    Simulation::new(Fall { g: 1.0 }, start)
        .scheme(Leapfrog)
        .dt(0.1)
        .record_every(u64::MAX)
        .bounce_off(move |ball| along(right, ball.q), bounce(right))
        .bounce_off(move |ball| along(left, ball.q), bounce(left))
        .run_until(end)
}

fn main() -> Drawn {
    let starts = [
        ([0.0, 0.45], INK, 0.9),
        ([0.0, 0.4], BLUE, 0.9),
        ([0.0, 0.34], BLUE, 0.9),
        ([0.0, 0.28], GREEN, 0.9),
        ([0.0, 0.23], GREEN, 0.9),
        ([0.0, 0.82], OCHRE, 0.9),
        ([0.0, 0.79], OCHRE, 0.9),
        ([0.0, 0.755], PURPLE, 0.9),
        ([0.5, 0.05], RED, 0.6),
    ];
    let clock = Instant::now();
    let runs = starts.iter().map(|&(from, ..)| motion(from, 4000.0)).collect::<Result<Vec<_>, _>>()?;
    let seconds = clock.elapsed().as_secs_f64();
    println!(" along  across² │ bounces   energy error");
    println!("────────────────┼───────────────────────");
    for ((from, ..), run) in starts.iter().zip(&runs) {
        let worst = run.drift(Invariant::Energy).map_or(f64::NAN, |drift| drift.max_relative());
        println!("{:6.2}   {:6.2} │ {:7}   {worst:12.1e}", from[0], from[1], run.events().len());
    }
    let bounces: usize = runs.iter().map(|run| run.events().len()).sum();
    let steps: u64 = runs.iter().map(Run::steps).sum();
    println!("\n{bounces} bounces in {steps} steps: {seconds:.3} s");

    let path = picture::save("billiard.svg", [760, 640], |area| {
        let title = "A ball in a wedge, 40° from the vertical: its velocity at each bounce";
        let (x, y) = (
            picture::Axis::linear("velocity along the wall (dimensionless)", -1.0..1.0),
            picture::Axis::linear("square of the velocity across (dimensionless)", 0.0..1.0),
        );
        let mut chart = picture::chart(area, title, x, y, 20)?;
        for ((_, colour, size), run) in starts.iter().zip(&runs) {
            let points = run.events().iter().map(|event| {
                let [way, off] = wall(if event.which() == 0 { 1.0 } else { -1.0 });
                let v = event.state().v;
                (along(way, v), along(off, v).powi(2))
            });
            picture::dots(&mut chart, &points.collect::<Vec<_>>(), *colour, *size)?;
        }
        Ok(())
    })?;
    println!("Picture: {}", path.display());
    Ok(())
}
