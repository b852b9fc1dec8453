//! Runs in rounds, and what lies between them.

use std::time::Duration;

use dmech::study::{Cost, cost_at};

use crate::entrant::{Crate, Entrant, Finish};

/// An entrant stops at the first run that takes longer.
const LONGEST: Duration = Duration::from_millis(40);

/// An entrant stops at this error, below the last goal, as further down only roundings differ: with the second run that reaches it,
/// as the first may be chance.
const ENOUGH: f64 = 5e-13;

/// A run is repeated within a round until this has passed.
const ROUND: Duration = Duration::from_micros(300);

/// The runs of an entrant.
#[derive(Clone, Debug)]
pub struct Line {
    /// Whose it is.
    pub by: Crate,
    /// The name in tables.
    pub name: String,
    /// The name in pictures.
    pub label: &'static str,
    /// Knobs and what came of them, from the coarsest; times are the shortest of all rounds.
    pub runs: Vec<(f64, Result<Finish, String>)>,
}

impl Line {
    /// Milliseconds to an error.
    pub fn time_at(&self, error: f64) -> Option<Cost> {
        self.cost_at(error, |finish| 1e3 * finish.time.as_secs_f64())
    }

    /// Evaluations of the force to an error, where there are any.
    pub fn evaluations_at(&self, error: f64) -> Option<Cost> {
        self.cost_at(error, |finish| finish.evaluations as f64).filter(|cost| cost.value() > 0.0)
    }

    fn cost_at(&self, error: f64, cost: fn(&Finish) -> f64) -> Option<Cost> {
        let reached = self.runs.iter().filter_map(|(_, run)| run.as_ref().ok());
        cost_at(error, &reached.map(|finish| (finish.error.max(1e-16), cost(finish))).collect::<Vec<_>>())
    }
}

/// Every entrant with every knob, from the coarsest until it is accurate enough and no longer gets cheaper, or is too slow;
/// then all of these runs again, round by round, of which the shortest times are kept.
pub fn measure(entrants: &[Entrant<'_>], rounds: u32) -> Vec<Line> {
    let mut lines: Vec<_> = entrants.iter().map(first).collect();
    for _ in 0..rounds {
        for (entrant, line) in entrants.iter().zip(&mut lines) {
            for (knob, run) in &mut line.runs {
                if let Ok(finish) = run {
                    again(entrant, *knob, finish);
                }
            }
        }
    }
    lines
}

fn first(entrant: &Entrant<'_>) -> Line {
    let (mut runs, mut enough, mut before) = (Vec::new(), 0, 0);
    for &knob in &entrant.knobs {
        let run = entrant.run(knob);
        let mut done = false;
        if let Ok(Finish { error, evaluations, time }) = &run {
            // Steps that are too long cost more than shorter ones where they are made in parts: the ladder goes on to those.
            enough += u32::from(*error < ENOUGH && *evaluations >= before);
            done = enough == 2 || *time > LONGEST;
            before = *evaluations;
        }
        runs.push((knob, run));
        if done {
            break;
        }
    }
    Line { by: entrant.by, name: entrant.name.clone(), label: entrant.label, runs }
}

fn again(entrant: &Entrant<'_>, knob: f64, finish: &mut Finish) {
    let mut spent = Duration::ZERO;
    while spent < ROUND {
        let Ok(run) = entrant.run(knob) else { return };
        spent += run.time.max(Duration::from_micros(1));
        finish.time = finish.time.min(run.time);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Costs 3 e^(−1/4) of errors that halve: what lies between two runs is on the line through them.
    #[test]
    fn a_power_law_comes_back() {
        let cost = |error: f64| 3.0 * error.powf(-0.25);
        let points: Vec<_> = [1e-1, 2e-4, 3e-7, 5e-9].map(|e| (e, cost(e))).into();
        for error in [1e-2, 1e-3, 1e-6, 1e-8] {
            let found = cost_at(error, &points).unwrap();
            assert!((found.value() / cost(error) - 1.0).abs() < 1e-13, "{error}: {found:?}");
        }
        assert_eq!(cost_at(0.5, &points), Some(Cost::AtMost(points[0].1)));
        assert_eq!(cost_at(1e-9, &points), None);
    }

    /// The ladder ends with the second run that is accurate enough and no cheaper than the one before, and a run that fails does not
    /// end it.
    #[test]
    fn a_ladder_ends_where_it_is_accurate() {
        let run = |knob: f64| {
            let finish = Finish { error: knob, evaluations: (1.0 / knob) as u64, time: Duration::from_micros(7) };
            if knob == 1e-4 { Err("lost".to_owned()) } else { Ok(finish) }
        };
        let measured = |knobs: Vec<f64>| measure(&[Entrant::new(Crate::Hand, "made up", "m", knobs, run)], 1);
        let cheaper = measured(vec![1e-2, 1e-16, 1e-15, 1e-14, 1e-13, 1e-14, 1e-15]);
        assert_eq!(cheaper[0].runs.len(), 6);
        let lines = measured(vec![1e-2, 1e-4, 1e-13, 1e-8, 1e-14, 1e-15]);
        assert_eq!(lines[0].runs.len(), 5);
        assert!(lines[0].runs[1].1.is_err() && lines[0].runs[4].1.is_ok());
        let forces = lines[0].evaluations_at(1e-6).unwrap().value();
        assert!((forces / 1e6 - 1.0).abs() < 1e-9, "{forces}");
    }
}
