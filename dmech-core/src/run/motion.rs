//! A motion as a run has it, whatever the law and the scheme.

use std::time::Duration;

use dmech_scalar::Real;

use super::Watch;
use super::report::Cost;
use crate::error::Error;
use crate::invariant::{Invariant, Kept};
use crate::scheme::Scheme;
use crate::stepper::Stepper;
use crate::system::System;

/// A motion with states X in the scalar R, whatever the law and the scheme. What a run does beside the steps is compiled once for
/// each kind of state, and not for each scheme and law.
pub(crate) trait Motion<X, R: Real> {
    /// Position and velocity now.
    fn state(&self) -> X;

    /// What tells the time of a state.
    fn clock(&self) -> fn(&X) -> f64;

    /// The memory that a state takes, in bytes.
    fn size(&self) -> usize;

    /// The length of its steps, or of the longest.
    fn dt(&self) -> f64;

    /// Steps so far.
    fn steps(&self) -> u64;

    /// Whether it has come to its end, where it knows that.
    fn arrived(&self) -> bool;

    /// So many steps, whose work is added, or fewer: until it arrives, or before a step that may reach a time. How many.
    fn go(&mut self, steps: u64, until: Option<f64>, watch: &mut Watch<X, R>) -> Result<u64, Error>;

    /// Goes on from another state.
    fn set_state(&mut self, state: X) -> Result<(), Error>;

    /// To what steps of equal length must change the time.
    fn resolution(&self) -> Option<f64>;

    /// Whether the next step may reach a time.
    fn reaches(&self, t: f64) -> bool;

    /// The state at a time by a single step from a state in the last step, and the evaluations and corrections that it takes.
    fn between(&self, from: &X, t: f64) -> Result<(X, [u64; 2]), Error>;

    /// What there is of the invariants in the state now, and how far momenta are from those of another.
    fn invariants(&self, state: &X, first: &X) -> Invariants<R>;

    /// How well they are kept.
    fn kept(&self) -> [Kept; Invariant::ALL.len()];

    /// The names of the invariants that the law declares itself.
    fn own_names(&self) -> &'static [&'static str];

    /// The value of the k-th of them.
    fn own(&self, k: usize, state: &X) -> R;

    /// What it has cost so far.
    fn work(&self) -> Cost;
}

/// The invariants in one state.
pub(crate) struct Invariants<R> {
    pub(crate) energy: Option<R>,
    pub(crate) discrete_energy: Option<R>,
    /// The scheme's own kinetic energy, from which the work is still to be taken.
    pub(crate) kinetic: Option<R>,
    /// Linear and angular: how much, and how far from that of the first state.
    pub(crate) momenta: [Option<[f64; 2]>; 2],
}

impl<Y: System, S: Scheme<Y>> Motion<Y::State, Y::Scalar> for Stepper<Y, S> {
    fn state(&self) -> Y::State {
        Stepper::state(self)
    }

    fn clock(&self) -> fn(&Y::State) -> f64 {
        Y::time
    }

    fn size(&self) -> usize {
        Y::size(&self.start)
    }

    fn dt(&self) -> f64 {
        self.dt
    }

    fn steps(&self) -> u64 {
        Stepper::steps(self)
    }

    fn arrived(&self) -> bool {
        Stepper::arrived(self)
    }

    fn go(&mut self, steps: u64, until: Option<f64>, watch: &mut Watch<Y::State, Y::Scalar>) -> Result<u64, Error> {
        for made in 0..steps {
            if Stepper::arrived(self) || until.is_some_and(|t| self.reaches(t)) {
                return Ok(made);
            }
            watch.step(self)?;
        }
        Ok(steps)
    }

    fn set_state(&mut self, state: Y::State) -> Result<(), Error> {
        Stepper::set_state(self, state)
    }

    fn resolution(&self) -> Option<f64> {
        Stepper::resolution(self)
    }

    fn reaches(&self, t: f64) -> bool {
        // A step may come out longer by rounding.
        t <= self.t() + 1.01 * self.next_dt()
    }

    fn between(&self, from: &Y::State, t: f64) -> Result<(Y::State, [u64; 2]), Error> {
        Stepper::between(self, Stepper::steps(self), from, t)
    }

    fn invariants(&self, state: &Y::State, first: &Y::State) -> Invariants<Y::Scalar> {
        let Stepper { system, scheme, memory, .. } = self;
        let t = Y::Scalar::from_f64(Y::time(state));
        let (own, works) = (system.conserves(Invariant::DiscreteEnergy), system.conserves(Invariant::WorkEnergy));
        Invariants {
            discrete_energy: if own { scheme.discrete_energy(system, t, memory) } else { None },
            kinetic: works.then(|| scheme.kinetic_energy(system, memory)),
            ..of_the_system(system, state, first)
        }
    }

    fn kept(&self) -> [Kept; Invariant::ALL.len()] {
        kept::<Y, S>(&self.system)
    }

    fn own_names(&self) -> &'static [&'static str] {
        self.system.own_invariants()
    }

    fn own(&self, k: usize, state: &Y::State) -> Y::Scalar {
        self.system.own_invariant(k, state)
    }

    fn work(&self) -> Cost {
        let (rough, range) = (self.scheme.rough(&self.memory), self.scheme.range(&self.memory));
        let (steps, evaluations, iterations) = (Stepper::steps(self), self.evaluations(), self.iterations());
        Cost { steps, evaluations, iterations, rough, elapsed: Duration::ZERO, range }
    }
}

/// How well a scheme keeps each invariant of a system: where that bends or jumps, what is bounded elsewhere walks.
pub(super) fn kept<Y: System, S: Scheme<Y>>(system: &Y) -> [Kept; Invariant::ALL.len()] {
    Invariant::each(&mut |invariant| match S::kept(system, invariant) {
        Kept::Bounded if Y::PIECEWISE => Kept::BetweenSeams,
        kept => kept,
    })
}

/// What no scheme has a part in.
fn of_the_system<Y: System>(system: &Y, state: &Y::State, first: &Y::State) -> Invariants<Y::Scalar> {
    let momentum = |of| {
        let (now, deviation) = system.conserves(of).then(|| system.momentum(of, state, first))?;
        Some([now.to_f64(), deviation.to_f64()])
    };
    Invariants {
        energy: system.conserves(Invariant::Energy).then(|| system.energy(state)),
        discrete_energy: None,
        kinetic: None,
        momenta: [momentum(Invariant::LinearMomentum), momentum(Invariant::AngularMomentum)],
    }
}
