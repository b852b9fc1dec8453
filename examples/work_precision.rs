//! Time against error: which scheme is the fastest at the accuracy that is wanted?
//!
//! ```text
//! cargo run --release --example work_precision
//! ```
//!
//! Six motions: Greenspan's planet, an ellipse of eccentricity 0.33, followed for 87 orbits to t = 350; an ellipse of
//! eccentricity 0.9 for ten periods; Greenspan's undamped pendulum from π/4 at rest, to t = 100; a star in the potential of
//! Hénon and Heiles; the vibration of a molecule after Morse; a particle in an anharmonic well in space. Each scheme runs
//! with smaller and smaller steps, or tolerances, until its error stops falling or a run takes two million forces.
//!
//! A scheme of order p pays 10^(1/p) times the time for one more digit: on paper with two logarithmic axes it is a line
//! of slope −p. So the cheap step of leap-frog wins where a rough answer will do, and high order where it will not; the
//! energy-exact schemes pay for a nonlinear solve in each step, and their column of energy drifts shows what for.
//!
//! The program prints a table for each motion, writes the rows as CSV and the lines as a picture, and collects all in
//! `work_precision.html`. It takes about a minute and a half.

#[path = "shared/page.rs"]
mod page;
#[path = "shared/picture.rs"]
mod picture;

use std::f64::consts::FRAC_PI_4;
use std::path::PathBuf;

use std::time::Duration;

use dmech::extend::AtStages;
use dmech::models::{Anharmonic, HenonHeiles, Kepler, Morse, Pendulum};
use dmech::plot::plotters::style::RGBColor;
use dmech::prelude::*;
use dmech::{StudyError, StudyReport};
use indicatif::{ProgressBar, ProgressStyle};
use page::Section;
use picture::{Axis, BLUE, Drawn, GREEN, INK, OCHRE, PURPLE, RED, TEAL};

/// What a motion is called, what is to be seen in it, and its study.
type Motion = (&'static str, &'static str, &'static str, fn() -> Result<StudyReport, StudyError>);

const MOTIONS: [Motion; 6] = [
    (
        "orbit",
        "Greenspan's orbit to t = 350",
        "A planet of eccentricity 0.33 for 87 periods; the exact ellipse is known.",
        orbit,
    ),
    (
        "eccentric",
        "Ellipse of eccentricity 0.9, ten periods",
        "Equal steps must be as short everywhere as the pericentre asks; steps that follow the motion need not.",
        eccentric,
    ),
    ("pendulum", "Pendulum from π/4 to t = 100", "One dimension, where all forces are cheap.", pendulum),
    (
        "henon_heiles",
        "Hénon–Heiles to t = 100",
        "A star in a galaxy, with energy 1/12: no exact solution.",
        henon_heiles,
    ),
    (
        "morse",
        "Morse's molecule to t = 100",
        "A vibration halfway to dissociation; the exact solution is known.",
        morse,
    ),
    ("anharmonic", "Anharmonic well in space to t = 100", "Three coordinates coupled by quartic terms.", anharmonic),
];

fn main() -> Drawn {
    let bar = ProgressBar::new(MOTIONS.len() as u64);
    bar.set_style(ProgressStyle::with_template("{bar:24} {pos}/{len}  {msg}  {elapsed}")?);
    bar.enable_steady_tick(Duration::from_millis(200));
    let mut sections = Vec::new();
    for (name, title, words, study) in MOTIONS {
        bar.set_message(title);
        let report = study()?;
        bar.suspend(|| println!("{title}\n{report}"));
        let csv = picture::place(&format!("work_precision_{name}.csv"))?;
        report.save_csv(&csv)?;
        let svg = draw(&format!("work_precision_{name}.svg"), title, &report)?;
        bar.suspend(|| println!("Rows: {}\nPicture: {}\n", csv.display(), svg.display()));
        sections.push(Section { title, words, picture: svg, report });
        bar.inc(1);
    }
    bar.finish_and_clear();
    println!("Page: {}", page::save("work_precision.html", &sections)?.display());
    Ok(())
}

fn orbit() -> Result<StudyReport, StudyError> {
    let law = Kepler { gm: 1.0 };
    let half_axis = 1.0 / (2.0 / 0.5 - 1.63 * 1.63);
    let eccentricity = 1.0 - 0.5 / half_axis;
    let study = Study::new(law, State::new([0.5, 0.0], [0.0, 1.63]), 350.0);
    all_schemes(study).exact(|t| law.exact(half_axis, eccentricity, t)).run()
}

fn eccentric() -> Result<StudyReport, StudyError> {
    let law = Kepler { gm: 1.0 };
    let period = law.period(1.0);
    // From the apocentre, half a period after the pericentre that `exact` starts from.
    let study = Study::new(law, State::new([-1.9, 0.0], [0.0, -(0.1_f64 / 1.9).sqrt()]), 10.0 * period);
    all_schemes(study).exact(|t| law.exact(1.0, 0.9, t + 0.5 * period)).run()
}

fn pendulum() -> Result<StudyReport, StudyError> {
    let law = Pendulum { k: 1.0 };
    let study = Study::new(law, State::new([FRAC_PI_4], [0.0]), 100.0);
    all_schemes(study).exact(|t| [law.exact(FRAC_PI_4, t)]).run()
}

fn henon_heiles() -> Result<StudyReport, StudyError> {
    let law = HenonHeiles { lambda: 1.0 };
    all_schemes(Study::new(law, State::new([0.0, 0.1], [0.39, 0.08]), 100.0)).precise().run()
}

fn morse() -> Result<StudyReport, StudyError> {
    let (law, energy) = (Morse::default(), 0.5);
    let study = Study::new(law, State::new([law.exact(energy, 0.0)], [0.0]), 100.0);
    all_schemes(study).exact(|t| [law.exact(energy, t)]).run()
}

fn anharmonic() -> Result<StudyReport, StudyError> {
    let start = State::new([0.8, -0.5, 0.3], [0.2, 0.4, -0.6]);
    all_schemes(Study::new(Anharmonic::default(), start, 100.0)).precise().run()
}

/// In the order of [`LINES`].
fn all_schemes<'a, L, const D: usize>(study: Study<'a, L, State<D>>) -> Study<'a, L, State<D>>
where
    L: AtStages<D, f64> + VelocityIndependent + Clone + 'a,
{
    let tolerances = || (2..=26).map(|k| 10_f64.powf(-0.5 * f64::from(k)));
    study
        .repetitions(3)
        .scheme(Leapfrog)
        .scheme(Implicit)
        .scheme(DiscreteGradient)
        .scheme(Kanatani)
        .scheme(Composed::order4(Leapfrog))
        .scheme(Composed::order6(Leapfrog))
        .scheme(Composed::order8(Leapfrog))
        .scheme(Nystrom::order4())
        .scheme(Nystrom::order6())
        .scheme(Nystrom::order8())
        .scheme(ForceGradient::order4())
        .scheme(ForceGradient::order6())
        .scheme(ForceGradient::order8())
        .scheme(Composed::order4(DiscreteGradient))
        .scheme(Composed::order6(DiscreteGradient))
        .scheme(Composed::order8(DiscreteGradient))
        .adaptive(Nystrom::order6(), tolerances())
        .adaptive(ForceGradient::order8(), tolerances())
        .adaptive(Composed::order6(DiscreteGradient), tolerances())
        .adaptive(Composed::order8(DiscreteGradient), tolerances())
        .scheme(LineIntegral::order4())
        .scheme(LineIntegral::order8())
        .scheme(LineIntegral::order10())
        .scheme(Gauss::order16())
        .adaptive(Gauss::order16(), tolerances())
}

/// What the lines are called at their ends, and their colours, one for each family.
const LINES: [(&str, RGBColor); 25] = [
    ("Leapfrog", BLUE),
    ("Implicit", INK),
    ("DiscreteGradient", RED),
    ("Kanatani", INK),
    ("4", BLUE),
    ("6", BLUE),
    ("8", BLUE),
    ("N4", GREEN),
    ("N6", GREEN),
    ("N8", GREEN),
    ("F4", OCHRE),
    ("F6", OCHRE),
    ("F8", OCHRE),
    ("4", RED),
    ("6", RED),
    ("8", RED),
    ("AN6", PURPLE),
    ("AF8", PURPLE),
    ("A6", PURPLE),
    ("A8", PURPLE),
    ("L4", TEAL),
    ("L8", TEAL),
    ("L10", TEAL),
    ("G16", TEAL),
    ("AG16", PURPLE),
];

fn draw(name: &str, title: &str, report: &StudyReport) -> Drawn<PathBuf> {
    let lines: Vec<_> = (0..LINES.len()).map(|scheme| points(report, scheme)).collect();
    let bounds = |of: fn(&(f64, f64)) -> f64| {
        let values = lines.iter().flatten().map(of);
        values.fold((f64::MAX, f64::MIN), |(least, most), x| (x.min(least), x.max(most)))
    };
    let ((fastest, slowest), (least, _)) = (bounds(|p| p.0), bounds(|p| p.1));
    picture::save(name, [900, 680], |area| {
        let title = format!("{title}: time for an error");
        // Room for a name beyond the slowest and below the most accurate run.
        let x = Axis::powers_of_ten("time, seconds", fastest.floor()..slowest + 0.7);
        let y = Axis::powers_of_ten("error of the final position", (least - 1.5).floor()..0.0);
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
        let corner = (fastest.floor(), (least - 1.5).floor());
        let key = [
            ("4, 6, 8: Composed(Leapfrog)", BLUE),
            ("4, 6, 8: Composed(DiscreteGradient)", RED),
            ("N: Nystrom", GREEN),
            ("F: ForceGradient", OCHRE),
            ("L: LineIntegral, G: Gauss", TEAL),
            ("A: steps that follow the motion, of Composed(DiscreteGradient), N, F, G", PURPLE),
        ];
        for (row, (words, colour)) in key.iter().rev().enumerate() {
            picture::label(&chart, corner, (12, -18 - 17 * row as i32), words, *colour)?;
        }
        Ok(())
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
