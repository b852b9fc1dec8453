//! A comet from its elements, through its pericentre with Jupiter about, and what elements it goes away with; in SI.

use dmech::models::kepler::Elements;
use dmech::models::units::{AU, DAY, DEGREE, GM_JUPITER, GM_SUN, JULIAN_YEAR};
use dmech::{models::Kepler3, prelude::*};

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

fn main() -> Result<(), Box<dyn std::error::Error>> {
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
        Simulation::new(both, start).scheme(scheme).dt(0.5 * DAY).record_every(100).run_until(8.0 * JULIAN_YEAR)?;
    show("with Jupiter", &law.elements(run.last())?);
    println!("{run}");
    Ok(())
}
