//! Atoms in a molecule.

use crate::models;

/// Morse's potential, Φ(r) = D (1 − e^(−a (r − r₀)))².
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `depth` > 0 | E | energy of dissociation D |
/// | `width` > 0 | 1/L | steepness a |
/// | `length` > 0 | L | distance at rest r₀ |
///
/// [`models::Morse`] is the same on a line for one body of the reduced mass.
///
/// # Domain
/// r > 0; the bond holds while the energy of the vibration is below D. At r = 0 the energy is finite and the force has no
/// direction.
/// # Invariants
/// Energy, linear and angular momentum.
/// # Source
/// P. M. Morse, Phys. Rev. 34 (1929) 57, whose potential is this less D.
///
/// ```
/// use dmech::{models::pairs::Morse, prelude::*};
///
/// let law = Morse { depth: 1.5, width: 1.2, length: 0.8 };
/// let molecule = Scene::new()
///     .body(1.0, [0.0, 0.0, 0.0], [0.0, 0.2, 0.0])
///     .body(16.0, [0.8, 0.0, 0.0], [0.0, 0.0, 0.0])
///     .body(1.0, [0.9, 0.9, 0.0], [0.1, 0.0, -0.3]);
/// let run = Simulation::scene(molecule.chain(law)).scheme(DiscreteGradient).dt(0.02).run(1000)?;
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Morse {
    /// Energy of dissociation D.
    pub depth: f64,
    /// Steepness a.
    pub width: f64,
    /// Distance at rest r₀.
    pub length: f64,
}

impl Default for Morse {
    /// D = a = r₀ = 1.
    fn default() -> Self {
        Morse { depth: 1.0, width: 1.0, length: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Morse {
    /// Φ(r) = D (1 − e^(−a (r − r₀)))².
    #[pair]
    pub fn energy(&self, r: f64) -> f64 {
        let s = 1.0 - (-self.width * (r - self.length)).exp();
        self.depth * s * s
    }
}

impl Morse {
    /// The period of two bodies of reduced mass μ that vibrate along their bond with energy 0 ≤ E < D: 2π/(a √(2 (D − E)/μ)).
    ///
    /// ```
    /// let law = dmech::models::pairs::Morse { depth: 2.5, width: 0.5, length: 1.2 };
    /// assert_eq!(law.period(0.5, 4.0), 4.0 * core::f64::consts::PI);
    /// ```
    pub fn period(&self, energy: f64, reduced: f64) -> f64 {
        let Morse { depth, width, length } = *self;
        models::Morse { depth, width, length }.period(energy) * reduced.sqrt()
    }
}
