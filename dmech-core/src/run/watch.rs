//! Watching the invariants of a run.

use dmech_scalar::{Compensated, Real};

#[cfg(feature = "plot")]
use super::course::Courses;
use crate::error::Error;
use crate::invariant::{Drift, Drifts, Invariant, MAX_OWN, OwnDrifts};
use crate::scheme::Scheme;
use crate::stepper::Stepper;
use crate::system::System;

/// The invariants that a system and a scheme have, and how they moved so far: for a loop of one's own.
///
/// ```
/// use dmech_core::extend::Watch;
/// use dmech_core::prelude::*;
/// # struct Quartic { k: f64 }
/// # impl Conservative for Quartic {}
/// # impl Potential<1> for Quartic {
/// #     fn potential(&self, [x]: [f64; 1]) -> f64 { 0.25 * self.k * x.powi(4) }
/// #     fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] { [self.k * x.powi(3)] }
/// #     fn hessian(&self, [x]: [f64; 1]) -> [[f64; 1]; 1] { [[3.0 * self.k * x * x]] }
/// #     fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] { [0.25 * self.k * (a + b) * (a * a + b * b)] }
/// #     fn discrete_gradient_jacobian(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
/// #         [[0.25 * self.k * (a * a + 2.0 * a * b + 3.0 * b * b)]]
/// #     }
/// # }
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
pub struct Watch<Y: System> {
    /// Energies at the start, by `Invariant as usize`; 0 where there is none.
    energies: [Y::Scalar; Invariant::ALL.len()],
    work: Compensated<Y::Scalar>,
    drifts: Drifts,
    /// The law's own invariants at the start.
    own_start: [Y::Scalar; MAX_OWN],
    own: OwnDrifts,
    /// Their course, where it is kept.
    #[cfg(feature = "plot")]
    courses: Option<Courses>,
}

impl<Y: System> Watch<Y> {
    /// Starts from the first state.
    pub fn begin<S: Scheme<Y>>(stepper: &Stepper<Y, S>) -> Self {
        let energies = [Y::Scalar::ZERO; Invariant::ALL.len()];
        let work = Compensated::new(Y::Scalar::ZERO);
        let own_start = [Y::Scalar::ZERO; MAX_OWN];
        let own = OwnDrifts::default();
        let mut watch: Self = Watch {
            energies,
            work,
            drifts: [None; Invariant::ALL.len()],
            own_start,
            own,
            #[cfg(feature = "plot")]
            courses: None,
        };
        let state = stepper.state();
        for (k, name) in stepper.system.own_invariants().iter().enumerate().take(MAX_OWN) {
            watch.own_start[k] = stepper.system.own_invariant(k, &state);
            watch.own.add(name, Drift::new(Y::time(&state), watch.own_start[k].to_f64()));
        }
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
    pub fn step<S: Scheme<Y>>(&mut self, stepper: &mut Stepper<Y, S>) -> Result<(), Error> {
        stepper.step_and(|Stepper { system, scheme, stride, .. }, before, after| {
            self.work.add(scheme.work(system, stride, before, after));
        })
    }

    /// Looks at a recorded state.
    pub fn observe<S: Scheme<Y>>(&mut self, stepper: &Stepper<Y, S>, state: &Y::State) {
        for invariant in Invariant::ALL {
            // Before it is rounded to `f64`, which may have fewer digits.
            let energy = self.energy(invariant, stepper, state);
            let seen = energy.map(|energy| (energy.to_f64(), (energy - self.energies[invariant as usize]).to_f64()));
            let seen = seen.or_else(|| self.momentum(invariant, stepper, state));
            if let (Some((value, deviation)), Some(drift)) = (seen, &mut self.drifts[invariant as usize]) {
                drift.observe(Y::time(state), value, deviation);
                #[cfg(feature = "plot")]
                if let Some(courses) = &mut self.courses {
                    courses.see(invariant, Y::time(state), deviation);
                }
            }
        }
        self.observe_own(stepper, state);
    }

    /// Takes them from elsewhere; those of the law itself are looked at here.
    pub(crate) fn set_drifts(&mut self, drifts: Drifts) {
        self.drifts = drifts;
    }

    /// Where the work of the steps is not summed.
    pub(crate) fn forget_work(&mut self) {
        self.drifts[Invariant::WorkEnergy as usize] = None;
    }

    /// Looks at the invariants that the law declares itself.
    pub(crate) fn observe_own<S: Scheme<Y>>(&mut self, stepper: &Stepper<Y, S>, state: &Y::State) {
        for (k, drift) in self.own.iter_mut().enumerate() {
            let value = stepper.system.own_invariant(k, state);
            let deviation = (value - self.own_start[k]).to_f64();
            drift.observe(Y::time(state), value.to_f64(), deviation);
            #[cfg(feature = "plot")]
            if let Some(courses) = &mut self.courses {
                courses.see_own(k, Y::time(state), deviation);
            }
        }
    }

    /// Keeps their course from here on, which is the start.
    #[cfg(feature = "plot")]
    pub(super) fn keep_courses(&mut self, t: f64) {
        let mut courses = Courses::default();
        Invariant::ALL
            .into_iter()
            .filter(|&invariant| self.drifts[invariant as usize].is_some())
            .for_each(|invariant| courses.see(invariant, t, 0.0));
        (0..self.own.iter().count()).for_each(|k| courses.see_own(k, t, 0.0));
        self.courses = Some(courses);
    }

    #[cfg(feature = "plot")]
    pub(super) fn take_courses(&mut self) -> Courses {
        self.courses.take().unwrap_or_default()
    }

    /// How they moved.
    pub fn drifts(&self) -> Drifts {
        self.drifts
    }

    /// How the invariants moved that the law declares itself.
    pub fn own_drifts(&self) -> OwnDrifts {
        self.own.clone()
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
            Invariant::Energy => Some(system.energy(state)),
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
        let seen =
            (is_momentum && system.conserves(invariant)).then(|| system.momentum(invariant, state, &stepper.start));
        seen.map(|(value, deviation)| (value.to_f64(), deviation.to_f64()))
    }
}
