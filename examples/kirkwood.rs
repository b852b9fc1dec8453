//! A long run that keeps little: asteroids beside and in the gap where Jupiter goes about once while they do three times.
//!
//! ```text
//! cargo run --release --example kirkwood
//! ```
//!
//! Asteroids are missing where their period is a third of Jupiter's, 2.50 au from the Sun (D. Kirkwood, 1867): the eccentricity
//! of an orbit there may stay low for a hundred thousand years and then jump, until Mars or the Sun is in the way (J. Wisdom,
//! Icarus 56 (1983) 51–74). Four million steps are made here. The states of every thousandth year are written to a table as
//! they come, with the names of the bodies; an observer looks at the elements, and nothing else is kept.

#[path = "shared/picture.rs"]
mod picture;

use std::fs::File;
use std::io::BufWriter;
use std::ops::ControlFlow;

use dmech::models::kepler::Elements;
use dmech::models::pairs::Gravity;
use dmech::models::units::{DAY, DEGREE, GM_JUPITER, GM_SUN, GM_SUN_AU_DAY, JULIAN_YEAR};
use dmech::prelude::*;
use picture::{BLUE, Drawn, GREEN, OCHRE, PURPLE, RED};

/// Half axes of the asteroids in au, and longitudes of their pericentres.
const ASTEROIDS: [(&str, f64, f64); 5] = [
    ("inside, 2.42 au", 2.42, 0.0),
    ("in the gap, 2.495 au", 2.495, 0.0),
    ("in the gap, 2.50 au", 2.5, 0.0),
    ("in the gap, 2.505 au", 2.505, 90.0),
    ("outside, 2.58 au", 2.58, 0.0),
];
const YEARS: f64 = 400_000.0;
const DT: f64 = 0.1;

/// The Sun's strength in au and years.
fn gm() -> f64 {
    GM_SUN_AU_DAY * (JULIAN_YEAR / DAY).powi(2)
}

/// An orbit in the plane, about the Sun at rest.
fn orbit(half_axis: f64, eccentricity: f64, longitude: f64, mean_anomaly: f64) -> Drawn<State<2>> {
    let pericentre = half_axis * (1.0 - eccentricity);
    let orbit = Elements {
        gm: gm(),
        pericentre,
        eccentricity,
        inclination: 0.0,
        node: 0.0,
        argument: longitude * DEGREE,
        passage: 0.0,
    };
    Ok(orbit.with_mean_anomaly(0.0, mean_anomaly * DEGREE).in_plane(0.0)?)
}

/// The elements about the Sun, which is body 0, of another body.
fn elements(state: &SceneState<2>, body: usize) -> Option<Elements> {
    let about = |x: &[[f64; 2]]| [x[body][0] - x[0][0], x[body][1] - x[0][1]];
    Elements::of_plane(gm(), &State { t: state.t, q: about(&state.q), v: about(&state.v) }).ok()
}

fn main() -> Drawn {
    let mut scene = Scene::new().body(1.0, [0.0; 2], [0.0; 2]);
    let State { q, v, .. } = orbit(5.2026, 0.0485, 15.0, 20.0)?;
    scene = scene.body(GM_JUPITER / GM_SUN, q, v);
    for (_, half_axis, longitude) in ASTEROIDS {
        let State { q, v, .. } = orbit(half_axis, 0.05, longitude, 0.0)?;
        scene = scene.test_body(1.0, q, v);
    }

    let table = picture::place("kirkwood.csv")?;
    let names = ["Sun", "Jupiter"].into_iter().chain(ASTEROIDS.map(|(name, ..)| name));
    let file = Csv::long(BufWriter::new(File::create(&table)?)).names(names);

    let mut histories: [Vec<(f64, f64)>; ASTEROIDS.len()] = Default::default();
    let run = Simulation::scene(scene.pairs(Gravity { g: gm() }))
        .scheme(Nystrom::order6())
        .dt(DT)
        .record_dt(1000.0)
        .stream(file)
        .observe(5000, |state| {
            let mut least = f64::INFINITY;
            for (i, history) in histories.iter_mut().enumerate() {
                if let Some(orbit) = elements(state, 2 + i) {
                    history.push((state.t, orbit.eccentricity));
                    least = least.min(orbit.pericentre);
                }
            }
            // An asteroid that falls into the Sun would need other steps.
            if least > 0.1 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        })
        .run_until(YEARS)?;
    println!("{run}\n");
    for ((name, ..), history) in ASTEROIDS.iter().zip(&histories) {
        let (when, largest) =
            history.iter().copied().fold((0.0, 0.0), |max, now| if now.1 > max.1 { now } else { max });
        println!("{name:<21} largest eccentricity {largest:.3}, in year {when:7.0}");
    }

    let path = picture::save("kirkwood.svg", [760, 420], |area| {
        let title = "Asteroids beside and in the gap at 2.50 au";
        let (x, y) = (
            picture::Axis::linear("time (thousands of years)", 0.0..400.0),
            picture::Axis::linear("eccentricity of the orbit", 0.0..0.5),
        );
        let mut chart = picture::chart(area, title, x, y, 165)?;
        let mut ends = Vec::new();
        let all = ASTEROIDS.iter().zip(&histories).zip([BLUE, OCHRE, RED, PURPLE, GREEN]);
        // Those beside the gap, which hardly change, over those in it.
        let (beside, within): (Vec<_>, Vec<_>) =
            all.partition(|((asteroid, _), _)| !asteroid.0.starts_with("in the gap"));
        for (((name, ..), history), colour) in within.into_iter().chain(beside) {
            let line: Vec<_> = history.iter().map(|&(t, e)| (t / 1000.0, e)).collect();
            ends.extend(line.last().map(|&end| (end, *name, colour)));
            picture::line(&mut chart, line, colour, 1.5)?;
        }
        picture::name_ends(&chart, ends)
    })?;
    println!("\nTable: {}\nPicture: {}", table.display(), path.display());
    Ok(())
}
