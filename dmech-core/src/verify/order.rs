//! The order of convergence, measured by halving the step.

use super::Borrowed;
use super::report::Check;
use super::trial::{Halvings, Trial};
use crate::law::Law;
use crate::scheme::Scheme;
use crate::state::State;
use crate::system::Particle;

/// Below this part of the length, differences of end states are rounding.
const ROUNDING: f64 = 1e-11;

/// How far below the declared order a settled measurement may lie.
const SLACK: f64 = 0.1;

impl<L, S, const D: usize> Trial<'_, L, S, D>
where
    L: Law<D>,
    S: for<'b> Scheme<Particle<Borrowed<'b, L>, D>>,
{
    /// |u_h − u_{h/2}| / |u_{h/2} − u_{h/4}| → 2^p, with steps halved until two successive p agree.
    ///
    /// A higher order than declared is no fault: the leading error may vanish for a law.
    pub(super) fn order(&self) -> Check {
        let name = format!("{}: order", S::NAME);
        let bound = f64::from(S::ORDER) - SLACK;
        let steps = |level: u32| 16_u64 << level;
        let mut before: Option<State<D>> = None;
        let change = |level| match self.end(self.start, self.scales.time / steps(level) as f64, steps(level)) {
            Ok(state) => Ok(before.replace(state).map(|before| self.distance(&before, &state))),
            // A large step may fail where a smaller one does not.
            Err(_) if level < 4 => {
                before = None;
                Ok(None)
            }
            Err(error) => Err(error.to_string()),
        };
        let agree = |powers: &[f64]| matches!(powers, [.., before, now] if (now - before).abs() < 0.02);
        let halvings = match Halvings::measure(8, ROUNDING, change, agree) {
            Ok(halvings) => halvings,
            Err(error) => return Check::failed(name, error),
        };
        let Some(&p) = halvings.powers.last() else {
            return Check::not_applicable(name, "the error is at the level of rounding");
        };
        if agree(&halvings.powers) {
            return Check::at_least(name, p, bound, format!("halving the step, up to {} steps", steps(halvings.level)));
        }
        if p < bound && p > bound - 0.4 {
            return Check::not_applicable(name, format!("not settled before rounding, last value {p:.2}"));
        }
        Check::at_least(name, p, bound, "halving the step")
    }
}
