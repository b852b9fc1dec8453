//! Studies on the terminal, in at most 100 columns.

use core::fmt;
use std::time::Duration;

use dmech_core::Invariant;

use super::interpolate::Cost;
use super::report::{StudyReport, seconds};
use super::row::{Figures, StudyRow};

/// The errors of the summary.
const GOALS: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// Columns of a cause.
const WIDTH: usize = 96;

impl fmt::Display for StudyReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [start, end] = self.span();
        writeln!(
            f,
            "Error |q − q*| at t = {}, from t = {}; time: shortest of several; drifts: largest",
            until(start, end),
            time(start)
        )?;
        match self.reference() {
            None => writeln!(f, "q*: exact")?,
            Some(reference) => {
                let (mean, change) = match reference.is_precise() {
                    true => ("mean ", "a tolerance 1000 times smaller"),
                    false => ("", "halving its step"),
                };
                writeln!(f, "q*: {}, {mean}dt = {:.3e}", reference.scheme(), reference.dt())?;
                writeln!(f, "    {change} has last moved it by {}", size(reference.error()))?;
            }
        }
        let shown = self.invariants();
        write!(f, "\n  {:>9} {:>9} {:>10} {:>9} {:>8} {:>5}", "dt", "steps", "forces", "time", "error", "order")?;
        for &invariant in &shown {
            write!(f, " {:>9}", short(invariant))?;
        }
        writeln!(f)?;
        for (scheme, (name, order)) in self.schemes().iter().enumerate() {
            writeln!(f, "{name}, order {order}")?;
            let mut before: Option<(f64, f64)> = None;
            for row in self.rows_of(scheme) {
                let step = row.tolerance().map_or_else(|| format!("{:.3e}", row.dt()), |it| format!("tol {it:.0e}"));
                write!(f, "  {step:>9} {:>9}", row.steps())?;
                match row.result() {
                    Ok(figures) => {
                        let here = (row.dt(), figures.error());
                        let order = before.replace(here).and_then(|before| order_between(before, here));
                        self.write_figures(f, figures, order)?;
                        write_drifts(f, figures, &shown)?;
                    }
                    Err(cause) => {
                        before = None;
                        writeln!(f, " failed")?;
                        write_cause(f, &cause.to_string())?;
                    }
                }
            }
        }
        self.write_summary(f)
    }
}

/// The size of an error, of which there is none at rest where all numbers are 0.
fn size(error: f64) -> String {
    if error < f64::MIN_POSITIVE { "0".to_owned() } else { format!("{error:.1e}") }
}

impl StudyReport {
    /// The invariants that some run has.
    fn invariants(&self) -> Vec<Invariant> {
        let has = |row: &StudyRow, i| row.result().is_ok_and(|figures| figures.drift(i).is_some());
        Invariant::ALL.into_iter().filter(|&i| self.rows().iter().any(|row| has(row, i))).collect()
    }

    fn write_figures(&self, f: &mut fmt::Formatter<'_>, figures: &Figures, order: Option<f64>) -> fmt::Result {
        let known = figures.error() >= self.resolution();
        let least = size(figures.error().max(self.resolution()));
        let error = if known || least == "0" { least } else { format!("<{least}") };
        let order = order.filter(|order| known && order.is_finite());
        let order = order.map_or("–".to_owned(), |order| format!("{order:.2}"));
        write!(f, " {:>10} {:>9} {error:>8} {order:>5}", figures.evaluations(), duration(figures.time()))
    }

    fn write_summary(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\n{:<54}", "Time to an error of")?;
        for goal in GOALS {
            write!(f, " {:>10}", format!("{goal:.0e}"))?;
        }
        writeln!(f)?;
        let times = GOALS.map(|goal| self.times_at(goal).collect::<Vec<_>>());
        for (scheme, (name, _)) in self.schemes().iter().enumerate() {
            write!(f, "  {name:<52}")?;
            for times in &times {
                write!(f, " {:>10}", times[scheme].1.map_or("–".to_owned(), cost))?;
            }
            writeln!(f)?;
        }
        for goal in GOALS {
            let goal_name = format!("{goal:.0e}");
            match self.fastest_at(goal) {
                Some((name, time)) => writeln!(f, "fastest at {goal_name}: {name}, {}", duration(time))?,
                None => writeln!(f, "fastest at {goal_name}: not reached")?,
            }
        }
        Ok(())
    }
}

fn write_drifts(f: &mut fmt::Formatter<'_>, figures: &Figures, shown: &[Invariant]) -> fmt::Result {
    for &invariant in shown {
        let drift = figures.drift(invariant).map_or("–".to_owned(), |drift| format!("{:.1e}", drift.max_abs()));
        write!(f, " {drift:>9}")?;
    }
    writeln!(f)
}

/// Words in lines.
fn write_cause(f: &mut fmt::Formatter<'_>, cause: &str) -> fmt::Result {
    let mut line = String::new();
    for word in cause.split_whitespace() {
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > WIDTH {
            writeln!(f, "    {line}")?;
            line.clear();
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    writeln!(f, "    {line}")
}

/// The power of the step that two errors show; none where the steps, means of those that follow the motion, hardly differ.
fn order_between((h0, e0): (f64, f64), (h1, e1): (f64, f64)) -> Option<f64> {
    (h0 > 1.1 * h1).then(|| (e0 / e1).ln() / (h0 / h1).ln())
}

/// A bound where the largest step of the ladder already reaches the error.
fn cost(cost: Cost) -> String {
    let time = duration(seconds(cost.value()));
    if let Cost::AtMost(_) = cost { format!("≤{time}") } else { time }
}

/// A time in as many characters as a line has room for.
fn time(t: f64) -> String {
    let whole = t.to_string();
    if whole.len() <= 12 { whole } else { format!("{t:.6e}") }
}

/// The end, with what is added to the start where the characters do not tell them apart.
fn until(start: f64, end: f64) -> String {
    let (first, last) = (time(start), time(end));
    if first == last { format!("{first} + {}", time(end - start)) } else { last }
}

fn duration(time: Duration) -> String {
    format!("{time:.2?}")
}

fn short(invariant: Invariant) -> &'static str {
    match invariant {
        Invariant::Energy => "energy",
        Invariant::DiscreteEnergy => "discr. E",
        Invariant::WorkEnergy => "K − work",
        Invariant::LinearMomentum => "momentum",
        Invariant::AngularMomentum => "ang. mom.",
        _ => "other",
    }
}
