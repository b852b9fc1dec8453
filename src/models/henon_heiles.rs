//! The potential of Hénon and Heiles.

/// Hénon and Heiles, Φ(x, y) = (x² + y²)/2 + λ (x² y − y³/3).
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `lambda` | 1/L | strength of the cubic terms; the frequency of small vibrations is the unit |
///
/// # Domain
/// All positions; bounded inside the triangle about the origin below the [escape energy](HenonHeiles::escape_energy).
/// # Invariants
/// Energy, and no other: the motion is chaotic at high energies.
/// # Source
/// M. Hénon, C. Heiles, Astron. J. 69 (1964) 73, with λ = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HenonHeiles {
    /// Strength of the cubic terms.
    pub lambda: f64,
}

impl Default for HenonHeiles {
    /// λ = 1, as published.
    fn default() -> Self {
        HenonHeiles { lambda: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl HenonHeiles {
    /// Φ(x, y) = (x² + y²)/2 + λ (x² y − y³/3).
    #[potential]
    pub fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        0.5 * (x * x + y * y) + self.lambda * (x * x * y - y * y * y / 3.0)
    }
}

impl HenonHeiles {
    /// 1/(6 λ²), the potential at the three saddles, one of which is (0, 1/λ).
    ///
    /// ```
    /// let law = dmech::models::HenonHeiles { lambda: 0.8 };
    /// assert!((law.energy([0.0, 1.0 / 0.8]) - law.escape_energy()).abs() < 1e-15);
    /// ```
    pub fn escape_energy(&self) -> f64 {
        (6.0 * self.lambda * self.lambda).recip()
    }
}
