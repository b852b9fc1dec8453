//! A comet from its elements, through its pericentre with Jupiter about, and what elements it goes away with; in SI.
//!
//! ```text
//! cargo run --release --example comet
//! ```

#[path = "shared/picture.rs"]
mod picture;

use std::f64::consts::TAU;

use dmech::models::kepler::Elements;
use dmech::models::units::{AU, DAY, DEGREE, GM_JUPITER, GM_SUN, JULIAN_YEAR};
use dmech::{models::Kepler3, prelude::*};
use picture::{Axis, BLUE, Drawn, GREEN, INK, OCHRE};

/// The Sun at rest in the origin, and Jupiter about it on a circle in the ecliptic.
#[derive(Clone, Copy, Debug)]
struct SunAndJupiter {
    sun: f64,
    jupiter: f64,
    /// Radius of its circle.
    radius: f64,
    /// Angle per second.
    rate: f64,
    /// Its longitude at t = 0.
    longitude: f64,
}

#[dmech::law]
impl SunAndJupiter {
    #[potential]
    fn energy(&self, q: [f64; 3], t: f64) -> f64 {
        let [x, y, z] = q;
        let (sin, cos) = (self.longitude + self.rate * t).sin_cos();
        let (a, b) = (self.radius * cos, self.radius * sin);
        let to_jupiter = ((x - a).powi(2) + (y - b).powi(2) + z * z).sqrt();
        // The second term is the Sun's own fall toward Jupiter, as the origin falls with it.
        let tide = 1.0 / to_jupiter - (x * a + y * b) / self.radius.powi(3);
        -self.sun / (x * x + y * y + z * z).sqrt() - self.jupiter * tide
    }

    /// Jacobi's constant: neither the energy nor the angular momentum is kept, but E − n L is.
    #[invariant]
    fn jacobi(&self, q: [f64; 3], v: [f64; 3], t: f64) -> f64 {
        let energy = 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + self.energy(q, t);
        energy - self.rate * (q[0] * v[1] - q[1] * v[0])
    }
}

fn show(name: &str, orbit: &Elements) {
    let years = orbit.period().map_or("none".to_owned(), |period| format!("{:.3} years", period / JULIAN_YEAR));
    println!(
        "{name:<14} q = {:.6} au, e = {:.6}, i = {:.3}°, Ω = {:.3}°, ω = {:.3}°, T = {:+.4} days, period {years}",
        orbit.pericentre / AU,
        orbit.eccentricity,
        orbit.inclination / DEGREE,
        orbit.node / DEGREE,
        orbit.argument / DEGREE,
        orbit.passage / DAY,
    );
}

fn main() -> Drawn {
    // 1P/Halley (JPL Horizons, epoch 1994-Feb-17), the time in seconds from its pericentre on 1986-Feb-9.
    let halley = Elements {
        gm: GM_SUN,
        pericentre: 0.585_978_111_516_908_6 * AU,
        eccentricity: 0.967_142_908_462_304_4,
        inclination: 162.262_690_579_160_6 * DEGREE,
        node: 58.420_080_976_568_43 * DEGREE,
        argument: 111.332_485_104_517_7 * DEGREE,
        passage: 0.0,
    };
    show("elements", &halley);
    let start = halley.at(-2.0 * JULIAN_YEAR)?;

    // The Sun alone: the elements stay.
    let law = Kepler3 { gm: GM_SUN };
    let scheme = Nystrom::order6();
    let run = Simulation::new(law, start).scheme(scheme).adaptive(1e-9).run_until(8.0 * JULIAN_YEAR)?;
    show("Sun alone", &law.elements(run.last())?);
    println!("{run}\n");

    // With Jupiter they do not.
    let radius = 5.2 * AU;
    let rate = ((GM_SUN + GM_JUPITER) / radius.powi(3)).sqrt();
    let both = SunAndJupiter { sun: GM_SUN, jupiter: GM_JUPITER, radius, rate, longitude: 333.0 * DEGREE };
    let run =
        Simulation::new(both, start).scheme(scheme).dt(0.5 * DAY).record_dt(5.0 * DAY).run_until(8.0 * JULIAN_YEAR)?;
    show("with Jupiter", &law.elements(run.last())?);
    println!("{run}");

    // The plane that the Earth moves in, seen from the north; north of it the comet is drawn dark.
    let path = picture::save("comet.svg", [760, 640], |area| {
        let title = "Halley's comet, 1984 to 1994, seen from the north; dark: north of the plane of the Earth";
        let mut chart =
            picture::equal_axes(area, title, Axis::linear("x (au)", -15.5..8.5), Axis::linear("y (au)", 3.0..3.0), 10)?;
        let round =
            |r: f64| (0..=200).map(|i| TAU * f64::from(i) / 200.0).map(|a| (r * a.cos(), r * a.sin())).collect();
        picture::line(&mut chart, round(radius / AU), OCHRE, 1.5)?;
        picture::line(&mut chart, round(1.0), GREEN, 1.5)?;
        let place = |state: &State<3>| (state.q[0] / AU, state.q[1] / AU);
        picture::line(&mut chart, run.states().iter().map(place).collect(), BLUE, 1.5)?;
        let north: Vec<_> = run.states().iter().filter(|state| state.q[2] > 0.0).map(place).collect();
        picture::line(&mut chart, north, INK, 1.5)?;
        for (state, word) in [(run.states().first(), "start"), (run.states().last(), "end")] {
            if let Some(at) = state.map(place) {
                picture::label(&chart, at, (0, -10), word, INK)?;
            }
        }
        // Where a year since the pericentre begins.
        let year = |state: &State<3>| (state.t / JULIAN_YEAR).floor();
        for rows in run.states().chunk_by(|a, b| year(a) == year(b)).skip(1) {
            let (at, years) = (place(&rows[0]), year(&rows[0]));
            picture::dots(&mut chart, &[at], INK, 2.5)?;
            if years != 0.0 {
                picture::label(
                    &chart,
                    at,
                    (10, if years < 0.0 { 12 } else { -8 }),
                    &format!("{years:+} y").replace('-', "−"),
                    INK,
                )?;
            }
        }
        picture::label(&chart, (radius / AU, 0.0), (8, 0), "Jupiter", OCHRE)?;
        picture::label(&chart, (1.0, 0.0), (8, 0), "Earth", GREEN)
    })?;
    println!("\nPicture: {}", path.display());
    Ok(())
}
