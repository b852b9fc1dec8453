//! All entrants of a motion in one picture.

use std::path::PathBuf;

use dmech_peers::{Crate, Line, Report};
use plotters::style::RGBColor;

use super::picture::{self, Axis, BLUE, Drawn, GREEN, INK, OCHRE, RED};

fn colour(by: Crate) -> RGBColor {
    match by {
        Crate::Dmech => BLUE,
        Crate::Hand => INK,
        Crate::OdeSolvers => RED,
        Crate::DifferentialEquations => OCHRE,
        Crate::Diffsol => GREEN,
    }
}

pub(crate) fn draw(report: &Report) -> Drawn<PathBuf> {
    let lines: Vec<_> = report.lines.iter().map(|line| (line, points(line))).collect();
    let lines: Vec<_> = lines.into_iter().filter(|(_, points)| points.len() > 1).collect();
    let all = || lines.iter().flat_map(|(_, points)| points);
    let fastest = all().map(|point| point.0).fold(f64::MAX, f64::min);
    let slowest = all().map(|point| point.0).fold(f64::MIN, f64::max);
    picture::save(&format!("peers_{}.svg", report.name), [1000, 760], |area| {
        let x = Axis::powers_of_ten("time, seconds", fastest.floor()..slowest + 0.5);
        let y = Axis::powers_of_ten("error of the final position", -12.0..0.0);
        let mut chart = picture::chart(area, report.title, x, y, 40)?;
        for (line, points) in &lines {
            let width = if line.by == Crate::Dmech { 2.0 } else { 1.2 };
            picture::line(&mut chart, points.clone(), colour(line.by), width)?;
            picture::dots(&mut chart, points, colour(line.by), 1.7)?;
        }
        let obstacles: Vec<_> = lines.iter().flat_map(|(_, points)| dense(points)).collect();
        let names = lines.iter().filter_map(|(line, points)| {
            Some((points.last().copied()?, line.label.to_owned(), colour(line.by)))
        });
        picture::label_clear(&chart, &obstacles, &names.collect::<Vec<_>>())?;
        let corner = (fastest.floor(), -12.0);
        let key = [
            (Crate::Dmech, "dmech: LF, DG compositions of Leapfrog and DiscreteGradient, ad. adaptive"),
            (Crate::Hand, "written by hand"),
            (Crate::OdeSolvers, "ode_solvers"),
            (Crate::DifferentialEquations, "differential-equations"),
            (Crate::Diffsol, "diffsol"),
        ];
        for (row, (by, words)) in key.into_iter().rev().enumerate() {
            picture::label(&chart, corner, (12, -14 - 18 * row as i32), words, colour(by))?;
        }
        Ok(())
    })
}

/// Logarithms of time and error, from where the error is less than the size of the motion to where it stops falling.
fn points(line: &Line) -> Vec<(f64, f64)> {
    let reached = line.runs.iter().filter_map(|(_, run)| run.as_ref().ok());
    let told = reached.map(|run| (run.time.as_secs_f64().log10(), run.error.max(1e-12).log10()));
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
