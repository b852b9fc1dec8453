//! Checkpoints of scenes.

use super::builder::Scene;
use super::scheme::SceneScheme;
use super::stepper::SceneStepper;
use super::terms::{Acts, Term};
use super::vectors::Vectors;
use crate::checkpoint::{Carried, Checkpoint, Difference, FORMAT, Fields, Fingerprint, Numbers, displaced, load, save};
use crate::error::Error;
use crate::simulation::Simulation;

impl<const D: usize, P, L, S> Simulation<(), Scene<D, P, L>, S> {
    /// A stepper that goes on from a checkpoint, bit for bit. The scene is the one that was saved, set up again; where its
    /// bodies start does not matter.
    ///
    /// # Errors
    /// [`Error::Checkpoint`] says what differs: the number of bodies, the scheme, dt, a mass, a pin, the laws. Otherwise as
    /// [`stepper`](Simulation::stepper).
    pub fn resume(self, checkpoint: &Checkpoint) -> Result<SceneStepper<D, L::Ready, S>, Error>
    where
        L: Term<D, P>,
        S: SceneScheme<D, L::Ready>,
        S::Memory: Carried,
    {
        let mut stepper = self.stepper()?;
        stepper.restore(checkpoint).map_err(Error::Checkpoint)?;
        Ok(stepper)
    }
}

impl<const D: usize, A: Acts<D>, S: SceneScheme<D, A>> SceneStepper<D, A, S>
where
    S::Memory: Carried,
{
    /// All that is needed to go on from here; see [`Checkpoint`].
    pub fn checkpoint(&self) -> Checkpoint {
        let setting = &self.system.setting;
        let bodies = setting.masses.len();
        let pinned = |body: &usize| setting.pinned && setting.kick.get(*body).iter().all(|&kick| kick == 0.0);
        Checkpoint {
            format: FORMAT,
            scheme: S::NAME.to_owned(),
            options: Checkpoint::options(&self.scheme),
            dimension: D,
            bodies,
            times: Numbers(vec![self.t0, setting.dt, self.t()]),
            masses: Numbers(setting.masses.clone()),
            pins: (0..bodies).filter(pinned).collect(),
            laws: self.fingerprint(),
            fields: self.fields().saved(),
            steps: self.steps,
            evaluations: self.evaluations,
            iterations: self.iterations,
            start: [&self.start.0, &self.start.1].map(|x| Numbers(x.flat().to_vec())).into(),
            memory: save(&self.memory),
            seals: Vec::new(),
        }
        .sealed()
    }

    fn restore(&mut self, saved: &Checkpoint) -> Result<(), Difference> {
        saved.fits::<S>(&self.checkpoint())?;
        self.fields().compare(&saved.fields)?;
        for (place, numbers) in [&mut self.start.0, &mut self.start.1].into_iter().zip(&saved.start) {
            numbers.copy_to(place.flat_mut())?;
        }
        load(&mut self.memory, &saved.memory)?;
        (self.steps, self.evaluations, self.iterations) = (saved.steps, saved.evaluations, saved.iterations);
        self.before = self.memory.clone();
        if self.fingerprint() == saved.laws { Ok(()) } else { Err(Difference::Laws) }
    }

    /// What the laws read of themselves and of the bodies, and whom they link.
    fn fields(&self) -> Fields<&'static str> {
        let mut fields = Fields::new();
        self.system.acts.fields(&mut |name, x| fields.see(name, x));
        fields
    }

    /// Φ, ∇Φ and F now, and where bodies and velocities are displaced.
    fn fingerprint(&self) -> Fingerprint {
        let (t, acts) = (self.t(), &self.system.acts);
        let (mut q, mut v) = (self.q().clone(), self.scheme.velocity(&self.system, t, &self.memory));
        let mut out = Vectors::zeros(q.bodies());
        let mut fingerprint = Fingerprint::new();
        for probe in 0..2 {
            if probe == 1 {
                displaced(q.flat_mut());
                displaced(v.flat_mut());
            }
            fingerprint.add(acts.potential(&q, t));
            out.clear();
            acts.add_gradient(&q, t, &mut out);
            fingerprint.add_all(out.flat());
            out.clear();
            acts.subtract_force(1.0, &q, &v, t, &mut out);
            fingerprint.add_all(out.flat());
        }
        fingerprint
    }
}
