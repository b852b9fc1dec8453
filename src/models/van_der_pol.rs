//! Van der Pol's oscillator.

/// Van der Pol's oscillator, F = μ (1 − q²) v − q: a force and no potential.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `mu` ≥ 0 | 1 | strength of the feedback; the natural frequency and the amplitude where it changes sign are units |
///
/// # Domain
/// All positions and velocities; every motion but rest tends to the limit cycle. Stiff for large μ.
/// # Invariants
/// None; the work-energy balance holds.
/// # Source
/// B. van der Pol, Phil. Mag. 2 (1926) 978.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VanDerPol {
    /// Strength of the feedback.
    pub mu: f64,
}

impl Default for VanDerPol {
    /// μ = 1.
    fn default() -> Self {
        VanDerPol { mu: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl VanDerPol {
    /// F(q, v) = μ (1 − q²) v − q.
    #[force]
    pub fn feedback(&self, q: f64, v: f64) -> f64 {
        self.mu * (1.0 - q * q) * v - q
    }
}

impl VanDerPol {
    /// The period of the limit cycle for small μ, unit mass: 2π (1 + μ²/16 − 5 μ⁴/3072), error O(μ⁶).
    ///
    /// ```
    /// assert!((dmech::models::VanDerPol { mu: 0.1 }.weak_period() - 6.287_111).abs() < 1e-6);
    /// ```
    pub fn weak_period(&self) -> f64 {
        let m2 = self.mu * self.mu;
        core::f64::consts::TAU * (1.0 + m2 / 16.0 - 5.0 * m2 * m2 / 3072.0)
    }

    /// The leading term of the period for large μ, (3 − 2 ln 2) μ, unit mass; the next is 7.014 μ^(−1/3).
    ///
    /// ```
    /// assert!((dmech::models::VanDerPol { mu: 1e3 }.relaxation_period() - 1613.705_639).abs() < 1e-6);
    /// ```
    pub fn relaxation_period(&self) -> f64 {
        (3.0 - 2.0 * core::f64::consts::LN_2) * self.mu
    }
}
