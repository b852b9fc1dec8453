//! The quartic well.

use super::elliptic::{agm, jacobi};

/// The purely quartic well, Φ(q) = β q⁴/4.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `beta` > 0 | E/L⁴ | stiffness |
///
/// # Domain
/// All positions. There are no small harmonic vibrations: the frequency is proportional to the amplitude.
/// # Invariants
/// Energy.
/// # Source
/// L. D. Landau, E. M. Lifshitz, *Mechanics*, §11, problem 2 (Φ = A |q|ⁿ with n = 4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quartic {
    /// Stiffness.
    pub beta: f64,
}

impl Default for Quartic {
    /// β = 1.
    fn default() -> Self {
        Quartic { beta: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Quartic {
    /// Φ(q) = β q⁴/4.
    #[potential]
    pub fn energy(&self, q: f64) -> f64 {
        0.25 * self.beta * q.powi(4)
    }
}

impl Quartic {
    /// The period of the vibration with amplitude A > 0: 4 K(½)/(√β A), unit mass.
    ///
    /// ```
    /// assert!((dmech::models::Quartic { beta: 4.0 }.period(0.5) - 7.416_298_709_205_487).abs() < 1e-14);
    /// ```
    pub fn period(&self, amplitude: f64) -> f64 {
        core::f64::consts::TAU / (self.beta.sqrt() * amplitude * agm(core::f64::consts::FRAC_1_SQRT_2))
    }

    /// The position at time t after release from rest at A: A cn(√β A t | ½), unit mass.
    ///
    /// ```
    /// let law = dmech::models::Quartic { beta: 1.7 };
    /// assert!((law.exact(0.9, 0.5 * law.period(0.9)) + 0.9).abs() < 1e-14);
    /// ```
    pub fn exact(&self, amplitude: f64, t: f64) -> f64 {
        amplitude * jacobi(self.beta.sqrt() * amplitude * t, 0.5)[1]
    }
}
