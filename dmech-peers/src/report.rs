//! Tables, comparisons and rows.

use core::fmt::Write as _;
use std::io::{self, Write};

use dmech::study::Cost;

use crate::entrant::Crate;
use crate::measure::Line;
use crate::recommended::{Kind, recommended};

/// The errors that are asked for.
pub const GOALS: [f64; 5] = [1e-3, 1e-6, 1e-9, 1e-11, 1e-12];

/// What was measured of a motion.
#[derive(Clone, Debug)]
pub struct Report {
    /// In names of files.
    pub name: &'static str,
    /// Of the motion.
    pub title: &'static str,
    /// What the advice depends on.
    pub kind: Kind,
    /// One for each entrant.
    pub lines: Vec<Line>,
}

impl Report {
    /// Milliseconds, and evaluations of the force, to each goal for every entrant.
    pub fn table(&self) -> String {
        let goals: String = GOALS.iter().map(|goal| format!(" {goal:>8.0e}")).collect();
        let (times, forces) = ("milliseconds to an error of", "forces");
        let mut table = format!("{:<52} {times:>45}  {forces:>45}\n{:<52}{goals}  {goals}\n", self.title, "");
        let mut by = None;
        for line in &self.lines {
            if by.replace(line.by) != Some(line.by) {
                let _ = writeln!(table, "{}", line.by.name());
            }
            let _ = write!(table, "  {:<50}", line.name);
            for goal in GOALS {
                let _ = write!(table, " {:>8}", line.time_at(goal).map_or("–".to_owned(), milliseconds));
            }
            let _ = write!(table, " ");
            for goal in GOALS {
                let forces = line.evaluations_at(goal).map(|cost| format!("{:.0}", cost.value()));
                let _ = write!(table, " {:>8}", forces.as_deref().unwrap_or("–"));
            }
            let _ = writeln!(table);
        }
        table
    }

    /// The fastest of a crate at an error: name and milliseconds.
    pub fn best(&self, by: Crate, goal: f64) -> Option<(&str, Cost)> {
        let lines = self.lines.iter().filter(|line| line.by == by);
        let times = lines.filter_map(|line| line.time_at(goal).map(|time| (line.name.as_str(), time)));
        times.min_by(|a, b| a.1.value().total_cmp(&b.1.value()))
    }

    /// Milliseconds of the scheme that is advised for an error, which is chosen before anything is measured.
    pub fn advised(&self, goal: f64) -> (&'static str, Option<Cost>) {
        let name = recommended(goal, self.kind);
        let line = self.lines.iter().find(|line| line.by == Crate::Dmech && line.label == name);
        (name, line.and_then(|line| line.time_at(goal)))
    }

    /// For each goal: the advised scheme and the best of dmech, and how many times as long as each of them the best of another
    /// program takes.
    pub fn ratios(&self) -> String {
        let mut table = String::new();
        let dash = || "–".to_owned();
        for goal in GOALS {
            let best = self.best(Crate::Dmech, goal);
            let (advised, own) = self.advised(goal);
            let (name, least) = best.map_or(("–", None), |(name, cost)| (name, Some(cost)));
            let _ = write!(table, "  {goal:<6.0e} {:>9}", own.map_or_else(dash, milliseconds));
            let _ = write!(table, " {:>9}", least.map_or_else(dash, milliseconds));
            for by in Crate::PEERS.into_iter().chain([Crate::Hand]) {
                let peer = self.best(by, goal).map(|(_, time)| time.value());
                let over = |own: Option<Cost>| match (peer, own) {
                    (Some(peer), Some(own)) => format!("{:.2}", peer / own.value()),
                    _ => dash(),
                };
                let behind = peer.zip(least).is_some_and(|(peer, least)| peer < least.value());
                let ratios = format!("{} {}{}", over(own), over(least), if behind { " *" } else { "" });
                let _ = write!(table, " {ratios:>15}");
            }
            let _ = writeln!(table, "   {advised} | {name}");
        }
        table
    }

    /// Where the best of another crate is faster, in words.
    pub fn behind(&self) -> Vec<String> {
        let mut behind = Vec::new();
        for goal in GOALS {
            for by in Crate::PEERS {
                let Some((peer, time)) = self.best(by, goal) else { continue };
                match self.best(Crate::Dmech, goal) {
                    Some((name, own)) if own.value() > time.value() => behind.push(format!(
                        "{}, error {goal:.0e}: {} ({peer}) takes {} ms, dmech ({name}) {} ms: {:.2} times as long",
                        self.title,
                        by.name(),
                        milliseconds(time),
                        milliseconds(own),
                        own.value() / time.value()
                    )),
                    Some(_) => {}
                    None => behind.push(format!("{}: dmech does not reach {goal:.0e}", self.title)),
                }
            }
        }
        behind
    }

    /// One row for each run.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_csv(&self, to: &mut impl Write) -> io::Result<()> {
        for line in &self.lines {
            for (knob, run) in &line.runs {
                let id = format!("{},{},\"{}\",{knob:e}", self.name, line.by.name(), line.name);
                match run {
                    Ok(run) => {
                        let seconds = run.time.as_secs_f64();
                        writeln!(to, "{id},{},{seconds:e},{:e},", run.evaluations, run.error)?;
                    }
                    Err(cause) => writeln!(to, "{id},,,,\"{}\"", cause.replace('"', "'").replace('\n', " "))?,
                }
            }
        }
        Ok(())
    }

    /// The head of those rows.
    pub const COLUMNS: &str = "motion,crate,entrant,steps_or_tolerance,evaluations,seconds,error,failure";
}

/// Three digits; a bound where the coarsest run is already good enough.
fn milliseconds(cost: Cost) -> String {
    let value = cost.value();
    let digits = (2 - value.log10().floor() as i32).clamp(0, 4) as usize;
    let bound = if let Cost::AtMost(_) = cost { "≤" } else { "" };
    format!("{bound}{value:.digits$}")
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::entrant::Finish;

    /// Two crates whose lines cross between 1e-6 and 1e-9: times c e^(−1/p).
    fn report() -> Report {
        let line = |by, name: &str, c: f64, p: f64| {
            let finish = |error: f64| {
                let time = Duration::from_secs_f64(1e-6 * c * error.powf(-1.0 / p));
                (error, Ok(Finish { error, evaluations: 1, time }))
            };
            Line { by, name: name.to_owned(), label: "", runs: [1e-1, 3e-5, 2e-7, 1e-10].map(finish).into() }
        };
        let lines = vec![line(Crate::Dmech, "own", 1.0, 4.0), line(Crate::Diffsol, "other", 20.0, 8.0)];
        Report { name: "made", title: "Made up", kind: Kind::Even, lines }
    }

    /// At the first three goals, 1e-3: 5.62 and 47.4; 1e-6: 31.6 and 112.5; 1e-9: 177.8 and 266.7 microseconds, then with the roles exchanged.
    #[test]
    fn what_is_behind_is_said() {
        let mut report = report();
        assert!(report.behind().is_empty());
        let ratios = report.ratios();
        for ratio in ["8.43", "3.56", "1.50"] {
            assert!(ratios.contains(ratio), "{ratio}\n{ratios}");
        }
        report.lines[0].by = Crate::OdeSolvers;
        report.lines[1].by = Crate::Dmech;
        let behind = report.behind();
        assert_eq!(behind.len(), 3, "{behind:?}");
        assert!(behind[1].contains("1e-6: ode_solvers (own)") && behind[1].contains("3.56 times"), "{behind:?}");
    }

    #[test]
    fn rows_have_the_columns_of_the_head() {
        let mut report = report();
        report.lines[0].runs.push((1e-12, Err("stopped at \"t\" = 3".to_owned())));
        let mut csv = Vec::new();
        report.write_csv(&mut csv).unwrap();
        let csv = String::from_utf8(csv).unwrap();
        let columns = Report::COLUMNS.split(',').count();
        assert_eq!(csv.lines().count(), 9);
        assert!(csv.lines().all(|line| line.split(',').count() == columns), "{csv}");
    }
}
