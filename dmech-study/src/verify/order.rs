//! The order of convergence, measured by halving the step.

use dmech_core::extend::Scheme;

use super::report::Check;
use super::trial::{Halvings, Trial};
use crate::motion::{Repeatable, StateOf};

/// Below this part of the length, differences of end states are rounding.
const ROUNDING: f64 = 1e-11;

/// How far below the declared order a settled measurement may lie.
const SLACK: f64 = 0.1;

/// Spans in units of the characteristic time. Over the first the steps of most schemes of high order leave nothing but rounding; over the
/// second, which is for them alone, a law of the user's might meet a seam.
const SPANS: [f64; 2] = [1.0, 32.0];
const HIGH: u32 = 4;

impl<L: Clone, X: Repeatable<L>, S: Scheme<X::System>> Trial<L, X, S> {
    /// |u_h − u_{h/2}| / |u_{h/2} − u_{h/4}| → 2^p, with steps halved until two successive p agree.
    ///
    /// A higher order than declared is no fault: the leading error may vanish for a law.
    pub(super) fn order(&self, name: &str) -> Check {
        let name = format!("{name}: order");
        let (mut last, bound) = (None, f64::from(S::ORDER) - SLACK);
        for span in SPANS.into_iter().take(if S::ORDER < HIGH { 1 } else { 2 }) {
            let (halvings, steps) = match self.halvings(span * self.scales.time) {
                Ok(halvings) => halvings,
                Err(error) => return Check::failed(name, error),
            };
            let Some(&p) = halvings.powers.last() else { continue };
            // Where rounding has not come in between, it is the scheme that does not settle.
            if agree(&halvings.powers) || halvings.error >= ROUNDING {
                return Check::at_least(name, p, bound, format!("halving the step, up to {steps} steps"));
            }
            last = Some(p);
        }
        match last {
            None => Check::not_applicable(name, "the error is at the level of rounding"),
            Some(p) if p < bound && (p > bound - 0.4 || S::ORDER >= HIGH) => {
                Check::not_applicable(name, format!("not settled before rounding, last value {p:.2}"))
            }
            Some(p) => Check::at_least(name, p, bound, "halving the step"),
        }
    }

    /// The powers over a span, and the steps of the last.
    fn halvings(&self, span: f64) -> Result<(Halvings, u64), String> {
        let start = self.start();
        let steps = |level: u32| 16_u64 << level;
        let mut before: Option<StateOf<L, X>> = None;
        let change = |level| match self.end(&start, span / steps(level) as f64, steps(level)) {
            Ok(state) => Ok(before.replace(state.clone()).map(|before| self.distance(&before, &state))),
            // A large step may fail where a smaller one does not.
            Err(_) if level < 4 => {
                before = None;
                Ok(None)
            }
            Err(error) => Err(error.to_string()),
        };
        let halvings = Halvings::measure(8, ROUNDING, change, agree)?;
        let steps = steps(halvings.level);
        Ok((halvings, steps))
    }
}

/// Whether the power has settled.
fn agree(powers: &[f64]) -> bool {
    matches!(powers, [.., before, now] if (now - before).abs() < 0.02)
}
