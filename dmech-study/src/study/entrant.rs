//! A scheme in a study.

use std::hint::black_box;
use std::time::{Duration, Instant};

use dmech_core::extend::{Drifts, Method, Scheme, Watch};
use dmech_core::{Adaptable, Adaptive, Error, Stepper};

use super::case::{Case, numbers};
use crate::motion::Repeatable;

/// States at which the invariants of a run are looked at.
const SAMPLES: u64 = 4096;

/// Schemes of different types in one list.
pub(super) trait Runner<L, X: Repeatable<L>> {
    /// The name in tables.
    fn name(&self) -> &'static str;
    /// The order that the scheme declares.
    fn order(&self) -> u32;
    /// The tolerances of a scheme that follows the motion: they take the place of time steps.
    fn tolerances(&self) -> Option<&[f64]> {
        None
    }
    /// Runs and watches the invariants.
    fn watch(&self, case: &Case<L, X>, dt: f64, steps: u64) -> Result<Watched, Error>;
    /// The time of a run, from as many in a row; `None` if the run fails.
    fn time(&self, case: &Case<L, X>, dt: f64, steps: u64, runs: u32) -> Option<Duration>;
}

/// Where a run ended, what it kept and what it cost.
pub(super) struct Watched {
    pub(super) q: Vec<f64>,
    pub(super) steps: u64,
    pub(super) drifts: Drifts,
    pub(super) evaluations: u64,
    pub(super) iterations: u64,
}

/// A scheme, with its options.
pub(super) struct Entrant<S>(pub(super) S);

impl<L: Clone, X: Repeatable<L>, S: Scheme<X::System>> Runner<L, X> for Entrant<S> {
    fn name(&self) -> &'static str {
        S::NAME
    }

    fn order(&self) -> u32 {
        S::ORDER
    }

    fn watch(&self, case: &Case<L, X>, dt: f64, steps: u64) -> Result<Watched, Error> {
        let mut stepper = case.stepper(self.0, dt)?;
        let mut watch = Watch::begin(&stepper);
        let every = steps.div_ceil(SAMPLES);
        for step in 1..=steps {
            watch.step(&mut stepper)?;
            if step % every == 0 || step == steps {
                let state = stepper.state();
                watch.observe(&stepper, &state);
            }
        }
        watch.in_domain(stepper.t())?;
        let (evaluations, iterations) = (stepper.evaluations(), stepper.iterations());
        Ok(Watched { q: numbers(&stepper.state()), steps, drifts: watch.drifts(), evaluations, iterations })
    }

    fn time(&self, case: &Case<L, X>, dt: f64, steps: u64, runs: u32) -> Option<Duration> {
        let clock = Instant::now();
        for _ in 0..runs {
            let mut stepper = case.stepper(self.0, dt).ok()?;
            stepper.advance(black_box(steps)).ok()?;
            black_box(stepper.position());
        }
        Some(clock.elapsed() / runs)
    }
}

/// A scheme that follows the motion, with its tolerances.
pub(super) struct Adapting<S> {
    pub(super) scheme: S,
    pub(super) tolerances: Vec<f64>,
}

impl<S: Adaptable> Adapting<S> {
    fn stepper<L: Clone, X: Repeatable<L>>(
        &self,
        case: &Case<L, X>,
        tolerance: f64,
    ) -> Result<Stepper<X::System, Adaptive<S>>, Error>
    where
        S: Scheme<X::System>,
    {
        let scheme = Adaptive::new(self.scheme, tolerance).until(case.end);
        case.stepper(scheme, case.longest)
    }
}

impl<L: Clone, X: Repeatable<L>, S: Adaptable + Scheme<X::System>> Runner<L, X> for Adapting<S> {
    fn name(&self) -> &'static str {
        Adaptive::<S>::NAME
    }

    fn order(&self) -> u32 {
        S::ORDER
    }

    fn tolerances(&self) -> Option<&[f64]> {
        Some(&self.tolerances)
    }

    fn watch(&self, case: &Case<L, X>, tolerance: f64, _: u64) -> Result<Watched, Error> {
        let mut stepper = self.stepper(case, tolerance)?;
        let mut watch = Watch::begin(&stepper);
        // How many steps there will be is not known: every one up to SAMPLES, every second up to twice that, and so on.
        let (mut every, mut next) = (1, 1);
        while !stepper.arrived() {
            watch.step(&mut stepper)?;
            if stepper.steps() == next || stepper.arrived() {
                let state = stepper.state();
                watch.observe(&stepper, &state);
                if stepper.steps() >= SAMPLES * every {
                    every *= 2;
                }
                next = stepper.steps() + every;
            }
        }
        let (steps, evaluations, iterations) = (stepper.steps(), stepper.evaluations(), stepper.iterations());
        Ok(Watched { q: numbers(&stepper.state()), steps, drifts: watch.drifts(), evaluations, iterations })
    }

    fn time(&self, case: &Case<L, X>, tolerance: f64, _: u64, runs: u32) -> Option<Duration> {
        let clock = Instant::now();
        for _ in 0..runs {
            let mut stepper = self.stepper(case, tolerance).ok()?;
            while !stepper.arrived() {
                stepper.step().ok()?;
            }
            black_box(stepper.position());
        }
        Some(clock.elapsed() / runs)
    }
}
