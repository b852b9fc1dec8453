//! What a scheme keeps in the motion.

use dmech_core::extend::{Kept, Scheme, System};
use dmech_core::{Invariant, Run};

use super::report::Check;
use super::trial::{Halvings, Trial};
use crate::motion::{Repeatable, StateOf};

/// Steps in one unit of time, and steps in all.
pub(super) const PER_TIME: f64 = 50.0;
const STEPS: u64 = 2000;
/// The explicit formulas spiral outward, some orbits to infinity.
const EXPLICIT_STEPS: u64 = 200;

impl<L: Clone, X: Repeatable<L>, S: Scheme<X::System>> Trial<L, X, S> {
    /// The largest deviation of an invariant, over the largest |Φ| + K of the run, or over what K allows the momentum.
    fn deviation(&self, run: &Run<StateOf<L, X>>, invariant: Invariant) -> Option<f64> {
        let drift = run.drift(invariant)?;
        if drift.max_abs() == 0.0 {
            return Some(0.0);
        }
        let stepper = self.stepper(run.report().dt()).ok()?;
        let system = stepper.system();
        let size = |state: &StateOf<L, X>| {
            let [q, v] = system.vectors(state);
            let kinetic = system.kinetic_energy(&v);
            match invariant {
                // Cauchy and Schwarz: |Σ m q v|² ≤ Σ m q² Σ m v², and |Σ m v|² ≤ Σ m Σ m v².
                Invariant::AngularMomentum => 2.0 * (kinetic * system.kinetic_energy(&q)).sqrt(),
                Invariant::LinearMomentum => (2.0 * kinetic * run.report().mass()).sqrt(),
                _ => system.potential(<X::System as System>::time(state), &q).abs() + kinetic,
            }
        };
        let size = run.states().iter().map(size).fold(0.0, f64::max);
        Some(drift.max_abs() / size)
    }

    /// Exact invariants to round-off; bounded ones by their order: half the step must leave much less than half, of a scheme of order 1
    /// about half that does not grow with the time.
    pub(super) fn invariants(&self, scheme: &str, checks: &mut Vec<Check>) {
        let steps = if S::ORDER == 1 { EXPLICIT_STEPS } else { STEPS };
        let first = match self.run(self.scales.time / PER_TIME, steps) {
            Ok(run) => run,
            Err(error) => {
                checks.push(Check::failed(format!("{scheme}: invariants"), error));
                return;
            }
        };
        for invariant in Invariant::ALL {
            let name = format!("{scheme}: {invariant}");
            match (S::keeps(invariant), self.deviation(&first, invariant)) {
                (Kept::No, _) => {}
                (_, None) if self.is_missing(invariant) => {
                    checks.push(Check::failed(name, "said to be kept, and Scheme::discrete_energy has none"));
                }
                (_, None) => {
                    if invariant == Invariant::Energy {
                        checks.push(Check::not_applicable(name, "the law does not conserve it"));
                    }
                }
                (Kept::Exact, Some(measured)) => {
                    // A random walk of one unit of rounding per step has √n of them; a few in each of the sums.
                    let bound = 32.0 * f64::EPSILON * (steps as f64).sqrt();
                    checks.push(Check::at_most(name, measured, bound, format!("exact over {steps} steps, relative")));
                }
                (Kept::Bounded | Kept::BetweenSeams, Some(measured)) => {
                    checks.push(self.bounded(measured, invariant, name))
                }
            }
        }
    }

    /// Whether the system has it and the scheme alone does not tell it.
    fn is_missing(&self, invariant: Invariant) -> bool {
        let of_the_scheme = invariant == Invariant::DiscreteEnergy;
        of_the_scheme && self.stepper(self.dt(0)).is_ok_and(|stepper| stepper.system().conserves(invariant))
    }

    fn dt(&self, level: u32) -> f64 {
        self.scales.time / (PER_TIME * f64::from(1 << level))
    }

    fn bounded(&self, measured: f64, invariant: Invariant, name: String) -> Check {
        // The deviation is O(h²), O(h) of a scheme of order 1; half a power leaves room for a step that is not yet small.
        let bound = f64::from(S::ORDER.clamp(1, 2)) - 0.5;
        const ROUNDING: f64 = 1e-12;
        let over = |level: u32, steps: u64| Ok(self.deviation(&self.run(self.dt(level), steps << level)?, invariant));
        // The first run of a scheme of order 1 is shorter than these.
        let deviation = |level| if level == 0 && S::ORDER > 1 { Ok(Some(measured)) } else { over(level, STEPS) };
        let reached = |powers: &[f64]| powers.last().is_some_and(|&power| power >= bound);
        match Halvings::measure(5, ROUNDING, deviation, reached) {
            Err(error) => Check::failed(name, error),
            Ok(Halvings { error, .. }) if error < ROUNDING => Check::at_most(name, error, ROUNDING, "kept to rounding"),
            Ok(Halvings { powers, error, level }) => {
                let power = powers.last().copied().unwrap_or(f64::NAN);
                let check =
                    Check::at_least(name, power, bound, format!("bounded: power of the step; deviates by {error:.0e}"));
                // A drift of first order is a power of the step, too, and grows with the time.
                if S::ORDER == 1 { steady(check, over(level, 2 * STEPS), error) } else { check }
            }
        }
    }
}

/// The check, unless twice the time lets the deviation grow as a drift does.
fn steady(check: Check, longer: Result<Option<f64>, String>, error: f64) -> Check {
    const GROWTH: f64 = 1.5;
    let growth = match longer {
        Ok(longer) => longer.unwrap_or(f64::NAN) / error,
        Err(error) => return Check::failed(check.name(), error),
    };
    if growth <= GROWTH {
        return check;
    }
    Check::at_most(check.name(), growth, GROWTH, "drifts: growth of the deviation in twice the time")
}
