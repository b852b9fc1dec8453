//! A reference in double-double numbers.

use dmech_core::extend::{DoubleDouble, Real};
use dmech_core::{Error, Explicit, Law, State};

use super::Computed;
use super::case::{Case, rounding};
use super::extrapolation::{End, Extrapolation, ORDER};
use super::reference::Reference;
use super::truth::Truth;
use crate::motion::{Scales, norm};

/// Local errors in parts of |q| and |v|. The last is near what rounding allows.
const TOLERANCES: [f64; 3] = [1e-22, 1e-25, 1e-28];

/// Where rounding does not allow these, as that of a time far from 0 does not in a law that names it.
const LARGER: [f64; 3] = [1e-19, 1e-16, 1e-13];

/// This part of the size of a motion is nothing: what begins at rest where next to nothing acts is not followed to all digits of that.
const NOTHING: f64 = 1e-20;

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
    let span = case.span();
    let Scales { length, time: first } = case.scales()?;
    let mut least = [NOTHING * length, NOTHING * length / first];
    let stepper = case.stepper(Explicit, span)?;
    let (law, mass) = (stepper.law(), stepper.system().mass());
    let longest = case.longest_of_reference();
    let follow = |tolerance, least, budget| {
        Extrapolation { law, mass, start, end: case.end, tolerance, least, longest, budget }.run(first)
    };
    let apart = |a: &End<D, DoubleDouble>, b: &End<D, DoubleDouble>| norm((0..D).map(|i| (a.q[i] - b.q[i]).to_f64()));
    let referred = |end: &End<D, DoubleDouble>, error| {
        let reference = Reference { scheme, dt: span / end.steps as f64, error, precise: true };
        (Truth::precise(&end.q, &end.v), reference)
    };
    let mut budget = MOST_FORCES;
    let mut before: Option<End<D, DoubleDouble>> = None;
    let mut best: Option<(Truth, Reference)> = None;
    let mut failure = None;
    for tolerance in TOLERANCES {
        let end = match follow(tolerance, least, budget) {
            Ok(end) => end,
            Err(error) => {
                failure = Some(error);
                break;
            }
        };
        budget = 2 * end.evaluations;
        least.iter_mut().zip(end.sizes).for_each(|(least, size)| *least = least.min(NOTHING * size));
        let error = before.as_ref().map(|before| apart(&end, before));
        if let Some(error) = error
            && best.as_ref().is_none_or(|best| error < best.1.error())
        {
            best = Some(referred(&end, error));
        }
        if error.is_some_and(|error| error <= rounding(&end.q.map(Real::to_f64)) / 16.0) {
            break;
        }
        before = Some(end);
    }
    for tolerance in LARGER {
        if best.is_some() {
            break;
        }
        let Ok(end) = follow(tolerance, least, MOST_FORCES / 4) else { continue };
        match &before {
            Some(smaller) => best = Some(referred(smaller, apart(smaller, &end))),
            None => before = Some(end),
        }
    }
    best.ok_or(failure.unwrap_or(Error::EndTime { end: case.end, dt: first }))
}
