//! How fast do rounding errors grow in the energy?
//!
//! ```text
//! cargo run --release --example round_off                10⁵ steps of each scheme, half a minute of one core
//! cargo run --release --example round_off -- 7           10⁷ steps, hours, nearly all of them for the chain
//! cargo run --release --example round_off -- 7 chain     of one motion: kepler, components, henon or chain
//! ```
//!
//! An energy-exact scheme keeps the energy but for rounding. If the rounding errors of steps are independent of each other
//! the energy walks at random, and its error grows like the square root of the number of steps: Brouwer's law, exponent
//! 0.5 (D. Brouwer, Astron. J. 46 (1937) 149). If they have a mean it grows like the number of steps: exponent 1.
//!
//! Eight starts of each motion. Printed is the root mean square of the largest relative errors until then, and the exponent
//! p of a nᵖ fitted to all numbers of steps n at which it stands clear of the rounding of a single energy.

#[path = "shared/growth.rs"]
mod growth;
#[path = "shared/picture.rs"]
mod picture;

use std::path::PathBuf;

use dmech::plot::plotters::style::{IntoFont, TextStyle};
use dmech::plot::power;
use dmech::prelude::*;
use growth::{Growth, Motion};
use picture::{Axis, BLUE, Drawn, INK, OCHRE, PURPLE, RED, TEAL};

fn main() -> Drawn {
    let decades = std::env::args().nth(1).map_or(Ok(5), |n| n.parse())?;
    let wanted = std::env::args().nth(2).unwrap_or_default().to_lowercase();
    let motions: Vec<_> = Motion::ALL.into_iter().filter(|motion| file(*motion).contains(&wanted)).collect();
    if motions.is_empty() {
        return Err(format!("no motion is called {wanted}: there are kepler, components, henon and chain").into());
    }
    for motion in motions {
        // The chain, which comes last, takes most of the time.
        let told = |line: Growth| {
            eprintln!("{}, {}: done", motion.name(), line.scheme);
            line
        };
        let lines = [
            motion.growth(DiscreteGradient, Invariant::Energy, decades).map(told)?,
            motion.growth(Kanatani, Invariant::DiscreteEnergy, decades).map(told)?,
            motion.growth(Composed::order4(DiscreteGradient), Invariant::Energy, decades).map(told)?,
            motion.growth(Composed::order6(DiscreteGradient), Invariant::Energy, decades).map(told)?,
            motion.growth(Composed::order8(DiscreteGradient), Invariant::Energy, decades).map(told)?,
        ];
        let path = draw(motion, &lines)?;
        print(motion, &lines);
        println!("Picture: {}\n", path.display());
    }
    Ok(())
}

fn file(motion: Motion) -> &'static str {
    match motion {
        Motion::Kepler => "round_off_kepler.svg",
        Motion::Components => "round_off_components.svg",
        Motion::HenonHeiles => "round_off_henon_heiles.svg",
        Motion::Chain => "round_off_chain.svg",
    }
}

fn print(motion: Motion, lines: &[Growth]) {
    println!("{}: relative error of the energy after n steps\n", motion.name());
    print!("{:<48}", "n");
    let decades = || lines[0].points.iter().step_by(2);
    decades().for_each(|(n, _)| print!(" {:>8}", format!("{n:.0e}")));
    println!(" {:>9}", "exponent");
    for line in lines {
        print!("{:<48}", line.scheme);
        line.points.iter().step_by(2).for_each(|(_, error)| print!(" {error:>8.1e}"));
        println!(" {:>9}", line.exponent().map_or("–".to_owned(), |p| format!("{p:.2}")));
    }
    println!();
}

fn draw(motion: Motion, lines: &[Growth]) -> Drawn<PathBuf> {
    let logs = |line: &Growth| -> Vec<_> { line.points.iter().map(|(n, error)| (n.log10(), error.log10())).collect() };
    let end = lines[0].points.last().map_or(5.0, |point| point.0.log10());
    let errors = || lines.iter().flat_map(logs).map(|point| point.1);
    let low = errors().fold(-16.0, f64::min).floor();
    let high = errors().fold(-14.0, f64::max).ceil();
    let names = ["DiscreteGradient", "Kanatani", "order 4", "order 6", "order 8"];
    picture::save(file(motion), [1000, 96 + 2 * 300], |area| {
        let title = format!("{}: growth of the energy error by rounding, {} starts", motion.name(), growth::STARTS);
        let mut area = area.titled(&title, text(19.0))?;
        for words in [
            "Root mean square of the largest error until then. Light: the other schemes. Dark, straight: √n, a random walk from the first point.",
            "Orders 4, 6 and 8 are compositions of DiscreteGradient. The errors are relative to the energy at the start.",
        ] {
            area = area.titled(words, text(14.0))?;
        }
        let panels = area.split_evenly((2, 3));
        for (k, colour) in [RED, OCHRE, PURPLE, TEAL, BLUE].into_iter().enumerate() {
            let grows =
                lines[k].exponent().map_or(String::new(), |p| format!(": grows as {}", power("n", format!("{p:.2}"))));
            let x = Axis::powers_of_ten("steps n", 2.0..end);
            let y = Axis::powers_of_ten("relative energy error", low..high);
            let mut chart = picture::chart(&panels[k], &format!("{}{grows}", names[k]), x, y, 14)?;
            for other in lines {
                picture::line(&mut chart, logs(other), picture::PALE, 1.5)?;
            }
            let points = logs(&lines[k]);
            let walk = |x: f64| (x, points[0].1 + 0.5 * (x - 2.0));
            let leaves = end.min(2.0 + 2.0 * (high - points[0].1));
            picture::line(&mut chart, vec![walk(2.0), walk(leaves)], INK, 1.0)?;
            picture::line(&mut chart, points.clone(), colour, 1.5)?;
            picture::dots(&mut chart, &points, colour, 2.0)?;
        }
        Ok(())
    })
}

fn text(size: f64) -> TextStyle<'static> {
    // In quarters of a pixel; the backend divides font sizes by 1.24.
    ("sans-serif", 1.24 * size * 4.0).into_font().color(&INK)
}
