//! Time against error: which scheme is the fastest at the accuracy that is wanted?
//!
//! ```text
//! cargo run --release --example work_precision
//! ```
//!
//! Two motions with known solutions: Greenspan's planet, an ellipse of eccentricity 0.33, followed for 87 orbits to
//! t = 350, and his undamped pendulum from π/4 at rest, to t = 100. Each scheme runs with smaller and smaller steps until
//! its error stops falling or a run takes two million forces.
//!
//! A scheme of order p pays 10^(1/p) times the time for one more digit: on paper with two logarithmic axes it is a line
//! of slope −p. So the cheap step of leap-frog wins where a rough answer will do, and high order where it will not; the
//! energy-exact schemes pay for a nonlinear solve in each step, and their column of energy drifts shows what for.
//!
//! The program prints a table for each motion, and writes the rows as CSV and the lines as a picture.

#[path = "shared/picture.rs"]
mod picture;

use std::f64::consts::FRAC_PI_4;

use dmech::StudyReport;
use dmech::models::{Kepler, Pendulum};
use dmech::prelude::*;
use picture::{Axis, BLUE, Drawn, GREEN, OCHRE, RED};
use plotters::style::RGBColor;

fn main() -> Drawn {
    show("work_precision_orbit", "Greenspan's orbit to t = 350", &orbit()?)?;
    show("work_precision_pendulum", "Pendulum from π/4 to t = 100", &pendulum()?)
}

fn orbit() -> Result<StudyReport, Error> {
    let law = Kepler { gm: 1.0 };
    let half_axis = 1.0 / (2.0 / 0.5 - 1.63 * 1.63);
    let eccentricity = 1.0 - 0.5 / half_axis;
    let study = Study::new(law, State::new([0.5, 0.0], [0.0, 1.63]), 350.0);
    all_schemes(study).exact(|t| law.exact(half_axis, eccentricity, t)).run()
}

fn pendulum() -> Result<StudyReport, Error> {
    let law = Pendulum { k: 1.0 };
    let study = Study::new(law, State::new([FRAC_PI_4], [0.0]), 100.0);
    all_schemes(study).exact(|t| [law.exact(FRAC_PI_4, t)]).run()
}

/// In the order of [`LINES`].
fn all_schemes<'a, L, const D: usize>(study: Study<'a, L, D>) -> Study<'a, L, D>
where
    L: Law<D> + VelocityIndependent + Clone + 'a,
{
    study
        .scheme(Leapfrog)
        .scheme(Implicit)
        .scheme(DiscreteGradient)
        .scheme(Kanatani)
        .scheme(Composed::order4(Leapfrog))
        .scheme(Composed::order6(Leapfrog))
        .scheme(Composed::order8(Leapfrog))
        .scheme(Composed::order4(DiscreteGradient))
        .scheme(Composed::order6(DiscreteGradient))
        .scheme(Composed::order8(DiscreteGradient))
}

/// What the lines are called, their colours (one for each scheme of order two), and at which error the name stands.
const LINES: [(&str, RGBColor, f64); 10] = [
    ("Leapfrog", BLUE, 1e-4),
    ("Implicit", GREEN, 1e-2),
    ("DiscreteGradient", RED, 1e-4),
    ("Kanatani", OCHRE, 1e-3),
    ("Leapfrog 4", BLUE, 1e-7),
    ("Leapfrog 6", BLUE, 1e-8),
    ("Leapfrog 8", BLUE, 1e-9),
    ("DiscreteGradient 4", RED, 1e-7),
    ("DiscreteGradient 6", RED, 1e-8),
    ("DiscreteGradient 8", RED, 1e-9),
];

fn show(name: &str, title: &str, report: &StudyReport) -> Drawn {
    println!("{title}\n{report}");
    let csv = picture::place(&format!("{name}.csv"))?;
    report.save_csv(&csv)?;
    let svg = draw(&format!("{name}.svg"), title, report)?;
    println!("Rows: {}\nPicture: {}\n", csv.display(), svg.display());
    Ok(())
}

fn draw(name: &str, title: &str, report: &StudyReport) -> Drawn<std::path::PathBuf> {
    let lines: Vec<_> = (0..LINES.len()).map(|scheme| points(report, scheme)).collect();
    let all = || lines.iter().flatten();
    let bounds = |of: fn(&(f64, f64)) -> f64| {
        let (least, most) = all().map(of).fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
        least.floor()..most.ceil()
    };
    picture::save(name, [900, 640], |area| {
        let title = format!("{title}: time for an error");
        let x = Axis::powers_of_ten("time, seconds", bounds(|p| p.0));
        let y = Axis::powers_of_ten("error of the final position", bounds(|p| p.1));
        let mut chart = picture::chart(area, &title, x, y, 130)?;
        for (points, (_, colour, _)) in lines.iter().zip(LINES) {
            picture::line(&mut chart, points.clone(), colour, 1.5)?;
            picture::dots(&mut chart, points, colour, 2.0)?;
        }
        let obstacles: Vec<_> = lines.iter().flat_map(|points| dense(points)).collect();
        let labels: Vec<_> = lines
            .iter()
            .zip(LINES)
            .filter_map(|(points, (name, colour, error))| Some((nearest(points, error)?, name.to_owned(), colour)))
            .collect();
        picture::label_clear(&chart, &obstacles, &labels)
    })
}

/// Logarithms of time and error, where the error means something: not more than the size of the motion.
fn points(report: &StudyReport, scheme: usize) -> Vec<(f64, f64)> {
    let figures = report.rows_of(scheme).filter_map(|row| row.result().ok());
    let told = figures.filter(|figures| figures.error() < 1.0 && figures.error() >= report.resolution());
    told.map(|figures| (figures.time().as_secs_f64().log10(), figures.error().log10())).collect()
}

/// Points on a line, close together.
fn dense(points: &[(f64, f64)]) -> impl Iterator<Item = (f64, f64)> {
    let between = |pair: &[(f64, f64)], k: i32| {
        let part = f64::from(k) / 40.0;
        (pair[0].0 + part * (pair[1].0 - pair[0].0), pair[0].1 + part * (pair[1].1 - pair[0].1))
    };
    points.windows(2).flat_map(move |pair| (0..40).map(move |k| between(pair, k)))
}

fn nearest(points: &[(f64, f64)], error: f64) -> Option<(f64, f64)> {
    let away = |point: &(f64, f64)| (point.1 - error.log10()).abs();
    points.iter().copied().min_by(|a, b| away(a).total_cmp(&away(b)))
}
