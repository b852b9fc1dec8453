//! The chain of Fermi, Pasta, Ulam and Tsingou.

/// The spring of Fermi, Pasta, Ulam and Tsingou, Φ = k r²/2 + α r³/3 + β r⁴/4, with r = −d = q_b − q_a.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `k` > 0 | E/L² | linear stiffness |
/// | `alpha` | E/L³ | quadratic part of the force |
/// | `beta` ≥ 0 | E/L⁴ | cubic part of the force |
///
/// The positions of a chain are the displacements of its masses from rest, so that r is by how much the spring from a to b,
/// the next on the chain, is longer than at rest. A law of one's own that has only one of α and β is cheaper than this one with
/// the other at 0: a leap-frog step of a chain takes about 6 % less without β and 27 % less without α.
///
/// # Domain
/// A line; all positions. With β = 0 the energy has no lower bound beyond r = −k/α, where the spring gives way.
/// # Invariants
/// Energy and linear momentum; with pinned ends the energy. Weakly excited, it is near a [`Toda`](super::Toda) chain and keeps
/// the shape of its spectrum for very long.
/// # Source
/// E. Fermi, J. Pasta, S. Ulam, with M. Tsingou, *Studies of nonlinear problems*, Los Alamos report LA-1940 (1955), (1) for
/// β = 0 and (2) for α = 0, with k = 1.
///
/// ```
/// use dmech::{models::pairs::FermiPastaUlamTsingou, prelude::*};
///
/// // Sixteen springs between walls, bent as the first mode.
/// let mut chain = Scene::new();
/// for j in 0..=16 {
///     let shape = if j == 16 { 0.0 } else { (core::f64::consts::PI * f64::from(j) / 16.0).sin() };
///     chain = chain.body(1.0, [shape], [0.0]);
/// }
/// let chain = chain.pin(0).pin(16).chain(FermiPastaUlamTsingou { k: 1.0, alpha: 0.25, beta: 0.0 });
/// let run = Simulation::scene(chain).scheme(DiscreteGradient).dt(0.1).run(10_000)?;
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FermiPastaUlamTsingou {
    /// Linear stiffness.
    pub k: f64,
    /// Quadratic part of the force.
    pub alpha: f64,
    /// Cubic part of the force.
    pub beta: f64,
}

impl Default for FermiPastaUlamTsingou {
    /// k = 1, α = 1/4, β = 0, as in the first figure of the report.
    fn default() -> Self {
        FermiPastaUlamTsingou { k: 1.0, alpha: 0.25, beta: 0.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl FermiPastaUlamTsingou {
    /// Φ = k r²/2 + α r³/3 + β r⁴/4 with r = −d.
    #[pair]
    pub fn energy(&self, d: f64) -> f64 {
        let r = -d;
        r * r * (0.5 * self.k + r * (self.alpha / 3.0 + self.beta * r / 4.0))
    }
}

impl FermiPastaUlamTsingou {
    /// The frequency of mode j of small vibrations of n equal springs between walls, with n − 1 equal masses:
    /// 2 √(k/m) sin(πj/2n).
    ///
    /// ```
    /// let law = dmech::models::pairs::FermiPastaUlamTsingou { k: 3.0, ..Default::default() };
    /// assert!((law.small_frequency(1, 2, 6.0) - 1.0).abs() < 1e-15);
    /// ```
    pub fn small_frequency(&self, mode: usize, springs: usize, mass: f64) -> f64 {
        let half_wave = core::f64::consts::FRAC_PI_2 * mode as f64 / springs as f64;
        2.0 * (self.k / mass).sqrt() * half_wave.sin()
    }
}
