//! A loop of one's own, as a game has it: a cloth of 16×16 masses in a wind that changes, over a ball, its corners carried along.
//!
//! ```text
//! cargo run --release --example cloth --features sparse
//! ```
//!
//! Sixty frames a second for a minute. Between frames the wind and two corners change; the stepper goes on from the state that
//! it has, and nothing is set up again. Leap-frog takes eight steps a frame, `DiscreteGradient` two: its Newton matrix has a
//! block for each spring, which the feature `sparse` solves as what it is.

#[path = "shared/picture.rs"]
mod picture;

use std::time::{Duration, Instant};

use dmech::extend::{Scheme, Setup};
use dmech::models::pairs::Spring;
use dmech::prelude::*;
use dmech::scene::{OnBonds, OnEach};
use picture::{BLUE, Drawn, GREEN, INK, OCHRE};

const SIDE: usize = 16;
const FRAMES: u32 = 3600;
const FRAME: f64 = 1.0 / 60.0;

/// Weight and wind: Φ = −f·q.
#[derive(Clone, Copy, Debug)]
struct Air {
    force: [f64; 3],
}

#[dmech::law]
impl Air {
    #[potential]
    fn energy(&self, q: [f64; 3]) -> f64 {
        -(self.force[0] * q[0] + self.force[1] * q[1] + self.force[2] * q[2])
    }
}

/// A ball at the origin that pushes out what enters it.
#[derive(Clone, Copy, Debug)]
struct Ball {
    radius: f64,
    stiffness: f64,
}

#[dmech::law]
impl Ball {
    #[potential]
    fn energy(&self, q: [f64; 3]) -> f64 {
        let depth = self.radius - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt();
        if depth > 0.0 { 0.5 * self.stiffness * depth * depth } else { 0.0 }
    }
}

type Cloth = Scene<3, (), ((((), OnBonds<Spring>), OnEach<Air>), OnEach<Ball>)>;

/// A sheet above the ball, held at two corners; springs along its threads and across.
fn cloth() -> Cloth {
    let at = |i: usize| 0.1 * (i as f64 - 7.5);
    let masses = (0..SIDE * SIDE).map(|k| [at(k % SIDE), at(k / SIDE), 1.1]);
    let bodies = masses.fold(Scene::new(), |scene, q| scene.body(0.02, q, [0.0; 3]));
    let (mut threads, mut across) = (Vec::new(), Vec::new());
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        let k = y * SIDE + x;
        threads.extend((x + 1 < SIDE).then_some((k, k + 1)));
        threads.extend((y + 1 < SIDE).then_some((k, k + SIDE)));
        across.extend((x + 1 < SIDE && y + 1 < SIDE).then_some((k, k + SIDE + 1)));
    }
    let _ = across;
    bodies
        .pin(0)
        .pin(SIDE - 1)
        .bonds(Spring { k: 60.0, length: 0.1 }, threads)
        .field(Air { force: weight(0.0) })
        .field(Ball { radius: 0.6, stiffness: 200.0 })
}

/// Weight, and a wind that turns and comes in gusts.
fn weight(t: f64) -> [f64; 3] {
    let gust = 0.04 * (1.0 + (1.3 * t).sin());
    [gust * (0.2 * t).cos(), gust * (0.2 * t).sin(), -0.02 * 9.81]
}

/// What frames cost, and the cloth at some of them.
struct Film {
    mean: Duration,
    worst: Duration,
    pictures: Vec<SceneState<3>>,
}

fn play<S: Scheme<<Cloth as Setup<()>>::System>>(scheme: S, steps: u64) -> Result<Film, Error> {
    let mut stepper = Simulation::scene(cloth()).scheme(scheme).dt(FRAME / steps as f64).stepper()?;
    let corner = stepper.state().q[0];
    let mut film = Film { mean: Duration::ZERO, worst: Duration::ZERO, pictures: Vec::new() };
    for frame in 0..FRAMES {
        let clock = Instant::now();
        if let Some(mut air) = stepper.law_mut::<Air>() {
            air.force = weight(stepper_time(frame));
        }
        let sway = 0.15 * (0.5 * stepper.t()).sin();
        stepper.set_body(0, [corner[0] + sway, corner[1], corner[2]], [0.0; 3])?;
        stepper.advance(steps)?;
        let spent = clock.elapsed();
        film.mean += spent / FRAMES;
        film.worst = film.worst.max(spent);
        if frame % 60 == 0 && frame <= 180 {
            film.pictures.push(stepper.state());
        }
    }
    Ok(film)
}

fn stepper_time(frame: u32) -> f64 {
    f64::from(frame) * FRAME
}

fn main() -> Drawn {
    println!("256 masses, 480 springs, one minute at 60 frames a second\n");
    println!("scheme            steps a frame │ ms a frame      worst");
    println!("────────────────────────────────┼──────────────────────");
    let row = |name: &str, steps: u64, film: &Film| {
        let [mean, worst] = [film.mean, film.worst].map(|time| 1e3 * time.as_secs_f64());
        println!("{name:<17} {steps:>13} │ {mean:>10.3} {worst:>10.3}");
    };
    let film = play(Leapfrog, 8)?;
    row("Leapfrog", 8, &film);
    row("DiscreteGradient", 2, &play(DiscreteGradient, 2)?);

    let path = picture::save("cloth.svg", [960, 520], |area| {
        let title = "A cloth over a ball, seen from the side: 0, 1, 2 and 3 seconds";
        let mut chart = picture::equal_chart_about(area, title, -1.6..1.6, 0.3)?;
        let circle = (0..=200).map(|k| 0.0314159265 * f64::from(k)).map(|a| (0.6 * a.cos(), 0.6 * a.sin()));
        picture::line(&mut chart, circle.collect(), INK, 1.6)?;
        for (state, colour) in film.pictures.iter().zip([INK, BLUE, GREEN, OCHRE]) {
            for row in state.q.chunks(SIDE).step_by(3) {
                picture::line(&mut chart, row.iter().map(|q| (q[0], q[2])).collect(), colour, 0.8)?;
            }
        }
        Ok(())
    })?;
    println!("\nPicture: {}", path.display());
    Ok(())
}
