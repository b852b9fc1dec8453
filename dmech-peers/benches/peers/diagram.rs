//! All entrants of a motion in one picture.

use std::path::PathBuf;

use dmech::plot::plotters::style::RGBColor;
use dmech_peers::{Crate, Line, Report};

use super::picture::{self, Axis, BLUE, Drawn, GREEN, INK, OCHRE, PURPLE, RED};

/// The lowest error that is drawn.
const LOWEST: f64 = 1e-14;

/// Below it there is room for names and the key.
const BOTTOM: f64 = -17.0;

/// Of heyoka.
const TEAL: RGBColor = RGBColor(0, 145, 150);

fn colour(line: &Line) -> RGBColor {
    match line.by {
        // Energy-exact, and dearer.
        Crate::Dmech if line.label.starts_with("DG") => PURPLE,
        Crate::Dmech => BLUE,
        Crate::Hand => INK,
        Crate::Heyoka => TEAL,
        Crate::OdeSolvers => RED,
        Crate::DifferentialEquations => OCHRE,
        Crate::Diffsol => GREEN,
    }
}

const KEY: [(&str, RGBColor); 7] = [
    ("dmech, explicit: LF Leapfrog, RKN Nystrom, FG ForceGradient", BLUE),
    ("dmech, energy-exact: DG DiscreteGradient; ad. adaptive", PURPLE),
    ("written by hand", INK),
    ("heyoka", TEAL),
    ("ode_solvers", RED),
    ("differential-equations", OCHRE),
    ("diffsol", GREEN),
];

/// Points all over the words of the key, where no names should be: 7 pixels to a letter on an axis of 880.
fn under_key(left: f64, right: f64) -> impl Iterator<Item = (f64, f64)> {
    let per_row = 18.0 * -BOTTOM / 650.0;
    KEY.into_iter().rev().enumerate().flat_map(move |(row, (words, _))| {
        let width = (right - left) * 7.0 * words.len() as f64 / 880.0;
        let height = BOTTOM + per_row * (0.8 + row as f64);
        (0..=60).map(move |k| (left + width * f64::from(k) / 60.0, height))
    })
}

pub(crate) fn draw(report: &Report) -> Drawn<PathBuf> {
    let lines: Vec<_> = report.lines.iter().map(|line| (line, points(line))).collect();
    let lines: Vec<_> = lines.into_iter().filter(|(_, points)| points.len() > 1).collect();
    let all = || lines.iter().flat_map(|(_, points)| points);
    let fastest = all().map(|point| point.0).fold(f64::MAX, f64::min);
    let slowest = all().map(|point| point.0).fold(f64::MIN, f64::max);
    picture::save(&format!("peers_{}.svg", report.name), [1000, 760], |area| {
        let x = Axis::powers_of_ten("time, seconds", fastest.floor()..slowest + 0.5);
        let y = Axis::powers_of_ten("error of the final position", BOTTOM..0.0);
        let mut chart = picture::chart(area, report.title, x, y, 40)?;
        for (line, points) in &lines {
            let width = if line.by == Crate::Dmech { 2.0 } else { 1.2 };
            picture::line(&mut chart, points.clone(), colour(line), width)?;
            picture::dots(&mut chart, points, colour(line), 1.7)?;
        }
        let left = fastest.floor();
        for (row, (words, colour)) in KEY.into_iter().rev().enumerate() {
            picture::label(&chart, (left, BOTTOM), (12, -14 - 18 * row as i32), words, colour)?;
        }
        let lines_and_key = lines.iter().flat_map(|(_, points)| dense(points)).chain(under_key(left, slowest + 0.5));
        let names = lines
            .iter()
            .filter_map(|(line, points)| Some((points.last().copied()?, line.label.to_owned(), colour(line))));
        picture::label_clear(&chart, &lines_and_key.collect::<Vec<_>>(), &names.collect::<Vec<_>>())
    })
}

/// Logarithms of time and error, from where the error is less than the size of the motion to where it stops falling.
fn points(line: &Line) -> Vec<(f64, f64)> {
    let reached = line.runs.iter().filter_map(|(_, run)| run.as_ref().ok());
    let told = reached.map(|run| (run.time.as_secs_f64().log10(), run.error.max(LOWEST).log10()));
    let mut points: Vec<_> = told.collect();
    let lost = points.iter().rposition(|point| point.1 > 0.0);
    points.drain(..lost.map_or(0, |lost| lost + 1));
    let stalls = |pair: &[(f64, f64)]| pair[1].1 < -9.5 && pair[1].1 > pair[0].1 - 0.1;
    let end = points.windows(2).position(stalls);
    points.truncate(end.map_or(points.len(), |end| end + 1));
    points
}

/// Points on a line, close together.
fn dense(points: &[(f64, f64)]) -> impl Iterator<Item = (f64, f64)> {
    let between = |pair: &[(f64, f64)], k: i32| {
        let part = f64::from(k) / 30.0;
        (pair[0].0 + part * (pair[1].0 - pair[0].0), pair[0].1 + part * (pair[1].1 - pair[0].1))
    };
    points.windows(2).flat_map(move |pair| (0..30).map(move |k| between(pair, k)))
}
