//! The order of convergence, measured by halving the step.

use core::array::from_fn;

use super::Borrowed;
use super::motion::end;
use super::points::{Scales, norm};
use super::report::Check;
use crate::law::Law;
use crate::scheme::Scheme;
use crate::state::State;

/// Below this part of the length, differences of end states are rounding.
const ROUNDING: f64 = 1e-11;

/// How far below the declared order a settled measurement may lie.
const SLACK: f64 = 0.1;

/// |u_h − u_{h/2}| / |u_{h/2} − u_{h/4}| → 2^p, with steps halved until two successive p agree.
///
/// A higher order than declared is no fault: the leading error may vanish for a law.
pub(super) fn check<L, S, const D: usize>(
    law: &L,
    scheme: S,
    start: &State<D>,
    scales: &Scales,
    checks: &mut Vec<Check>,
) where
    L: Law<D>,
    S: for<'a> Scheme<Borrowed<'a, L>, D>,
{
    let name = format!("{}: order", S::NAME);
    let bound = f64::from(S::ORDER) - SLACK;
    let mut ends: Vec<State<D>> = Vec::new();
    let mut orders: Vec<f64> = Vec::new();
    for doubling in 0..9 {
        let steps = 16_u64 << doubling;
        match end(law, scheme, start, scales.time / steps as f64, steps) {
            Ok(state) => ends.push(state),
            // A large step may fail where a smaller one does not.
            Err(_) if doubling < 4 => {
                ends.clear();
                continue;
            }
            Err(error) => {
                checks.push(Check::failed(name, error.to_string()));
                return;
            }
        }
        let [.., one, two, four] = &ends[..] else { continue };
        let (coarse, fine) = (distance(one, two, scales), distance(two, four, scales));
        if fine < ROUNDING {
            break;
        }
        orders.push((coarse / fine).log2());
        if let [.., before, now] = orders[..]
            && (now - before).abs() < 0.02
        {
            checks.push(Check::at_least(name, now, bound, format!("halving the step, up to {steps} steps")));
            return;
        }
    }
    checks.push(match orders.last() {
        None => Check::not_applicable(name, "the error is at the level of rounding"),
        Some(&p) if p >= bound => Check::at_least(name, p, bound, "halving the step"),
        Some(&p) if p > bound - 0.4 => {
            Check::not_applicable(name, format!("not settled before rounding, last value {p:.2}"))
        }
        Some(&p) => Check::at_least(name, p, bound, "halving the step"),
    });
}

/// Positions in units of the length, velocities in units of length by time.
pub(super) fn distance<const D: usize>(a: &State<D>, b: &State<D>, scales: &Scales) -> f64 {
    let position: [f64; D] = from_fn(|i| (a.q[i] - b.q[i]) / scales.length);
    let velocity: [f64; D] = from_fn(|i| (a.v[i] - b.v[i]) * scales.time / scales.length);
    norm(position).hypot(norm(velocity))
}
