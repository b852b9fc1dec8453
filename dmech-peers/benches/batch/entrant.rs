//! Runs of all planets in rounds.

use std::time::Duration;

use dmech_peers::{Crate, ORBITS, distance, orbit_end};

/// An entrant stops at the first run that takes longer for a planet.
const LONGEST: Duration = Duration::from_micros(150);

/// An entrant stops at this error, below the last that is asked for.
const ENOUGH: f64 = 3e-13;

/// The last positions, and how long all took; forces of all planets, where they are counted.
pub(crate) struct Ends {
    pub(crate) places: Vec<[f64; 2]>,
    pub(crate) forces: u64,
    pub(crate) time: Duration,
}

/// Makes one run of all planets for a knob.
type Run<'a> = Box<dyn Fn(f64) -> Result<Ends, String> + 'a>;

/// A scheme or a solver with its options.
pub(crate) struct Entrant<'a> {
    pub(crate) by: Crate,
    pub(crate) name: String,
    /// What the knob is.
    pub(crate) knob: &'static str,
    /// Steps or tolerances, from the coarsest.
    pub(crate) knobs: Vec<f64>,
    pub(crate) run: Run<'a>,
}

/// A run that reached the end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rung {
    pub(crate) knob: f64,
    pub(crate) largest: f64,
    pub(crate) median: f64,
    /// Of one planet.
    pub(crate) forces: f64,
    /// Of one planet, the shortest of all rounds.
    pub(crate) microseconds: f64,
}

/// The runs of an entrant.
pub(crate) struct Line {
    pub(crate) by: Crate,
    pub(crate) name: String,
    pub(crate) knob: &'static str,
    pub(crate) rungs: Vec<Rung>,
}

impl Rung {
    fn new(knob: f64, ends: &Ends, truth: &[[f64; 2]]) -> Option<Rung> {
        let mut errors: Vec<_> = ends.places.iter().zip(truth).map(|(q, end)| distance(q, end)).collect();
        errors.sort_by(f64::total_cmp);
        let largest = *errors.last().filter(|error| error.is_finite())?;
        let forces = ends.forces as f64 / ORBITS as f64;
        Some(Rung { knob, largest, median: errors[ORBITS / 2], forces, microseconds: microseconds(ends.time) })
    }
}

/// Of one planet.
fn microseconds(all: Duration) -> f64 {
    1e6 * all.as_secs_f64() / ORBITS as f64
}

/// Every entrant with every knob, from the coarsest until it is accurate enough or too slow, but for knobs that change nothing; then
/// all of these runs again, round by round.
pub(crate) fn measure(entrants: &[Entrant<'_>], rounds: u32) -> Vec<Line> {
    let truth: Vec<_> = (0..ORBITS).map(orbit_end).collect();
    let mut lines: Vec<_> = entrants.iter().map(|entrant| first(entrant, &truth)).collect();
    for _ in 0..rounds {
        for (entrant, line) in entrants.iter().zip(&mut lines) {
            for rung in &mut line.rungs {
                if let Ok(ends) = (entrant.run)(rung.knob) {
                    rung.microseconds = rung.microseconds.min(microseconds(ends.time));
                }
            }
        }
    }
    lines
}

fn first(entrant: &Entrant<'_>, truth: &[[f64; 2]]) -> Line {
    let mut rungs: Vec<Rung> = Vec::new();
    for &knob in &entrant.knobs {
        let ends = match (entrant.run)(knob) {
            Ok(ends) => ends,
            Err(cause) => {
                eprintln!("{}, {} {knob:e}: {cause}", entrant.name, entrant.knob);
                continue;
            }
        };
        let rung = Rung::new(knob, &ends, truth);
        if rung.map(|rung| rung.largest) != rungs.last().map(|rung| rung.largest) {
            rungs.extend(rung);
        }
        // Once more, where other load may have been what took so long.
        let again = || (entrant.run)(knob).map_or(ends.time, |again| again.time.min(ends.time));
        let is_long = |time: Duration| microseconds(time) > 1e6 * LONGEST.as_secs_f64();
        if rung.is_some_and(|rung| rung.largest < ENOUGH) || (is_long(ends.time) && (0..3).all(|_| is_long(again()))) {
            break;
        }
    }
    Line { by: entrant.by, name: entrant.name.clone(), knob: entrant.knob, rungs }
}
