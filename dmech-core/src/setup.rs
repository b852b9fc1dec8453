//! What a simulation is set up from: a law and a state, or a scene.

use dmech_scalar::Real;

use crate::error::Error;
use crate::law::Law;
use crate::span::moves_on;
use crate::state::State;
use crate::system::{Particle, System};

/// Where a motion starts from: a [`State`] under a law `L`, or a `Scene` with its own laws, of which
/// [`Simulation`](crate::Simulation) makes a [`System`].
pub trait Setup<L> {
    /// What is recorded.
    type State: Clone + core::fmt::Debug;
    /// What moves.
    type System: System<State = Self::State>;

    /// The state at the start.
    fn start(&self) -> Self::State;
    /// The same from another state.
    fn starting_from(self, state: &Self::State) -> Self;
    /// The mass that a report shows, of a simulation with the mass `mass`.
    fn whole_mass(&self, mass: f64) -> f64;
    /// The system, for steps of about the length dt.
    ///
    /// # Errors
    /// [`Error`] for input that is refused.
    fn system(self, law: L, mass: f64, dt: f64) -> Result<Self::System, Error>;
}

impl<L: Law<D, R>, const D: usize, R: Real> Setup<L> for State<D, R> {
    type State = Self;
    type System = Particle<L, D, R>;

    fn start(&self) -> Self {
        *self
    }

    fn starting_from(self, state: &Self) -> Self {
        *state
    }

    fn whole_mass(&self, mass: f64) -> f64 {
        mass
    }

    fn system(self, law: L, mass: f64, dt: f64) -> Result<Particle<L, D, R>, Error> {
        let particle = Particle::new(law, mass);
        particle.check_masses(mass)?;
        particle.check(&self)?;
        moves_on(self.t, dt, particle.resolution())?;
        Ok(particle)
    }
}
