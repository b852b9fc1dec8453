//! Shortened steps that have no solution, in parts.

use crate::error::Error;

/// How often a shortened step is halved that has no solution.
const HALVINGS: u32 = 4;

/// A state, and the evaluations and corrections that it takes.
type Cost<X> = Result<(X, [u64; 2]), Error>;

/// The state at a time by a single step from a state or, where that has no solution, as where it would end on a seam at which a force
/// jumps, by two of half the length, of which each may be halved again. The error is that of the single step.
pub(crate) fn in_parts<X>(single: &dyn Fn(&X, f64) -> Cost<X>, time: fn(&X) -> f64, from: &X, t: f64) -> Cost<X> {
    halved(single, time, from, t, HALVINGS)
}

fn halved<X>(single: &dyn Fn(&X, f64) -> Cost<X>, time: fn(&X) -> f64, from: &X, t: f64, halvings: u32) -> Cost<X> {
    let whole = single(from, t);
    if halvings == 0 || !matches!(whole, Err(Error::NotConverged { .. })) {
        return whole;
    }
    let middle = 0.5 * time(from) + 0.5 * t;
    let parts = halved(single, time, from, middle, halvings - 1).and_then(|(state, first)| {
        let (state, second) = halved(single, time, &state, t, halvings - 1)?;
        Ok((state, [first[0] + second[0], first[1] + second[1]]))
    });
    parts.or(whole)
}
