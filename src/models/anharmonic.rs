//! Three coupled anharmonic vibrations.

/// An anharmonic well in space, Φ = k (x² + 2 y² + 3 z²)/2 + c x y z + d (x + y − z)⁴/4.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `k` > 0 | E/L² | stiffness |
/// | `c` | E/L³ | cubic coupling |
/// | `d` ≥ 0 | E/L⁴ | quartic coupling |
///
/// # Domain
/// All positions; bounded near the origin. The cubic term wins far out where x + y = z.
/// # Invariants
/// Energy.
/// # Source
/// A test problem of this project: no symmetry, a full Hessian in three coordinates, three incommensurable frequencies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anharmonic {
    /// Stiffness.
    pub k: f64,
    /// Cubic coupling.
    pub c: f64,
    /// Quartic coupling.
    pub d: f64,
}

impl Default for Anharmonic {
    /// k = 1, c = 0.5, d = 1.
    fn default() -> Self {
        Anharmonic { k: 1.0, c: 0.5, d: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Anharmonic {
    /// Φ = k (x² + 2 y² + 3 z²)/2 + c x y z + d (x + y − z)⁴/4.
    #[potential]
    pub fn energy(&self, q: [f64; 3]) -> f64 {
        let [x, y, z] = q;
        0.5 * self.k * (x * x + 2.0 * y * y + 3.0 * z * z) + self.c * x * y * z + 0.25 * self.d * (x + y - z).powi(4)
    }
}

impl Anharmonic {
    /// The periods of small vibrations along x, y and z, 2π/√(n k) for n = 1, 2, 3, unit mass.
    ///
    /// ```
    /// let [x, _, _] = dmech::models::Anharmonic { k: 4.0, c: 0.3, d: 0.2 }.small_periods();
    /// assert_eq!(x, core::f64::consts::PI);
    /// ```
    pub fn small_periods(&self) -> [f64; 3] {
        [1.0, 2.0, 3.0].map(|n: f64| core::f64::consts::TAU / (n * self.k).sqrt())
    }
}
