//! A loop of one's own, as a game has it: a curtain of 16×16 masses in a wind that changes, beside a ball, a corner carried along.
//!
//! ```text
//! cargo run --release --example cloth --features sparse
//! ```
//!
//! Sixty frames a second for a minute. Between frames the wind and the corner change; the stepper goes on from the state that
//! it has, and nothing is set up again. Leap-frog takes eight steps a frame, `DiscreteGradient` one: its Newton matrix has a
//! block for each spring, which the feature `sparse` solves as what it is.

#[path = "shared/picture.rs"]
mod picture;

use std::f64::consts::TAU;
use std::time::{Duration, Instant};

use dmech::extend::{Scheme, Setup};
use dmech::models::pairs::Spring;
use dmech::prelude::*;
use dmech::scene::{OnBonds, OnEach};
use picture::{Axis, BLUE, Drawn, GREEN, INK, OCHRE, PALE};

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

/// A ball that pushes out what enters it.
#[derive(Clone, Copy, Debug)]
struct Ball {
    centre: [f64; 3],
    radius: f64,
    stiffness: f64,
}

#[dmech::law]
impl Ball {
    #[potential]
    fn energy(&self, q: [f64; 3]) -> f64 {
        let d = [q[0] - self.centre[0], q[1] - self.centre[1], q[2] - self.centre[2]];
        let depth = self.radius - (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        if depth > 0.0 { 0.5 * self.stiffness * depth * depth } else { 0.0 }
    }
}

type Cloth = Scene<3, (), (((((), OnBonds<Spring>), OnBonds<Spring>), OnEach<Air>), OnEach<Ball>)>;

/// A sheet that hangs from its upper edge; springs along its threads and across.
fn cloth() -> Cloth {
    let at = |i: usize| 0.1 * i as f64;
    let masses = (0..SIDE * SIDE).map(|k| [at(k % SIDE), 0.0, -at(k / SIDE)]);
    let bodies = masses.fold(Scene::new(), |scene, q| scene.body(0.02, q, [0.0; 3]));
    let (mut threads, mut across) = (Vec::new(), Vec::new());
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        let k = y * SIDE + x;
        threads.extend((x + 1 < SIDE).then_some((k, k + 1)));
        threads.extend((y + 1 < SIDE).then_some((k, k + SIDE)));
        across.extend((x + 1 < SIDE && y + 1 < SIDE).then_some((k, k + SIDE + 1)));
    }
    (0..SIDE)
        .fold(bodies, Scene::pin)
        .bonds(Spring { k: 60.0, length: 0.1 }, threads)
        .bonds(Spring { k: 20.0, length: 0.1 * 2.0_f64.sqrt() }, across)
        .field(Air { force: weight(0.0) })
        .field(Ball { centre: [0.8, 0.5, -1.0], radius: 0.4, stiffness: 100.0 })
}

/// Weight, and a wind that turns and comes in gusts.
fn weight(t: f64) -> [f64; 3] {
    let gust = 0.05 * (1.0 + (1.3 * t).sin());
    [0.3 * gust * (0.2 * t).sin(), gust * (0.2 * t).cos(), -0.02 * 9.81]
}

/// What frames cost, and the cloth at some of them.
struct Film {
    mean: Duration,
    worst: Duration,
    /// Frames in which a step had no solution.
    halted: u32,
    /// Newton corrections a frame.
    corrections: f64,
    pictures: Vec<SceneState<3>>,
}

fn play<S: Scheme<<Cloth as Setup<()>>::System>>(scheme: S, steps: u64) -> Result<Film, Error> {
    let dt = FRAME / steps as f64;
    let mut stepper = Simulation::scene(cloth()).scheme(scheme).dt(dt).stepper()?;
    let corner = stepper.state().q[0];
    let mut film =
        Film { mean: Duration::ZERO, worst: Duration::ZERO, halted: 0, corrections: 0.0, pictures: Vec::new() };
    for frame in 0..FRAMES {
        let clock = Instant::now();
        if let Some(mut air) = stepper.law_mut::<Air>() {
            air.force = weight(f64::from(frame) * FRAME);
        }
        let sway = 0.05 * (0.5 * stepper.t()).sin();
        stepper.set_body(0, [corner[0], corner[1] + sway, corner[2]], [0.0; 3])?;
        // A step without a solution leaves the motion where it was: then in four.
        let end = stepper.steps() + steps;
        if stepper.advance(steps).is_err() {
            let left = end - stepper.steps();
            stepper.set_dt(0.25 * dt)?;
            stepper.advance(4 * left)?;
            stepper.set_dt(dt)?;
            film.halted += 1;
        }
        let spent = clock.elapsed();
        film.mean += spent / FRAMES;
        film.worst = film.worst.max(spent);
        if [0, 15, 60, 180].contains(&frame) {
            film.pictures.push(stepper.state());
        }
    }
    film.corrections = stepper.iterations() as f64 / f64::from(FRAMES);
    Ok(film)
}

fn main() -> Drawn {
    println!("256 masses, 705 springs, one minute at 60 frames a second\n");
    println!("scheme            steps a frame │ ms a frame      worst   corrections   made in four");
    println!("────────────────────────────────┼─────────────────────────────────────────────────");
    let row = |name: &str, steps: u64, film: &Film| {
        let [mean, worst] = [film.mean, film.worst].map(|time| 1e3 * time.as_secs_f64());
        println!("{name:<17} {steps:>13} │ {mean:>10.3} {worst:>10.3} {:>13.1} {:>14}", film.corrections, film.halted);
    };
    let film = play(Leapfrog, 8)?;
    row("Leapfrog", 8, &film);
    if cfg!(feature = "sparse") {
        row("DiscreteGradient", 1, &play(DiscreteGradient, 1)?);
    } else {
        println!("DiscreteGradient with `--features sparse`: without it, its matrix of 768 rows is dense");
    }

    let path = picture::save("cloth.svg", [960, 520], |area| {
        let title = "The middle of a curtain in the wind, from the side";
        let (x, y) = (Axis::linear("x (m)", -0.5..1.4), Axis::linear("height (m)", -2.0..0.1));
        let mut chart = picture::equal_axes(area, title, x, y, 130)?;
        let circle = (0..=200).map(|k| TAU / 200.0 * f64::from(k)).map(|a| (0.5 + 0.4 * a.cos(), 0.4 * a.sin() - 1.0));
        picture::line(&mut chart, circle.collect(), PALE, 2.0)?;
        let names = [("at the start", INK), ("after 1/4 s", BLUE), ("after 1 s", GREEN), ("after 3 s", OCHRE)];
        for (state, (_, colour)) in film.pictures.iter().zip(names) {
            let column = state.q.iter().skip(SIDE / 2).step_by(SIDE);
            picture::line(&mut chart, column.map(|q| (q[1], q[2])).collect(), colour, 1.6)?;
        }
        let corner = (chart.x_range().end, -0.4);
        picture::name_column(&chart, corner, &names)
    })?;
    println!("\nPicture: {}", path.display());
    Ok(())
}
