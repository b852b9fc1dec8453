//! How fast do rounding errors grow in the energy?
//!
//! ```text
//! cargo run --release --example round_off                10⁵ steps of each scheme, some seconds
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

use dmech::prelude::*;
use growth::{Growth, Motion};
use picture::{Axis, BLUE, Drawn, GREEN, INK, OCHRE, PURPLE, RED};

fn main() -> Drawn {
    let decades = std::env::args().nth(1).map_or(Ok(5), |n| n.parse())?;
    let wanted = std::env::args().nth(2).unwrap_or_default().to_lowercase();
    let motions: Vec<_> = Motion::ALL.into_iter().filter(|motion| file(*motion).contains(&wanted)).collect();
    if motions.is_empty() {
        return Err(format!("no motion is called {wanted}: there are kepler, components, henon and chain").into());
    }
    for motion in motions {
        let lines = [
            motion.growth(DiscreteGradient, Invariant::Energy, decades)?,
            motion.growth(Kanatani, Invariant::DiscreteEnergy, decades)?,
            motion.growth(Composed::order4(DiscreteGradient), Invariant::Energy, decades)?,
            motion.growth(Composed::order6(DiscreteGradient), Invariant::Energy, decades)?,
            motion.growth(Composed::order8(DiscreteGradient), Invariant::Energy, decades)?,
        ];
        print(motion, &lines);
        println!("Picture: {}\n", draw(motion, &lines)?.display());
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
    let highest = lines.iter().flat_map(logs).map(|point| point.1).fold(-14.0, f64::max);
    picture::save(file(motion), [860, 560], |area| {
        let title = format!("{}: growth of the energy error by rounding", motion.name());
        let x = Axis::powers_of_ten("steps", 2.0..end);
        let y = Axis::powers_of_ten("relative error of the energy", -17.0..highest.ceil() + 0.5);
        let mut chart = picture::chart(area, &title, x, y, 150)?;
        // What a random walk would do.
        let walk = (end, -16.5 + 0.5 * (end - 2.0));
        picture::line(&mut chart, vec![(2.0, -16.5), walk], picture::PALE, 2.0)?;
        let names = ["DiscreteGradient", "Kanatani", "order 4", "order 6", "order 8"];
        let mut ends = vec![(walk, "√n", INK)];
        for ((line, name), colour) in lines.iter().zip(names).zip([RED, OCHRE, BLUE, GREEN, PURPLE]) {
            let points = logs(line);
            ends.push((*points.last().expect("points"), name, colour));
            picture::line(&mut chart, points.clone(), colour, 1.5)?;
            picture::dots(&mut chart, &points, colour, 2.0)?;
        }
        picture::name_ends(&chart, ends)
    })
}
