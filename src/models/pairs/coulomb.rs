//! Bodies that attract or repel each other by their charges.

use crate::models::Kepler;

/// The charge of a body: the data that [`Coulomb`] reads, `.body_with(mass, position, velocity, Charge { q })`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Charge {
    /// Charge, of either sign.
    pub q: f64,
}

/// Coulomb's law, Φ(r) = k q_a q_b/r.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `k` > 0 | E L/charge² | constant of electrostatics, 1/(4πε₀) |
///
/// The charges belong to the bodies, which carry a [`Charge`]; what carries more than that, a radius or a kind, declares
/// this law in one line for a type of its own.
///
/// # Domain
/// r > 0. Opposite charges without angular momentum about each other collide; a collision ends the run.
/// # Invariants
/// Energy, linear and angular momentum. Two bodies move as under [`Gravity`](super::Gravity) with g m_a m_b = −k q_a q_b.
/// # Source
/// C. A. Coulomb, *Premier mémoire sur l'électricité et le magnétisme*, Mém. Acad. R. Sci. (1785) 569; the motion of two
/// charges: L. D. Landau, E. M. Lifshitz, *Mechanics*, §15.
///
/// ```
/// use dmech::models::pairs::{Charge, Coulomb};
/// use dmech::prelude::*;
///
/// let ions = Scene::new()
///     .body_with(1.0, [1.2, 0.0, 0.2], [0.0, 1.0, 0.0], Charge { q: 1.0 })
///     .body_with(6.0, [0.0, 0.1, 0.0], [0.0, -0.15, 0.0], Charge { q: -1.5 })
///     .body_with(1.5, [0.0, 4.0, -0.5], [-0.4, 0.0, 0.1], Charge { q: 0.7 });
/// let run = Simulation::scene(ions.pairs(Coulomb { k: 1.1 })).scheme(DiscreteGradient).dt(0.01).run(1000)?;
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coulomb {
    /// Constant of electrostatics.
    pub k: f64,
}

impl Default for Coulomb {
    /// k = 1.
    fn default() -> Self {
        Coulomb { k: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Coulomb {
    /// Φ(r) = k q_a q_b/r.
    #[pair]
    pub fn energy(&self, r: f64, a: &Charge, b: &Charge) -> f64 {
        self.k * a.q * b.q / r
    }
}

impl Coulomb {
    /// The period of two opposite charges about each other: 2π √(μ a³/(−k q_a q_b)), where 2a is the sum of their smallest
    /// and their largest distance and μ the reduced mass; NaN for charges that repel.
    ///
    /// ```
    /// use dmech::models::pairs::{Charge, Coulomb};
    ///
    /// let charges = [Charge { q: 2.0 }, Charge { q: -0.5 }];
    /// assert_eq!(Coulomb { k: 3.0 }.period(4.0, 3.0, charges), 16.0 * core::f64::consts::PI);
    /// ```
    pub fn period(&self, half_axis: f64, reduced: f64, [a, b]: [Charge; 2]) -> f64 {
        Kepler { gm: -self.k * a.q * b.q / reduced }.period(half_axis)
    }

    /// How close two charges of one sign come head-on with the energy E > 0 of their relative motion: k q_a q_b/E.
    ///
    /// ```
    /// use dmech::models::pairs::{Charge, Coulomb};
    ///
    /// let (law, charges) = (Coulomb { k: 1.3 }, [Charge { q: 2.0 }, Charge { q: 0.7 }]);
    /// let r = law.closest(0.4, charges);
    /// assert!((law.energy(r, &charges[0], &charges[1]) - 0.4).abs() < 1e-15);
    /// ```
    pub fn closest(&self, energy: f64, [a, b]: [Charge; 2]) -> f64 {
        self.k * a.q * b.q / energy
    }
}
