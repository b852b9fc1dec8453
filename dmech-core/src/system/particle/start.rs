//! What a motion may start from.

use dmech_scalar::{Mask, Real};

use super::Particle;
use super::range::lost_force;
use crate::error::Error;
use crate::law::written::{Probe, agree};
use crate::law::{Field, Law, Potential};
use crate::state::State;
use crate::system::System;

impl<L: Law<D, R>, const D: usize, R: Real> Particle<L, D, R> {
    /// Refuses masses that are not numbers.
    pub(crate) fn check_masses(&self, mass: f64) -> Result<(), Error> {
        let positive = |x: f64| x > 0.0 && x.is_finite();
        if !positive(mass) || !positive(self.mass.to_f64()) {
            return Err(Error::Mass { mass });
        }
        for ratio in self.law.mass_ratios() {
            if !positive(ratio)
                || !positive(R::from_f64(ratio).to_f64())
                || !positive(R::from_f64(ratio * mass).to_f64())
            {
                return Err(Error::Mass { mass: ratio });
            }
        }
        Ok(())
    }

    /// Refuses states that are not of numbers.
    pub(super) fn check_state(&self, state: &State<D, R>) -> Result<(), Error> {
        if !state.t.is_finite() {
            return Err(Error::State { quantity: "t", value: state.t });
        }
        for (quantity, components) in [("q", &state.q), ("v", &state.v)] {
            if let Some(value) = components.iter().find(|x| !x.finite().all()) {
                return Err(Error::State { quantity, value: value.to_f64() });
            }
        }
        Ok(())
    }

    /// Refuses laws that pin a body which moves, also those that come in on the way.
    fn check_pins(&self, #[cfg_attr(not(feature = "scene"), expect(unused))] v: &[R; D]) -> Result<(), Error> {
        #[cfg(feature = "scene")]
        for (i, v) in v.iter().enumerate() {
            if self.law.pinned(i) && !v.equal(R::ZERO).all() {
                return Err(crate::error::SceneError::PinnedMoves { body: i / L::BODY, speed: v.to_f64() }.into());
            }
        }
        Ok(())
    }

    /// ∇Φ − F, where the law has a value and is what was written.
    pub(super) fn slope_at_the_start(&self, start: &State<D, R>) -> Result<[R; D], Error> {
        self.law.refused().map_or(Ok(()), Err)?;
        self.check_pins(&start.v)?;
        let field = self.field(R::from_f64(start.t));
        let potential = field.potential(start.q);
        if !potential.finite().all() {
            return Err(Error::Law { quantity: "potential", value: potential.to_f64(), time: start.t });
        }
        let slope = field.slope(start.q, start.v);
        if let Some(value) = slope.iter().find(|x| !x.finite().all()) {
            return Err(Error::Law { quantity: "force", value: value.to_f64(), time: start.t });
        }
        let kinetic = self.kinetic_energy(&start.v).to_f64();
        if let Some((coordinate, slope)) = lost_force(&field, start.q, kinetic, |i| self.law.pinned(i)) {
            return Err(Error::Underflow { coordinate, slope, time: start.t });
        }
        if let Some(written) = self.law.written() {
            let [q, v] = [start.q, start.v].map(|x| x.map(R::to_f64));
            let place = Probe { q, v: [v; 2], m: [self.mass.to_f64(); 2], t: start.t };
            agree(written, &place, true).map_err(Error::NotAsWritten)?;
        }
        Ok(slope)
    }
}
