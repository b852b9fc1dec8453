//! What takes part.

use core::fmt;
use std::time::{Duration, Instant};

/// Who wrote the solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crate {
    /// This project.
    Dmech,
    /// A loop written by hand for its force.
    Hand,
    /// heyoka, which is C++ and Python.
    Heyoka,
    /// `ode_solvers`.
    OdeSolvers,
    /// `differential-equations`.
    DifferentialEquations,
    /// `diffsol`.
    Diffsol,
}

impl Crate {
    /// The programs that dmech is held against.
    pub const PEERS: [Crate; 4] = [Crate::Heyoka, Crate::OdeSolvers, Crate::DifferentialEquations, Crate::Diffsol];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Crate::Dmech => "dmech",
            Crate::Hand => "by hand",
            Crate::Heyoka => "heyoka",
            Crate::OdeSolvers => "ode_solvers",
            Crate::DifferentialEquations => "differential-equations",
            Crate::Diffsol => "diffsol",
        }
    }
}

/// A run that reached the end.
#[derive(Clone, Copy, Debug)]
pub struct Finish {
    /// |q − q*| at the end.
    pub error: f64,
    /// Evaluations of the force; none where a solver makes none.
    pub evaluations: u64,
    /// Wall time of the whole run.
    pub time: Duration,
}

impl Finish {
    /// Runs against the clock: the run returns the final position and the evaluations.
    ///
    /// # Errors
    /// Those of the run, and a position that is not finite.
    pub fn of<const D: usize>(
        truth: &[f64; D],
        run: impl FnOnce() -> Result<([f64; D], u64), String>,
    ) -> Result<Finish, String> {
        let clock = Instant::now();
        let (q, evaluations) = run()?;
        let time = clock.elapsed();
        let error = distance(&q, truth);
        if error.is_finite() { Ok(Finish { error, evaluations, time }) } else { Err("not finite".to_owned()) }
    }
}

/// |a − b|, of all coordinates.
pub fn distance<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// Makes one run for a knob.
type Run<'a> = Box<dyn Fn(f64) -> Result<Finish, String> + 'a>;

/// A solver with its options, set on a motion.
pub struct Entrant<'a> {
    /// Whose it is.
    pub by: Crate,
    /// The name in tables.
    pub name: String,
    /// The name in pictures.
    pub label: &'static str,
    /// Steps or tolerances, from the coarsest.
    pub knobs: Vec<f64>,
    run: Run<'a>,
}

impl<'a> Entrant<'a> {
    /// An entrant whose run is given.
    pub fn new(
        by: Crate,
        name: impl Into<String>,
        label: &'static str,
        knobs: Vec<f64>,
        run: impl Fn(f64) -> Result<Finish, String> + 'a,
    ) -> Self {
        Entrant { by, name: name.into(), label, knobs, run: Box::new(run) }
    }

    /// Runs once.
    ///
    /// # Errors
    /// Why the run did not reach the end.
    pub fn run(&self, knob: f64) -> Result<Finish, String> {
        (self.run)(knob)
    }
}

impl fmt::Debug for Entrant<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Entrant").field("by", &self.by).field("name", &self.name).finish_non_exhaustive()
    }
}

/// 10⁻², 10^−2.5, … to 10⁻¹⁵.
pub fn tolerances() -> Vec<f64> {
    (4..=30).map(|k| 10_f64.powf(-0.5 * f64::from(k))).collect()
}

/// Numbers of steps, √2 apart, from one that has steps of about `coarse`; for orders beyond ten, whose error falls by 2¹⁶ where the
/// step is halved, half as far apart.
pub(crate) fn steps(span: f64, coarse: f64, order: u32) -> Vec<f64> {
    let (first, rung) = ((span / coarse).ceil().max(1.0), if order > 10 { 0.25 } else { 0.5 });
    (0..40).map(|k| (first * 2_f64.powf(rung * f64::from(k))).round()).collect()
}
