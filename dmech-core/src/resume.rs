//! Checkpoints of single laws.

use crate::checkpoint::{Carried, Checkpoint, Difference, FORMAT, Fields, Fingerprint, Numbers, displaced, load, save};
use crate::error::Error;
use crate::law::{Field, Law, Potential};
use crate::scheme::Scheme;
use crate::simulation::Simulation;
use crate::state::State;
use crate::stepper::Stepper;

impl<L, S, const D: usize> Simulation<L, State<D>, S> {
    /// A stepper that goes on from a checkpoint, bit for bit. Where this simulation starts does not matter.
    ///
    /// # Errors
    /// [`Error::Checkpoint`] says what differs: the scheme, dt, the mass, the law. Otherwise as
    /// [`stepper`](Simulation::stepper).
    pub fn resume(self, checkpoint: &Checkpoint) -> Result<Stepper<L, S, D>, Error>
    where
        L: Law<D>,
        S: Scheme<L, D>,
        S::Memory: Carried,
    {
        let mut stepper = self.stepper()?;
        stepper.restore(checkpoint).map_err(Error::Checkpoint)?;
        Ok(stepper)
    }
}

impl<L: Law<D>, S: Scheme<L, D>, const D: usize> Stepper<L, S, D>
where
    S::Memory: Carried,
{
    /// All that is needed to go on from here; see [`Checkpoint`].
    pub fn checkpoint(&self) -> Checkpoint {
        let (_, scheme, stride) = self.parts();
        let start = self.start();
        // No longest step is no number that a checkpoint can hold.
        let dt = if self.dt().is_finite() { self.dt() } else { 0.0 };
        Checkpoint {
            format: FORMAT,
            scheme: S::NAME.to_owned(),
            options: Checkpoint::options(scheme),
            dimension: D,
            bodies: 1,
            times: Numbers(vec![start.t, dt, self.t()]),
            masses: Numbers(vec![stride.mass]),
            pins: Vec::new(),
            laws: self.fingerprint(),
            fields: self.fields().saved(),
            steps: self.steps(),
            evaluations: self.evaluations(),
            iterations: self.iterations(),
            start: [start.q, start.v].map(|x| Numbers(x.to_vec())).into(),
            memory: save(self.memory()),
            seals: Vec::new(),
        }
        .sealed()
    }

    fn restore(&mut self, saved: &Checkpoint) -> Result<(), Difference> {
        saved.fits::<S>(&self.checkpoint())?;
        self.fields().compare(&saved.fields)?;
        let (mut start, mut memory) = (self.start(), self.memory().clone());
        for (place, numbers) in [&mut start.q, &mut start.v].into_iter().zip(&saved.start) {
            numbers.copy_to(place)?;
        }
        load(&mut memory, &saved.memory)?;
        self.put(start, memory, [saved.steps, saved.evaluations, saved.iterations]);
        if self.fingerprint() == saved.laws { Ok(()) } else { Err(Difference::Laws) }
    }

    /// What the law reads of itself, and the masses of its coordinates.
    fn fields(&self) -> Fields<&'static str> {
        let mut fields = Fields::new();
        if let Some(written) = self.law().written() {
            written.fields(&mut |name, x| fields.see(name, x));
        }
        self.law().mass_ratios().into_iter().for_each(|ratio| fields.see("masses", ratio));
        fields
    }

    /// Φ and ∇Φ − F now, and where position and velocity are displaced.
    fn fingerprint(&self) -> Fingerprint {
        let (law, scheme, stride) = self.parts();
        let t = self.t();
        let (mut q, mut v) = (self.q(), scheme.velocity(law, stride, t, self.memory()));
        let field = law.field(stride.mass, t);
        let mut fingerprint = Fingerprint::new();
        for probe in 0..2 {
            if probe == 1 {
                displaced(&mut q);
                displaced(&mut v);
            }
            fingerprint.add(field.potential(q));
            fingerprint.add_all(&field.slope(q, v));
        }
        fingerprint
    }
}
