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
//! `work_precision.html`. It takes about a minute.

#[path = "shared/page.rs"]
mod page;
#[path = "shared/picture.rs"]
mod picture;

use std::f64::consts::FRAC_PI_4;

use dmech::extend::AtStages;
use dmech::models::{Anharmonic, HenonHeiles, Kepler, Morse, Pendulum};
use dmech::prelude::*;
use dmech::{StudyError, StudyReport};
use page::Section;
use picture::Drawn;

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
    let mut sections = Vec::new();
    for (name, title, words, study) in MOTIONS {
        println!("{title}");
        let report = study()?;
        println!("{report}");
        let csv = picture::place(&format!("work_precision_{name}.csv"))?;
        report.save_csv(&csv)?;
        let svg = picture::place(&format!("work_precision_{name}.svg"))?;
        report.plot_titled(&svg, &format!("{title}: time for an error"))?;
        println!("Rows: {}\nPicture: {}\n", csv.display(), svg.display());
        sections.push(Section { title, words, picture: svg, report });
    }
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
