//! Watching the invariants of a run.

use dmech_scalar::{Compensated, Real};

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
    pub(crate) energies: [R; Invariant::ALL.len()],
    /// What changes of the motion had come to in the deviations of the momenta before them.
    pub(crate) carried: [f64; 2],
    /// Of the steps so far.
    pub(crate) work: Compensated<R>,
    pub(crate) drifts: Drifts,
    /// The law's own invariants at the start.
    own_start: [R; MAX_OWN],
    own: OwnDrifts,
    /// Their history, where it is kept.
    pub(super) histories: Option<Box<Histories>>,
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
            carried: [0.0; 2],
            work: Compensated::new(R::ZERO),
            drifts: [None; Invariant::ALL.len()],
            own_start: [R::ZERO; MAX_OWN],
            own: OwnDrifts::default(),
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
        let mut deviations = [f64::NAN; Invariant::ALL.len()];
        for invariant in Invariant::ALL {
            // Before it is rounded to `f64`, which may have fewer digits.
            let energy = self.energy(invariant, &here);
            let seen = energy.map(|energy| [energy, energy - self.energies[invariant as usize]].map(R::to_f64));
            let seen = seen.or_else(|| self.momentum(invariant, &here));
            if let (Some([value, deviation]), Some(drift)) = (seen, &mut self.drifts[invariant as usize]) {
                drift.observe(t, value, deviation);
                deviations[invariant as usize] = deviation;
            }
        }
        if let Some(histories) = &mut self.histories {
            histories.see(t, &deviations);
        }
        self.see_own(motion, state);
    }

    /// How far the invariants are from their start, before the motion is changed in a state.
    pub(super) fn deviations(&self, motion: &dyn Motion<X, R>, state: &X) -> Deviations<R> {
        let here = motion.invariants(state, &self.first);
        let momenta = [Invariant::LinearMomentum, Invariant::AngularMomentum];
        Deviations {
            energies: Invariant::each(&mut |invariant| {
                self.energy(invariant, &here).map_or(R::ZERO, |energy| energy - self.energies[invariant as usize])
            }),
            momenta: momenta.map(|of| self.momentum(of, &here).map_or(0.0, |[_, deviation]| deviation)),
            own: core::array::from_fn(|k| {
                if k < motion.own_names().len() { motion.own(k, state) - self.own_start[k] } else { R::ZERO }
            }),
        }
    }

    /// Goes on from a state to which the motion was changed: what the change has done to the invariants is not counted.
    pub(super) fn go_on(&mut self, motion: &dyn Motion<X, R>, state: &X, so_far: Deviations<R>) {
        let here = motion.invariants(state, state);
        for invariant in Invariant::ALL {
            if let Some(energy) = self.energy(invariant, &here) {
                self.energies[invariant as usize] = energy - so_far.energies[invariant as usize];
            }
        }
        for k in 0..motion.own_names().len().min(MAX_OWN) {
            self.own_start[k] = motion.own(k, state) - so_far.own[k];
        }
        (self.first, self.carried) = (state.clone(), so_far.momenta);
    }

    /// How much there is of a momentum, and how far it is from that at the start.
    fn momentum(&self, invariant: Invariant, here: &Invariants<R>) -> Option<[f64; 2]> {
        let carried = self.carried[usize::from(invariant == Invariant::AngularMomentum)];
        here.momentum(invariant).map(|[momentum, deviation]| [momentum, carried + deviation])
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
            if let Some(histories) = &mut self.histories {
                histories.see_own(k, t, deviation);
            }
        }
    }

    /// Keeps their history from here on, which is the start.
    pub(super) fn keep_histories(&mut self, t: f64) {
        let mut histories = Histories::of_those(&self.drifts);
        // What is no number at the start is not 0 from it.
        let none = |drift: Drift| drift.start() - drift.start();
        histories.see(t, &self.drifts.map(|drift| drift.map_or(f64::NAN, none)));
        self.own.iter().enumerate().for_each(|(k, (_, drift))| histories.see_own(k, t, none(drift)));
        self.histories = Some(Box::new(histories));
    }

    /// Takes the deviations of the quantities of a run, one after another.
    #[inline]
    pub(super) fn beside(&mut self, t: f64) -> impl FnMut(f64) + use<'_, X, R> {
        let mut k = self.own.iter().count();
        move |deviation| {
            if let Some(histories) = &mut self.histories {
                histories.see_own(k, t, deviation);
                k += 1;
            }
        }
    }

    /// Whether the energy has been a finite number wherever it was looked at, up to a time.
    ///
    /// # Errors
    /// [`Error::LeftDomain`]
    pub fn in_domain(&self, time: f64) -> Result<(), Error> {
        let left = |energy: Drift| energy.start().is_finite() && !energy.max_abs().is_finite();
        if self.drifts[Invariant::Energy as usize].is_some_and(left) { Err(Error::LeftDomain { time }) } else { Ok(()) }
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

/// How far invariants are from where they began: the energies by `Invariant as usize`, the momenta, and those of the law itself.
pub(super) struct Deviations<R> {
    energies: [R; Invariant::ALL.len()],
    momenta: [f64; 2],
    own: [R; MAX_OWN],
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
