//! Bodies that attract each other by their masses.

use crate::models::Kepler;

/// Newton's gravity, Φ(r) = −g m_a m_b/r.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `g` > 0 | E L/M² | constant of gravity |
///
/// # Domain
/// r > 0. Bodies without angular momentum about each other collide; a collision ends the run.
/// # Invariants
/// Energy, linear and angular momentum. Of two bodies the Laplace-Runge-Lenz vector as well, which no scheme here keeps.
/// # Source
/// I. Newton, *Philosophiae naturalis principia mathematica* (1687), book III, proposition 7; the motion of two bodies:
/// L. D. Landau, E. M. Lifshitz, *Mechanics*, §13 and §15.
///
/// ```
/// use dmech::{models::pairs::Gravity, prelude::*};
///
/// let planets = Scene::new()
///     .body(5.0, [0.0, 0.0], [0.0, 0.0])
///     .body(0.3, [1.1, 0.2], [-0.2, 2.0])
///     .body(0.1, [-2.3, 0.1], [0.1, -1.3]);
/// let run = Simulation::scene(planets.pairs(Gravity { g: 0.9 })).scheme(DiscreteGradient).dt(0.01).run(1000)?;
/// for kept in [Invariant::Energy, Invariant::AngularMomentum] {
///     assert!(run.drift(kept).unwrap().max_relative() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gravity {
    /// Constant of gravity.
    pub g: f64,
}

impl Default for Gravity {
    /// g = 1.
    fn default() -> Self {
        Gravity { g: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Gravity {
    /// Φ(r) = −g m_a m_b/r.
    #[pair]
    pub fn energy(&self, r: f64, ma: f64, mb: f64) -> f64 {
        -self.g * ma * mb / r
    }
}

impl Gravity {
    /// The period of two bodies of masses m_a + m_b = m about each other: 2π √(a³/(g m)), where 2a is the sum of their
    /// smallest and their largest distance.
    ///
    /// ```
    /// assert_eq!(dmech::models::pairs::Gravity { g: 2.0 }.period(4.0, 2.0), 8.0 * core::f64::consts::PI);
    /// ```
    pub fn period(&self, half_axis: f64, mass: f64) -> f64 {
        Kepler { gm: self.g * mass }.period(half_axis)
    }
}
