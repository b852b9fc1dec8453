//! Duffing's oscillator.

use super::elliptic::{agm, jacobi};

/// Duffing's oscillator, Φ(q) = α q²/2 + β q⁴/4 with F = −δ v + γ cos ωt.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `alpha` | E/L² | linear stiffness; negative for two wells |
/// | `beta` | E/L⁴ | cubic stiffness; positive for bounded motion |
/// | `delta` ≥ 0 | E T/L² | friction |
/// | `gamma` | E/L | greatest driving force |
/// | `omega` | 1/T | driving frequency |
///
/// # Domain
/// All positions, velocities and times for β ≥ 0; for β < 0 the motion may escape.
/// # Invariants
/// None with friction or driving; the work-energy balance holds. The energy is kept in fact where δ = γ = 0, but that is
/// a matter of values and not of the form of the law, so runs do not report it.
/// # Source
/// G. Duffing, *Erzwungene Schwingungen bei veränderlicher Eigenfrequenz*, Vieweg (1918).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Duffing {
    /// Linear stiffness.
    pub alpha: f64,
    /// Cubic stiffness.
    pub beta: f64,
    /// Friction.
    pub delta: f64,
    /// Greatest driving force.
    pub gamma: f64,
    /// Driving frequency.
    pub omega: f64,
}

impl Default for Duffing {
    /// Two wells, driven to chaos.
    fn default() -> Self {
        Duffing { alpha: -1.0, beta: 1.0, delta: 0.3, gamma: 0.5, omega: 1.2 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Duffing {
    /// Φ(q) = α q²/2 + β q⁴/4.
    #[potential]
    pub fn energy(&self, q: f64) -> f64 {
        0.5 * self.alpha * q * q + 0.25 * self.beta * q.powi(4)
    }
    /// F(v, t) = −δ v + γ cos ωt.
    #[force]
    pub fn drive(&self, v: f64, t: f64) -> f64 {
        -self.delta * v + self.gamma * (self.omega * t).cos()
    }
}

impl Duffing {
    /// Frequency scale Ω and parameter m of the free oscillation A cn(Ωt | m).
    fn free(&self, amplitude: f64) -> (f64, f64) {
        let hardening = self.beta * amplitude * amplitude;
        let squared = self.alpha + hardening;
        (squared.sqrt(), 0.5 * hardening / squared)
    }

    /// The period of the free oscillation (δ = γ = 0) with amplitude A, for α ≥ 0, β ≥ 0, unit mass: 4 K(m)/Ω with
    /// Ω² = α + β A², m = β A²/(2 Ω²).
    ///
    /// ```
    /// let law = dmech::models::Duffing { alpha: 4.0, beta: 0.0, ..Default::default() };
    /// assert!((law.free_period(0.7) - core::f64::consts::PI).abs() < 1e-15);
    /// ```
    pub fn free_period(&self, amplitude: f64) -> f64 {
        let (frequency, m) = self.free(amplitude);
        core::f64::consts::TAU / (frequency * agm((1.0 - m).sqrt()))
    }

    /// The position at time t after release from rest at A, without friction and driving: A cn(Ωt | m), as
    /// [`free_period`](Duffing::free_period).
    ///
    /// ```
    /// let law = dmech::models::Duffing { alpha: 1.3, beta: 0.7, ..Default::default() };
    /// assert!((law.free_exact(0.9, 0.5 * law.free_period(0.9)) + 0.9).abs() < 1e-14);
    /// ```
    pub fn free_exact(&self, amplitude: f64, t: f64) -> f64 {
        let (frequency, m) = self.free(amplitude);
        amplitude * jacobi(frequency * t, m)[1]
    }
}
