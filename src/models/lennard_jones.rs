//! Two atoms of a noble gas on a line.

/// Lennard-Jones' potential on a line, Φ(q) = 4 ε ((σ/q)¹² − (σ/q)⁶).
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `epsilon` > 0 | E | depth of the well |
/// | `sigma` > 0 | L | distance at which Φ = 0 |
///
/// q is the distance of the two atoms; the mass of the simulation is the reduced mass.
///
/// # Domain
/// q > 0; bound for E < 0.
/// # Invariants
/// Energy.
/// # Source
/// J. E. Jones, Proc. R. Soc. A 106 (1924) 463; the exponents 12 and 6: J. E. Lennard-Jones, Proc. Phys. Soc. 43 (1931) 461.
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
    /// Φ(q) = 4 ε ((σ/q)¹² − (σ/q)⁶).
    #[potential]
    pub fn energy(&self, q: f64) -> f64 {
        let s6 = (self.sigma / q).powi(6);
        4.0 * self.epsilon * (s6 * s6 - s6)
    }
}

impl LennardJones {
    /// The distance at rest, 2^(1/6) σ, where Φ = −ε.
    ///
    /// ```
    /// let law = dmech::models::LennardJones { epsilon: 0.7, sigma: 1.3 };
    /// assert!((law.energy(law.rest()) + 0.7).abs() < 1e-15);
    /// ```
    pub fn rest(&self) -> f64 {
        2.0_f64.powf(1.0 / 6.0) * self.sigma
    }

    /// The period of small vibrations, 2π/√Φ″ with Φ″ = 72 ε/(2^(1/3) σ²) at rest, unit mass.
    ///
    /// ```
    /// use dmech::{Potential, models::LennardJones};
    ///
    /// let law = LennardJones { epsilon: 0.7, sigma: 1.3 };
    /// let stiffness = law.hessian([law.rest()])[0][0];
    /// assert!((law.small_period() * stiffness.sqrt() - core::f64::consts::TAU).abs() < 1e-13);
    /// ```
    pub fn small_period(&self) -> f64 {
        core::f64::consts::TAU * self.sigma / (72.0 * self.epsilon / 2.0_f64.cbrt()).sqrt()
    }
}
