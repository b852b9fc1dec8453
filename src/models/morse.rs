//! Morse's molecule.

/// Morse's potential on a line, Φ(q) = D (1 − e^(−a (q − q₀)))².
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `depth` > 0 | E | energy of dissociation D |
/// | `width` > 0 | 1/L | steepness a |
/// | `length` | L | distance at rest q₀ |
///
/// # Domain
/// All positions; bound for E < D.
/// # Invariants
/// Energy.
/// # Source
/// P. M. Morse, Phys. Rev. 34 (1929) 57. The bound motion follows from w = e^(a (q − q₀)), for which w′² is a polynomial of
/// second degree in w.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Morse {
    /// Energy of dissociation D.
    pub depth: f64,
    /// Steepness a.
    pub width: f64,
    /// Distance at rest q₀.
    pub length: f64,
}

impl Default for Morse {
    /// D = a = q₀ = 1.
    fn default() -> Self {
        Morse { depth: 1.0, width: 1.0, length: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Morse {
    /// Φ(q) = D (1 − e^(−a (q − q₀)))².
    #[potential]
    pub fn energy(&self, q: f64) -> f64 {
        let s = 1.0 - (-self.width * (q - self.length)).exp();
        self.depth * s * s
    }
}

impl Morse {
    fn frequency(&self, energy: f64) -> f64 {
        self.width * (2.0 * (self.depth - energy)).sqrt()
    }

    /// The period of the bound motion with energy 0 ≤ E < D: 2π/(a √(2 (D − E))), unit mass.
    ///
    /// ```
    /// assert_eq!(dmech::models::Morse { depth: 2.5, width: 0.5, length: 1.2 }.period(0.5), 2.0 * core::f64::consts::PI);
    /// ```
    pub fn period(&self, energy: f64) -> f64 {
        core::f64::consts::TAU / self.frequency(energy)
    }

    /// The position at time t after rest at the outer turning point, 0 ≤ E < D, unit mass:
    /// q₀ + ln((1 + √ε cos ωt)/(1 − ε))/a with ε = E/D, ω = a √(2 (D − E)).
    ///
    /// ```
    /// let law = dmech::models::Morse { depth: 1.5, width: 1.2, length: 0.8 };
    /// for t in [0.0, 0.5 * law.period(0.9)] {
    ///     assert!((law.energy(law.exact(0.9, t)) - 0.9).abs() < 1e-14);
    /// }
    /// ```
    pub fn exact(&self, energy: f64, t: f64) -> f64 {
        let ratio = energy / self.depth;
        let w = (1.0 + ratio.sqrt() * (self.frequency(energy) * t).cos()) / (1.0 - ratio);
        self.length + w.ln() / self.width
    }
}
