//! Atoms of a noble gas.

use crate::models;

/// Lennard-Jones' potential, Φ(r) = 4 ε ((σ/r)¹² − (σ/r)⁶).
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `epsilon` > 0 | E | depth of the well |
/// | `sigma` > 0 | L | distance at which Φ = 0 |
///
/// [`models::LennardJones`] is the same on a line for one body of the reduced mass.
///
/// # Domain
/// r > 0. The repulsion is steep: it limits the step of the explicit schemes.
/// # Invariants
/// Energy, linear and angular momentum.
/// # Source
/// J. E. Jones, Proc. R. Soc. A 106 (1924) 463; the exponents 12 and 6: J. E. Lennard-Jones, Proc. Phys. Soc. 43 (1931) 461.
///
/// ```
/// use dmech::{models::pairs::LennardJones, prelude::*};
///
/// let law = LennardJones { epsilon: 0.7, sigma: 1.1 };
/// let r = law.rest();
/// // A triangle of atoms at rest, one of them pushed.
/// let atoms = Scene::new()
///     .body(1.0, [0.0, 0.0], [0.0, 0.0])
///     .body(1.0, [r, 0.0], [0.2, 0.1])
///     .body(1.0, [0.5 * r, 0.75_f64.sqrt() * r], [0.0, 0.0]);
/// let run = Simulation::scene(atoms.pairs(law)).scheme(DiscreteGradient).dt(0.01).run(1000)?;
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LennardJones {
    /// Depth of the well.
    pub epsilon: f64,
    /// Distance at which the potential is zero.
    pub sigma: f64,
}

impl Default for LennardJones {
    /// ε = σ = 1.
    fn default() -> Self {
        LennardJones { epsilon: 1.0, sigma: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl LennardJones {
    /// Φ(r) = 4 ε ((σ/r)¹² − (σ/r)⁶).
    #[pair]
    pub fn energy(&self, r: f64) -> f64 {
        let s6 = (self.sigma / r).powi(6);
        4.0 * self.epsilon * (s6 * s6 - s6)
    }
}

impl LennardJones {
    fn on_a_line(&self) -> models::LennardJones {
        models::LennardJones { epsilon: self.epsilon, sigma: self.sigma }
    }

    /// The distance at rest, 2^(1/6) σ, where Φ = −ε.
    ///
    /// ```
    /// let law = dmech::models::pairs::LennardJones { epsilon: 0.7, sigma: 1.3 };
    /// assert!((law.energy(law.rest()) + 0.7).abs() < 1e-15);
    /// ```
    pub fn rest(&self) -> f64 {
        self.on_a_line().rest()
    }

    /// The period of small vibrations of two atoms of reduced mass μ: 2π √(μ/Φ″) with Φ″ = 72 ε/(2^(1/3) σ²) at rest.
    ///
    /// ```
    /// let law = dmech::models::pairs::LennardJones { epsilon: 2.0_f64.cbrt() / 72.0, sigma: 0.5 };
    /// assert!((law.small_period(4.0) - 2.0 * core::f64::consts::PI).abs() < 1e-15);
    /// ```
    pub fn small_period(&self, reduced: f64) -> f64 {
        self.on_a_line().small_period() * reduced.sqrt()
    }
}
