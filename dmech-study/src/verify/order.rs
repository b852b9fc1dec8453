//! The order of convergence, measured by halving the step.

use dmech_core::extend::Scheme;

use super::report::Check;
use super::trial::{Halvings, Trial};
use crate::motion::{Repeatable, StateOf};

/// Below this part of the length, differences of end states are rounding.
const ROUNDING: f64 = 1e-11;

/// How far below the declared order a settled measurement may lie.
const SLACK: f64 = 0.1;

impl<L: Clone, X: Repeatable<L>, S: Scheme<X::System>> Trial<L, X, S> {
    /// |u_h − u_{h/2}| / |u_{h/2} − u_{h/4}| → 2^p, with steps halved until two successive p agree.
    ///
    /// A higher order than declared is no fault: the leading error may vanish for a law.
    pub(super) fn order(&self, name: &str) -> Check {
        let name = format!("{name}: order");
        let start = self.start();
        let bound = f64::from(S::ORDER) - SLACK;
        let steps = |level: u32| 16_u64 << level;
        let mut before: Option<StateOf<L, X>> = None;
        let change = |level| match self.end(&start, self.scales.time / steps(level) as f64, steps(level)) {
            Ok(state) => Ok(before.replace(state.clone()).map(|before| self.distance(&before, &state))),
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
