//! A reference in double-double numbers.

use dmech_core::extend::{DoubleDouble, Real};
use dmech_core::{Error, Explicit, Law, State};

use super::Computed;
use super::case::{Case, rounding};
use super::extrapolation::{Extrapolation, ORDER};
use super::reference::Reference;
use super::truth::Truth;
use crate::motion::norm;

/// Local errors in parts of |q| and |v|. The last is near what rounding allows.
const TOLERANCES: [f64; 3] = [1e-22, 1e-25, 1e-28];

/// Evaluations of the force in the first run; the others take at most twice as many each.
const MOST_FORCES: u64 = 1 << 24;

const LEAPFROG: &str = "Extrapolated leap-frog of order 28, double-double";
const MIDPOINT: &str = "Extrapolated midpoint rule of order 28, double-double";
const _: () = assert!(ORDER == 28);

/// The final position and velocity that a smaller tolerance changes least.
pub(super) fn compute<L, const D: usize>(case: &Case<L, State<D>>) -> Computed
where
    L: Law<D> + Law<D, DoubleDouble> + Clone,
{
    let State { t, q, v } = case.start;
    let start = State { t, q: q.map(DoubleDouble::from), v: v.map(DoubleDouble::from) };
    let scheme = if Extrapolation::<L, D, DoubleDouble>::leapfrog() { LEAPFROG } else { MIDPOINT };
    let span = case.end - t;
    let first = case.scales()?.time;
    let stepper = case.stepper(Explicit, span)?;
    let (law, mass) = (stepper.law(), stepper.system().mass());
    let mut budget = MOST_FORCES;
    let mut before: Option<[DoubleDouble; D]> = None;
    let mut best: Option<(Truth, Reference)> = None;
    for tolerance in TOLERANCES {
        let motion = Extrapolation { law, mass, start, end: case.end, tolerance, budget };
        let end = match motion.run(first) {
            Ok(end) => end,
            Err(_) if best.is_some() => break,
            Err(error) => return Err(error),
        };
        budget = 2 * end.evaluations;
        if let Some(before) = before.replace(end.q) {
            let error = norm((0..D).map(|i| (end.q[i] - before[i]).to_f64()));
            if best.as_ref().is_none_or(|best| error < best.1.error()) {
                let reference = Reference { scheme, dt: span / end.steps as f64, error, precise: true };
                best = Some((Truth::precise(&end.q, &end.v), reference));
            }
            if error <= rounding(&end.q.map(Real::to_f64)) / 16.0 {
                break;
            }
        }
    }
    best.ok_or(Error::EndTime { end: case.end, dt: first })
}
