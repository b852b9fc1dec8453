//! The hard cases: what is hard, what every scheme does there, and what must hold.
//!
//! The example prints and draws them; `tests/long/many_steps/hard_cases.rs` asserts what must hold.
#![allow(dead_code, unused_macros, reason = "the example and the test each use their part")]

pub(crate) mod atoms;
pub(crate) mod collision;
pub(crate) mod damping;
pub(crate) mod duffing;
pub(crate) mod gravity;
pub(crate) mod henon_heiles;
pub(crate) mod kepler;
pub(crate) mod long_chain;
pub(crate) mod scales;
pub(crate) mod stiff;
pub(crate) mod summit;
pub(crate) mod trial;
pub(crate) mod van_der_pol;
pub(crate) mod wall;

use dmech::prelude::*;

use trial::{Recorded, Trial};

/// How much is computed: the tests are short.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Length {
    Test,
    Whole,
}

impl Length {
    pub(crate) fn of<T>(self, test: T, whole: T) -> T {
        match self {
            Length::Test => test,
            Length::Whole => whole,
        }
    }
}

/// Runs a case.
pub(crate) type Runs = fn(Length) -> Case;

/// All cases, in the order in which they are shown.
pub(crate) const CASES: &[(&str, Runs)] = &[
    ("kepler", kepler::case),
    ("collision", collision::case),
    ("stiff", stiff::case),
    ("summit", summit::case),
    ("henon_heiles", henon_heiles::case),
    ("pythagoras", gravity::pythagoras),
    ("figure_eight", gravity::figure_eight),
    ("atoms", atoms::case),
    ("wall", wall::case),
    ("damping", damping::case),
    ("van_der_pol", van_der_pol::case),
    ("duffing", duffing::case),
    ("long_chain", long_chain::case),
    ("scales", scales::case),
];

/// A hard case with everything that came out of it.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    /// Its name in file names.
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    /// What is hard.
    pub(crate) hard: &'static str,
    /// What must hold.
    pub(crate) holds: &'static str,
    /// Columns of its own.
    pub(crate) heads: Vec<&'static str>,
    /// The longest step that resolves the motion: with longer ones an implicit step may have no root.
    pub(crate) longest: f64,
    pub(crate) rows: Vec<Row>,
    pub(crate) checks: Vec<Check>,
    pub(crate) pictures: Vec<Picture>,
}

/// What one scheme did.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) scheme: &'static str,
    pub(crate) dt: f64,
    pub(crate) energy: f64,
    pub(crate) cells: Vec<String>,
    pub(crate) ended: String,
}

/// A value that must not be larger than another.
#[derive(Clone, Debug)]
pub(crate) struct Check {
    pub(crate) what: String,
    pub(crate) value: f64,
    pub(crate) most: f64,
}

impl Check {
    pub(crate) fn holds(&self) -> bool {
        self.value <= self.most
    }
}

/// Lines to be drawn.
#[derive(Clone, Debug)]
pub(crate) struct Picture {
    pub(crate) name: &'static str,
    pub(crate) title: String,
    /// What is to be seen, in lines.
    pub(crate) words: Vec<String>,
    pub(crate) x: Scale,
    pub(crate) y: Scale,
    pub(crate) lines: Vec<Line>,
    /// What the motion is in truth, or a boundary, behind each of the lines.
    pub(crate) behind: Option<Vec<(f64, f64)>>,
}

impl Picture {
    /// Whether the lines lie far from each other: errors that differ by powers of ten, and nothing behind them.
    pub(crate) fn together(&self) -> bool {
        self.y.kind == Kind::Powers && self.behind.is_none()
    }
}

/// An axis of a picture.
#[derive(Clone, Debug)]
pub(crate) struct Scale {
    pub(crate) name: &'static str,
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) kind: Kind,
}

/// What stands on an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Linear,
    /// Decimal logarithms.
    Powers,
    /// Lengths, as long on the other axis.
    Equal,
}

impl Scale {
    pub(crate) fn linear(name: &'static str, from: f64, to: f64) -> Self {
        Scale { name, from, to, kind: Kind::Linear }
    }

    pub(crate) fn powers(name: &'static str, from: f64, to: f64) -> Self {
        Scale { name, from, to, kind: Kind::Powers }
    }

    pub(crate) fn equal(name: &'static str, from: f64, to: f64) -> Self {
        Scale { name, from, to, kind: Kind::Equal }
    }
}

/// A line of a picture and what it is called.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    pub(crate) name: String,
    pub(crate) points: Vec<(f64, f64)>,
    /// What became of it.
    pub(crate) note: Option<String>,
    /// Whether it ends where the run stopped with an error.
    pub(crate) stopped: bool,
}

impl Line {
    pub(crate) fn new<X: Recorded>(trial: &Trial<X>, points: Vec<(f64, f64)>) -> Self {
        let t = trial.run.last().t();
        let stop = |cause| {
            let cause = in_short(cause);
            let why = cause.split(" (").next().unwrap_or_default();
            format!("stops at t = {}, {why}", short(t))
        };
        let note = trial.cause.map(stop);
        Line { name: label(trial.scheme), points, stopped: note.is_some(), note }
    }
}

/// A shorter name of a scheme: compositions by their order.
pub(crate) fn label(scheme: &str) -> String {
    let composed = scheme.strip_prefix("Composed(").and_then(|rest| rest.strip_suffix(')'));
    match composed.and_then(|inner| inner.split_once(", ")) {
        Some((scheme, coefficients)) => {
            let order = coefficients.trim_start_matches(|c: char| !c.is_ascii_digit());
            format!("{scheme}, order {order}")
        }
        None => scheme.to_owned(),
    }
}

impl Case {
    pub(crate) fn new(
        name: &'static str,
        title: &'static str,
        hard: &'static str,
        holds: &'static str,
        heads: &[&'static str],
    ) -> Self {
        let (rows, checks, pictures) = (Vec::new(), Vec::new(), Vec::new());
        let longest = f64::INFINITY;
        Case { name, title, hard, holds, heads: heads.to_vec(), longest, rows, checks, pictures }
    }

    /// With longer steps than this a run may end early.
    pub(crate) fn resolved_to(self, longest: f64) -> Self {
        Case { longest, ..self }
    }

    /// Notes a trial, with what holds for all of them: that it is sound, and that what its scheme keeps exactly is kept.
    pub(crate) fn row<X: Recorded>(&mut self, trial: &Trial<X>, cells: Vec<String>) {
        self.row_within(trial, cells, rounding(trial.run.steps()));
    }

    /// The same, with the energy error that a scheme may have that keeps it exactly.
    pub(crate) fn row_within<X: Recorded>(&mut self, trial: &Trial<X>, cells: Vec<String>, most: f64) {
        let Trial { scheme, dt, .. } = *trial;
        let ended = match trial.cause {
            None => "done".to_owned(),
            Some(cause) => format!("t = {}: {}", short(trial.run.last().t()), in_short(cause)),
        };
        self.rows.push(Row { scheme, dt, energy: trial.energy_error(), cells, ended });
        let sound = trial.sound();
        let what = sound.as_ref().err().cloned().unwrap_or_else(|| format!("{scheme} at dt = {dt}: sound"));
        self.check(what, if sound.is_ok() { 0.0 } else { f64::NAN }, 0.0);
        if trial.exact_energy() && !trial.run.states().is_empty() {
            self.check(format!("{scheme} at dt = {dt:e}: energy error"), trial.own_energy_error(), most);
            // The energy that Kanatani's scheme keeps is its own, and does not hold a body in a well.
            if dt <= self.longest && trial.run.kept(Invariant::Energy) == Kept::Exact {
                let missing = trial.asked - trial.run.steps();
                self.check(format!("{scheme} at dt = {dt:e}: steps missing"), missing as f64, 0.0);
            }
        }
    }

    /// Notes that `value` must be at most `most`; a NaN is not.
    pub(crate) fn check(&mut self, what: impl Into<String>, value: f64, most: f64) {
        self.checks.push(Check { what: what.into(), value, most });
    }
}

/// What n steps may lose by rounding, of what is kept exactly: a few ulps in a step, which wander as √n.
pub(crate) fn rounding(steps: u64) -> f64 {
    f64::EPSILON * (64.0 + 4.0 * (steps as f64).sqrt())
}

/// A number in few characters.
pub(crate) fn short(x: f64) -> String {
    let size = x.abs();
    match size {
        _ if x.is_nan() => "–".to_owned(),
        0.0 => "0".to_owned(),
        _ if (0.01..1e4).contains(&size) => {
            let digits = (3 - size.log10().floor() as i32).clamp(0, 4) as usize;
            format!("{x:.digits$}")
        }
        _ => format!("{x:.1e}"),
    }
}

fn in_short(cause: Error) -> String {
    match cause {
        Error::NotConverged { iterations, .. } => format!("not converged ({iterations} iterations)"),
        Error::NotFinite { .. } => "not finite".to_owned(),
        Error::Law { quantity, value, .. } => format!("refused, {quantity} is {value}"),
        Error::Underflow { .. } => "refused, force lost below the smallest number".to_owned(),
        other => other.to_string(),
    }
}
