//! Checkpoints.

use crate::checkpoint::{Carried, Checkpoint, Digits, FORMAT, Fingerprint, Fingerprints, Saved, load, save};
use crate::error::{Difference, Error};
use crate::run::Simulation;
use crate::scheme::Scheme;
use crate::setup::Setup;
use crate::stepper::Stepper;

impl<L, X, S, O> Simulation<L, X, S, O> {
    /// A stepper that goes on from a checkpoint, bit for bit. Where this simulation starts does not matter, if its law has a
    /// value there, only when: a scene is set up again as it was, and its bodies move to where they were. Checkpoints are of
    /// motions in `f64`.
    ///
    /// It is a stepper and not a run: a loop records its states, and a [`Watch`](crate::extend::Watch) its invariants, counted from
    /// here. A run that need not go on bit for bit begins from a state, [`starting_from`](Simulation::starting_from).
    ///
    /// # Errors
    /// [`Error::Checkpoint`] says what differs: the number of bodies, the scheme, dt, a mass, a pin, a law. Otherwise as
    /// [`stepper`](Simulation::stepper).
    pub fn resume(self, checkpoint: &Checkpoint) -> Result<Stepper<X::System, S>, Error>
    where
        X: Setup<L>,
        X::System: Saved<Scalar = f64>,
        S: Scheme<X::System>,
        S::Memory: Carried,
    {
        let mut stepper = self.stepper()?;
        stepper.restore(checkpoint).map_err(Error::Checkpoint)?;
        Ok(stepper)
    }
}

impl<Y: Saved<Scalar = f64>, S: Scheme<Y>> Stepper<Y, S>
where
    S::Memory: Carried,
{
    /// All that is needed to go on from here, of a motion in `f64`; see [`Checkpoint`].
    pub fn checkpoint(&self) -> Checkpoint {
        let system = &self.system;
        // No longest step is no number that a checkpoint can hold.
        let dt = if self.dt.is_finite() { self.dt } else { 0.0 };
        let (masses, pins) = system.bodies();
        Checkpoint {
            format: FORMAT,
            scheme: S::NAME.to_owned(),
            options: Checkpoint::options(&self.scheme),
            dimension: Y::DIMENSION,
            bodies: masses.len(),
            times: Digits(vec![self.first, dt, self.t(), Y::time(&self.start)]),
            masses: Digits(masses),
            pins,
            laws: self.fingerprint(),
            fields: self.fields().saved(),
            steps: self.steps(),
            steps_before: self.steps_before,
            evaluations: self.evaluations,
            iterations: self.iterations,
            start: system.vectors(&self.start).map(|mut x| Digits(Y::numbers(&mut x).to_vec())).into(),
            memory: save(&self.memory),
            seals: Vec::new(),
        }
        .sealed()
    }

    fn restore(&mut self, saved: &Checkpoint) -> Result<(), Difference> {
        saved.fits::<S>(&self.checkpoint())?;
        self.fields().compare(&saved.fields)?;
        let [mut q, mut v] = self.system.vectors(&self.start);
        for (place, numbers) in [&mut q, &mut v].into_iter().zip(&saved.start) {
            numbers.copy_to(Y::numbers(place))?;
        }
        let mut memory = self.memory.clone();
        load(&mut memory, &saved.memory)?;
        let start = self.system.state(saved.begun_at(), &q, &v);
        let since = saved.steps.saturating_sub(saved.steps_before);
        self.put(start, memory, [saved.steps_before, since, saved.evaluations, saved.iterations]);
        // It may have waited for a law to have a value.
        if since == 0 {
            self.begin_or_wait_at(self.start.clone());
        }
        if self.fingerprint() == saved.laws { Ok(()) } else { Err(Difference::Laws) }
    }

    /// What the laws read of themselves and of the bodies, and whom they link.
    fn fields(&self) -> Fingerprints<&'static str> {
        let mut fields = Fingerprints::new();
        self.system.fields(&mut |name, x| fields.see(name, x));
        fields
    }

    /// What acts now.
    fn fingerprint(&self) -> Fingerprint {
        let t = self.t();
        let velocity = self.scheme.velocity(&self.system, &self.stride, t, &self.memory);
        Fingerprint::of(&self.system, t, [self.position().clone(), velocity])
    }
}
