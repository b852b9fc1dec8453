//! Watching the invariants of a run.

use dmech_scalar::{Compensated, Real};

use crate::error::Error;
use crate::invariant::{Drift, Invariant};
use crate::scheme::Scheme;
use crate::stepper::Stepper;
use crate::system::System;

/// The drift of each invariant, by `Invariant as usize`.
pub(crate) type Drifts = [Option<Drift>; Invariant::ALL.len()];

/// The invariants that this system and this scheme have, and how they moved so far.
#[derive(Clone, Debug)]
pub(crate) struct Watch<Y: System> {
    /// Energies at the start, by `Invariant as usize`; 0 where there is none.
    energies: [Y::Scalar; Invariant::ALL.len()],
    work: Compensated<Y::Scalar>,
    drifts: Drifts,
}

impl<Y: System> Watch<Y> {
    /// Starts from the first state.
    pub(crate) fn begin<S: Scheme<Y>>(stepper: &Stepper<Y, S>) -> Self {
        let energies = [Y::Scalar::ZERO; Invariant::ALL.len()];
        let work = Compensated::new(Y::Scalar::ZERO);
        let mut watch = Watch { energies, work, drifts: [None; Invariant::ALL.len()] };
        let state = stepper.state();
        for invariant in Invariant::ALL {
            let energy = watch.energy(invariant, stepper, &state);
            watch.energies[invariant as usize] = energy.unwrap_or(Y::Scalar::ZERO);
            let value = energy.map(|energy| energy.to_f64());
            let value = value.or_else(|| watch.momentum(invariant, stepper, &state).map(|(momentum, _)| momentum));
            watch.drifts[invariant as usize] = value.map(|value| Drift::new(Y::time(&state), value));
        }
        watch
    }

    /// Makes one step and adds its work.
    #[inline(always)]
    pub(crate) fn step<S: Scheme<Y>>(&mut self, stepper: &mut Stepper<Y, S>) -> Result<(), Error> {
        stepper.step_and(|Stepper { system, scheme, stride, .. }, before, after| {
            self.work.add(scheme.work(system, stride, before, after));
        })
    }

    /// Looks at a recorded state.
    pub(crate) fn observe<S: Scheme<Y>>(&mut self, stepper: &Stepper<Y, S>, state: &Y::State) {
        for invariant in Invariant::ALL {
            // Before it is rounded to `f64`, which may have fewer digits.
            let energy = self.energy(invariant, stepper, state);
            let seen = energy.map(|energy| (energy.to_f64(), (energy - self.energies[invariant as usize]).to_f64()));
            let seen = seen.or_else(|| self.momentum(invariant, stepper, state));
            if let (Some((value, deviation)), Some(drift)) = (seen, &mut self.drifts[invariant as usize]) {
                drift.observe(Y::time(state), value, deviation);
            }
        }
    }

    /// How they moved.
    pub(crate) fn drifts(&self) -> Drifts {
        self.drifts
    }

    fn energy<S: Scheme<Y>>(
        &self,
        invariant: Invariant,
        Stepper { system, scheme, memory, .. }: &Stepper<Y, S>,
        state: &Y::State,
    ) -> Option<Y::Scalar> {
        if !system.conserves(invariant) {
            return None;
        }
        let t = Y::Scalar::from_f64(Y::time(state));
        match invariant {
            Invariant::Energy => {
                let [q, v] = system.vectors(state);
                Some(system.potential(t, &q) + system.kinetic_energy(&v))
            }
            Invariant::DiscreteEnergy => scheme.discrete_energy(system, t, memory),
            Invariant::WorkEnergy => Some((scheme.kinetic_energy(system, memory) - self.work.hi) - self.work.lo),
            Invariant::LinearMomentum | Invariant::AngularMomentum => None,
        }
    }

    fn momentum<S: Scheme<Y>>(
        &self,
        invariant: Invariant,
        stepper: &Stepper<Y, S>,
        state: &Y::State,
    ) -> Option<(f64, f64)> {
        let is_momentum = matches!(invariant, Invariant::LinearMomentum | Invariant::AngularMomentum);
        let system = &stepper.system;
        (is_momentum && system.conserves(invariant)).then(|| system.momentum(invariant, state, &stepper.start))
    }
}
