//! Watching the invariants of a run.

use dmech_scalar::{Compensated, Real};

#[cfg(feature = "plot")]
use super::history::Histories;
use super::motion::{Invariants, Motion};
use crate::drift::{Drift, Drifts, MAX_OWN, OwnDrifts};
use crate::error::Error;
use crate::invariant::Invariant;
use crate::scheme::Scheme;
use crate::stepper::Stepper;
use crate::system::System;

/// The invariants that a system and a scheme have, and how they moved so far: for a loop of one's own.
///
/// ```
/// use dmech_core::extend::Watch;
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3]));
/// let mut stepper = quartic.scheme(DiscreteGradient).dt(0.01).stepper()?;
/// let mut watch = Watch::begin(&stepper);
/// while stepper.t() < 20.0 {
///     watch.step(&mut stepper)?;
///     watch.observe(&stepper, &stepper.state());
/// }
/// let [energy, ..] = watch.drifts();
/// assert!(energy.unwrap().max_relative() < 1e-14);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Watch<X, R: Real = f64> {
    /// The first state.
    first: X,
    /// Energies at the start, by `Invariant as usize`; 0 where there is none.
    energies: [R; Invariant::ALL.len()],
    work: Compensated<R>,
    drifts: Drifts,
    /// The law's own invariants at the start.
    own_start: [R; MAX_OWN],
    own: OwnDrifts,
    /// Their history, where it is kept.
    #[cfg(feature = "plot")]
    histories: Option<Histories>,
}

impl<X: Clone, R: Real> Watch<X, R> {
    /// Starts from the first state.
    pub fn begin<Y: System<State = X, Scalar = R>, S: Scheme<Y>>(stepper: &Stepper<Y, S>) -> Self {
        Self::of(stepper)
    }

    pub(super) fn of(motion: &dyn Motion<X, R>) -> Self {
        let mut watch = Watch {
            first: motion.state(),
            energies: [R::ZERO; Invariant::ALL.len()],
            work: Compensated::new(R::ZERO),
            drifts: [None; Invariant::ALL.len()],
            own_start: [R::ZERO; MAX_OWN],
            own: OwnDrifts::default(),
            #[cfg(feature = "plot")]
            histories: None,
        };
        let state = &watch.first;
        let (t, here) = (motion.clock()(state), motion.invariants(state, state));
        for (k, name) in motion.own_names().iter().enumerate().take(MAX_OWN) {
            watch.own_start[k] = motion.own(k, state);
            watch.own.add(name, Drift::new(t, watch.own_start[k].to_f64()));
        }
        for invariant in Invariant::ALL {
            let energy = watch.energy(invariant, &here);
            watch.energies[invariant as usize] = energy.unwrap_or(R::ZERO);
            let value = energy.map(R::to_f64).or(here.momentum(invariant).map(|[momentum, _]| momentum));
            watch.drifts[invariant as usize] = value.map(|value| Drift::new(t, value));
        }
        watch
    }

    /// Makes one step and adds its work.
    #[inline(always)]
    pub fn step<Y: System<State = X, Scalar = R>, S: Scheme<Y>>(
        &mut self,
        stepper: &mut Stepper<Y, S>,
    ) -> Result<(), Error> {
        stepper.step_and(|Stepper { system, scheme, stride, .. }, before, after| {
            self.work.add(scheme.work(system, stride, before, after));
        })
    }

    /// Looks at a recorded state.
    pub fn observe<Y: System<State = X, Scalar = R>, S: Scheme<Y>>(&mut self, stepper: &Stepper<Y, S>, state: &X) {
        self.see(stepper, state);
    }

    pub(super) fn see(&mut self, motion: &dyn Motion<X, R>, state: &X) {
        let (t, here) = (motion.clock()(state), motion.invariants(state, &self.first));
        for invariant in Invariant::ALL {
            // Before it is rounded to `f64`, which may have fewer digits.
            let energy = self.energy(invariant, &here);
            let seen = energy.map(|energy| [energy, energy - self.energies[invariant as usize]].map(R::to_f64));
            let seen = seen.or(here.momentum(invariant));
            if let (Some([value, deviation]), Some(drift)) = (seen, &mut self.drifts[invariant as usize]) {
                drift.observe(t, value, deviation);
                #[cfg(feature = "plot")]
                if let Some(histories) = &mut self.histories {
                    histories.see(invariant, t, deviation);
                }
            }
        }
        self.see_own(motion, state);
    }

    /// Takes them from elsewhere; those of the law itself are looked at here.
    pub(crate) fn set_drifts(&mut self, drifts: Drifts) {
        self.drifts = drifts;
    }

    /// The work of the steps so far.
    pub(crate) fn work(&self) -> Compensated<R> {
        self.work
    }

    /// Takes it from elsewhere.
    pub(crate) fn set_work(&mut self, work: Compensated<R>) {
        self.work = work;
    }

    /// Where the work of the steps is not summed.
    pub(crate) fn forget_work(&mut self) {
        self.drifts[Invariant::WorkEnergy as usize] = None;
    }

    /// Looks at the invariants that the law declares itself.
    pub(super) fn see_own(&mut self, motion: &dyn Motion<X, R>, state: &X) {
        for (k, drift) in self.own.iter_mut().enumerate() {
            let value = motion.own(k, state);
            let (t, deviation) = (motion.clock()(state), (value - self.own_start[k]).to_f64());
            drift.observe(t, value.to_f64(), deviation);
            #[cfg(feature = "plot")]
            if let Some(histories) = &mut self.histories {
                histories.see_own(k, t, deviation);
            }
        }
    }

    /// Keeps their history from here on, which is the start.
    #[cfg(feature = "plot")]
    pub(super) fn keep_histories(&mut self, t: f64) {
        let mut histories = Histories::default();
        Invariant::ALL
            .into_iter()
            .filter(|&invariant| self.drifts[invariant as usize].is_some())
            .for_each(|invariant| histories.see(invariant, t, 0.0));
        (0..self.own.iter().count()).for_each(|k| histories.see_own(k, t, 0.0));
        self.histories = Some(histories);
    }

    #[cfg(feature = "plot")]
    pub(super) fn take_histories(&mut self) -> Histories {
        self.histories.take().unwrap_or_default()
    }

    /// How they moved.
    pub fn drifts(&self) -> Drifts {
        self.drifts
    }

    /// How the invariants moved that the law declares itself.
    pub fn own_drifts(&self) -> OwnDrifts {
        self.own.clone()
    }

    fn energy(&self, invariant: Invariant, here: &Invariants<R>) -> Option<R> {
        match invariant {
            Invariant::Energy => here.energy,
            Invariant::DiscreteEnergy => here.discrete_energy,
            Invariant::WorkEnergy => here.kinetic.map(|kinetic| (kinetic - self.work.hi) - self.work.lo),
            Invariant::LinearMomentum | Invariant::AngularMomentum => None,
        }
    }
}

impl<R> Invariants<R> {
    fn momentum(&self, invariant: Invariant) -> Option<[f64; 2]> {
        match invariant {
            Invariant::LinearMomentum => self.momenta[0],
            Invariant::AngularMomentum => self.momenta[1],
            _ => None,
        }
    }
}
