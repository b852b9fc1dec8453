//! Time against error: which scheme is the fastest at the accuracy that is wanted?
//!
//! ```text
//! cargo run --release --example work_precision
//! ```
//!
//! Two motions with known solutions: Greenspan's planet, an ellipse of eccentricity 0.33, followed for 87 orbits to
//! t = 350, and his undamped pendulum from π/4 at rest, to t = 100. Each scheme runs with smaller and smaller steps
//! until its error stops falling or a run takes two million forces.
//!
//! A scheme of order p pays 10^(1/p) times the time for one more digit: on paper with two logarithmic axes it is a line
//! of slope −p. So the cheap step of leap-frog wins where a rough answer will do, and high order where it will not; the
//! energy-exact schemes pay for a nonlinear solve in each step, and their column of energy drifts shows what for.
//!
//! The program prints a table for each motion, and writes the rows as CSV and the lines as a picture.

#[path = "shared/picture.rs"]
mod picture;

use std::f64::consts::FRAC_PI_4;
use std::path::PathBuf;

use dmech::StudyReport;
use dmech::models::{Kepler, Pendulum};
use dmech::prelude::*;
use picture::{Axis, BLUE, Drawn, GREEN, INK, OCHRE, RED};
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

/// What the lines are called at their ends, and their colours, one for each scheme of order two.
const LINES: [(&str, RGBColor); 10] = [
    ("Leapfrog", BLUE),
    ("Implicit", GREEN),
    ("DiscreteGradient", RED),
    ("Kanatani", OCHRE),
    ("4", BLUE),
    ("6", BLUE),
    ("8", BLUE),
    ("4", RED),
    ("6", RED),
    ("8", RED),
];

fn show(name: &str, title: &str, report: &StudyReport) -> Drawn {
    println!("{title}\n{report}");
    let csv = picture::place(&format!("{name}.csv"))?;
    report.save_csv(&csv)?;
    let svg = draw(&format!("{name}.svg"), title, report)?;
    println!("Rows: {}\nPicture: {}\n", csv.display(), svg.display());
    Ok(())
}

fn draw(name: &str, title: &str, report: &StudyReport) -> Drawn<PathBuf> {
    let lines: Vec<_> = (0..LINES.len()).map(|scheme| points(report, scheme)).collect();
    let bounds = |of: fn(&(f64, f64)) -> f64| {
        let values = lines.iter().flatten().map(of);
        values.fold((f64::MAX, f64::MIN), |(least, most), x| (x.min(least), x.max(most)))
    };
    let ((fastest, slowest), (least, _)) = (bounds(|p| p.0), bounds(|p| p.1));
    picture::save(name, [900, 640], |area| {
        let title = format!("{title}: time for an error");
        // Room for a name beyond the slowest and below the most accurate run.
        let x = Axis::powers_of_ten("time, seconds", fastest.floor()..slowest + 0.7);
        let y = Axis::powers_of_ten("error of the final position", (least - 0.7).floor()..0.0);
        let mut chart = picture::chart(area, &title, x, y, 60)?;
        for (points, (_, colour)) in lines.iter().zip(LINES) {
            picture::line(&mut chart, points.clone(), colour, 1.5)?;
            picture::dots(&mut chart, points, colour, 2.0)?;
        }
        let obstacles: Vec<_> = lines.iter().flat_map(|points| dense(points)).collect();
        let end = |points: &Vec<(f64, f64)>| points.last().copied();
        // From the highest order down: the names of steep lines have the least room.
        let names = lines.iter().zip(LINES).rev();
        let labels = names.filter_map(|(points, (name, colour))| Some((end(points)?, name.to_owned(), colour)));
        picture::label_clear(&chart, &obstacles, &labels.collect::<Vec<_>>())?;
        let corner = (fastest.floor(), (least - 0.7).floor());
        picture::label(&chart, corner, (12, -36), "4, 6, 8: compositions of that order", INK)?;
        picture::label(&chart, corner, (12, -18), "of Leapfrog and DiscreteGradient", INK)
    })
}

/// Logarithms of time and error: from where the error is less than the size of the motion to where it stops falling, as
/// what follows is rounding.
fn points(report: &StudyReport, scheme: usize) -> Vec<(f64, f64)> {
    let figures = report.rows_of(scheme).filter_map(|row| row.result().ok());
    let told = figures.take_while(|figures| figures.error() >= 1e-13);
    let mut points: Vec<_> =
        told.map(|figures| (figures.time().as_secs_f64().log10(), figures.error().log10())).collect();
    let lost = points.iter().rposition(|point| point.1 > 0.0);
    points.drain(..lost.map_or(0, |lost| lost + 1));
    // The step is halved and the error, which is small, is not.
    let stalls = |pair: &[(f64, f64)]| pair[1].1 < -8.0 && pair[1].1 > pair[0].1 - 0.3;
    let end = points.windows(2).position(stalls);
    points.truncate(end.map_or(points.len(), |end| end + 1));
    points
}

/// Points on a line, close together.
fn dense(points: &[(f64, f64)]) -> impl Iterator<Item = (f64, f64)> {
    let between = |pair: &[(f64, f64)], k: i32| {
        let part = f64::from(k) / 40.0;
        (pair[0].0 + part * (pair[1].0 - pair[0].0), pair[0].1 + part * (pair[1].1 - pair[0].1))
    };
    points.windows(2).flat_map(move |pair| (0..40).map(move |k| between(pair, k)))
}
