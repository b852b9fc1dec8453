//! The way back.

use dmech_core::extend::{Kept, Scheme};
use dmech_core::{Error, Invariant};

use super::report::Check;
use super::trial::Trial;
use crate::motion::{Coordinates, Repeatable, StateOf};

const STEPS: u64 = 200;

impl<L: Clone, X: Repeatable<L>, S: Scheme<X::System>> Trial<L, X, S> {
    /// Forward, velocity reversed, back.
    pub(super) fn reversibility(&self, name: &str) -> Check {
        let name = format!("{name}: reversibility");
        let reason = if !S::SYMMETRIC {
            Some("the scheme is not symmetric")
        } else if S::keeps(Invariant::DiscreteEnergy) == Kept::Exact {
            Some("a two-step scheme: reversed in its own variables, not in the velocity")
        } else {
            self.one_way
        };
        if let Some(reason) = reason {
            return Check::not_applicable(name, reason);
        }
        match self.there_and_back() {
            Ok((miss, growth)) => {
                let bound = 16.0 * f64::EPSILON * STEPS as f64 * growth;
                Check::at_most(name, miss, bound, format!("{STEPS} steps and back, relative to the length"))
            }
            Err(error) => Check::failed(name, error.to_string()),
        }
    }

    /// How far from the start the way back ends, and how much the motion itself magnifies a displacement on it.
    fn there_and_back(&self) -> Result<(f64, f64), Error> {
        const NUDGE: f64 = 1e-7;
        let (start, dt) = (self.start(), self.scales.time / super::keeps::PER_TIME);
        let turned = |state: &StateOf<L, X>| state.moved(start.time(), |q| q, |v| -v);
        let there = self.end(&start, dt, STEPS)?;
        let back = self.end(&turned(&there), dt, STEPS)?;
        let beside = turned(&there).moved(start.time(), |q| q + NUDGE * self.scales.length, |v| v);
        let off = self.end(&beside, dt, STEPS)?;
        let growth = self.distance(&off, &back) / NUDGE;
        Ok((self.distance(&turned(&back), &start), growth.max(1.0)))
    }
}
