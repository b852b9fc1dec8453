//! Steppers that change between steps.

use core::ops::{Deref, DerefMut};

use dmech_scalar::Real;

use crate::error::Error;
use crate::invariant::Invariant;
use crate::law::Law;
use crate::scheme::Scheme;
use crate::span::{check_step, is_possible};
use crate::stepper::{Departure, Stepper};
use crate::system::{Particle, System};

/// Changes between steps, as a game makes them: from then on it is the motion of a new simulation from the state now, and what
/// the scheme carries is begun anew. Time and the counts of steps and of work go on.
impl<Y: System, S: Scheme<Y>> Stepper<Y, S> {
    /// The energy now, Σ m v²/2 + Φ(q), where the system keeps it.
    pub fn energy(&self) -> Option<f64> {
        let conserved = self.system.conserves(Invariant::Energy);
        conserved.then(|| self.system.energy(&self.state()).to_f64())
    }

    /// Goes on from another state: another place, another velocity, another time. Driven bodies are then where their paths lead.
    ///
    /// # Errors
    /// [`Error::State`] and what the start of a simulation may be refused for; the stepper then stays as it was.
    pub fn set_state(&mut self, state: Y::State) -> Result<(), Error> {
        let (steps, resolution) = (self.steps(), self.resolution());
        self.begin_at(Departure::another(steps, &self.system, &state, self.dt, resolution))
    }

    /// Goes on in steps of another length; the longest, where the steps follow the motion.
    ///
    /// # Errors
    /// [`Error::TimeStep`]; the stepper then stays as it was.
    pub fn set_dt(&mut self, dt: f64) -> Result<(), Error> {
        check_step::<Y::Scalar>(&self.scheme, dt)?;
        is_possible(self.t(), dt, self.resolution())?;
        let state = self.state();
        let before = core::mem::replace(&mut self.dt, dt);
        self.pace();
        let begun = self.begin_from(state);
        if begun.is_err() {
            self.dt = before;
            self.pace();
        }
        begun
    }

    fn pace(&mut self) {
        self.system.set_stride(&mut self.stride, Y::Scalar::from_f64(self.dt), S::SHARE);
        self.scheme.pace(&self.system, &self.stride, &mut self.workspace);
    }
}

/// A system with a law of the type X.
pub trait Holds<X> {
    /// The law, if there is one; the first, if there are several.
    fn law_mut(&mut self) -> Option<&mut X>;

    /// The law of a body, where each body has its own.
    fn law_of_mut(&mut self, _body: usize) -> Option<&mut X> {
        None
    }
}

impl<L: Law<D, R>, const D: usize, R: Real> Holds<L> for Particle<L, D, R> {
    fn law_mut(&mut self) -> Option<&mut L> {
        Some(Particle::law_mut(self))
    }
}

impl<L: Law<D, R> + Clone, S: Scheme<Particle<L, D, R>>, const D: usize, R: Real> Stepper<Particle<L, D, R>, S> {
    /// The law, to be changed: `stepper.law_mut().k = 4.0;`.
    ///
    /// The change counts when what this returns goes out of scope. A law that has no finite value where the motion is then
    /// stands in the way of the next step.
    pub fn law_mut(&mut self) -> LawMut<'_, Particle<L, D, R>, S, L> {
        let law = self.law().clone();
        LawMut { stepper: self, law, on: None, changed: false }
    }
}

/// A law of a stepper, to be changed.
pub struct LawMut<'a, Y: System + Holds<X>, S: Scheme<Y>, X: Clone> {
    pub(crate) stepper: &'a mut Stepper<Y, S>,
    pub(crate) law: X,
    /// Of this body.
    pub(crate) on: Option<usize>,
    pub(crate) changed: bool,
}

impl<Y: System + Holds<X>, S: Scheme<Y>, X: Clone> Deref for LawMut<'_, Y, S, X> {
    type Target = X;

    fn deref(&self) -> &X {
        &self.law
    }
}

impl<Y: System + Holds<X>, S: Scheme<Y>, X: Clone> DerefMut for LawMut<'_, Y, S, X> {
    fn deref_mut(&mut self) -> &mut X {
        self.changed = true;
        &mut self.law
    }
}

impl<Y: System + Holds<X>, S: Scheme<Y>, X: Clone> Drop for LawMut<'_, Y, S, X> {
    fn drop(&mut self) {
        if !self.changed {
            return;
        }
        let state = self.stepper.state();
        let system = &mut self.stepper.system;
        let law = match self.on {
            None => system.law_mut(),
            Some(body) => system.law_of_mut(body),
        };
        if let Some(law) = law {
            law.clone_from(&self.law);
        }
        self.stepper.begin_or_wait_at(state);
    }
}

impl<Y: System + Holds<X>, S: Scheme<Y>, X: Clone + core::fmt::Debug> core::fmt::Debug for LawMut<'_, Y, S, X> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_tuple("LawMut").field(&self.law).finish()
    }
}
