//! A charge in a uniform magnetic field.

use crate::State;

/// A charged particle in a uniform magnetic field, F = c v × B.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `charge` | charge | c |
/// | `field` | M/(T charge) | B, in x, y, z |
///
/// # Domain
/// All positions and velocities.
/// # Invariants
/// Energy: F·v = 0 identically, so it is one although the force depends on the velocity. `DiscreteGradient` keeps it to
/// round-off.
/// # Source
/// L. D. Landau, E. M. Lifshitz, *The Classical Theory of Fields*, §21, for small velocities.
///
/// ```
/// use dmech::{models::MagneticField, prelude::*};
///
/// let law = MagneticField { charge: 1.3, field: [0.2, -0.4, 0.9] };
/// let run = Simulation::new(law, State::new([0.0; 3], [0.3, 0.8, -0.5])).scheme(DiscreteGradient).dt(0.1).run(1000)?;
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MagneticField {
    /// Charge c.
    pub charge: f64,
    /// Field B.
    pub field: [f64; 3],
}

impl Default for MagneticField {
    /// Unit charge, unit field along z.
    fn default() -> Self {
        MagneticField { charge: 1.0, field: [0.0, 0.0, 1.0] }
    }
}

#[dmech_macros::law(crate = crate)]
impl MagneticField {
    /// F(v) = c v × B.
    #[force]
    pub fn lorentz(&self, v: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = v;
        [
            self.charge * (y * self.field[2] - z * self.field[1]),
            self.charge * (z * self.field[0] - x * self.field[2]),
            self.charge * (x * self.field[1] - y * self.field[0]),
        ]
    }
}

impl MagneticField {
    fn strength(&self) -> f64 {
        self.field.iter().map(|b| b * b).sum::<f64>().sqrt()
    }

    /// The time of one turn, 2π m/|c B|, whatever the velocity.
    ///
    /// ```
    /// let law = dmech::models::MagneticField { charge: -2.0, field: [0.6, 0.0, 0.8] };
    /// assert!((law.period(3.0) - 3.0 * core::f64::consts::PI).abs() < 1e-14);
    /// ```
    pub fn period(&self, mass: f64) -> f64 {
        core::f64::consts::TAU * mass / (self.charge * self.strength()).abs()
    }

    /// The position at time t: a helix about B from the state `start` (whose time counts as zero), mass m; c B ≠ 0.
    ///
    /// ```
    /// use dmech::{State, models::MagneticField};
    ///
    /// let law = MagneticField { charge: 2.0, field: [0.0, 0.0, 0.7] };
    /// let turn = law.exact(1.3, &State::new([1.0, 2.0, 3.0], [0.3, 0.4, 0.5]), law.period(1.3));
    /// assert!((turn[0] - 1.0).abs() < 1e-14 && (turn[2] - 3.0 - 0.5 * law.period(1.3)).abs() < 1e-14);
    /// ```
    pub fn exact(&self, mass: f64, start: &State<3>, t: f64) -> [f64; 3] {
        let strength = self.strength();
        let n = self.field.map(|b| b / strength);
        let (q, v) = (start.q, start.v);
        let omega = self.charge * strength / mass;
        let along = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
        let across = [v[1] * n[2] - v[2] * n[1], v[2] * n[0] - v[0] * n[2], v[0] * n[1] - v[1] * n[0]];
        let (sin, cos) = (omega * t).sin_cos();
        core::array::from_fn(|i| {
            q[i] + along * n[i] * t + (v[i] - along * n[i]) * sin / omega + across[i] * (1.0 - cos) / omega
        })
    }
}
