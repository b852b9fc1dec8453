//! Bodies on springs.

/// A spring, Φ(r) = k (r − ℓ)²/2.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `k` > 0 | E/L² | stiffness |
/// | `length` ≥ 0 | L | length at rest ℓ |
///
/// The law is linear only on a line or with ℓ = 0: a spring that turns has a direction of its own.
///
/// # Domain
/// r > 0; a spring of length ℓ > 0 has no direction at r = 0. With ℓ = 0 it has a force there, 0, but as k (r − ℓ)/r is computed it is
/// 0/0: two bodies in one place are refused whatever ℓ is. Springs of no length whose bodies may meet are a law of their own, and a
/// linear one:
///
/// ```
/// use dmech::prelude::*;
///
/// struct Tie {
///     k: f64,
/// }
///
/// #[dmech::law]
/// impl Tie {
///     #[pair]
///     fn energy(&self, r: f64) -> f64 {
///         0.5 * self.k * r * r
///     }
/// }
///
/// let meeting = Scene::new().body(1.0, [0.3, 0.1], [0.5, 0.0]).body(2.0, [0.3, 0.1], [-0.25, 0.0]);
/// let run = Simulation::scene(meeting.pairs(Tie { k: 1.3 })).scheme(DiscreteGradient).dt(0.02).run(1000)?;
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Invariants
/// Energy, linear and angular momentum.
/// # Source
/// R. Hooke, *Lectures de potentia restitutiva, or of spring* (1678).
///
/// ```
/// use dmech::{models::pairs::Spring, prelude::*};
///
/// // A triangle of springs that turns, stretched.
/// let triangle = Scene::new()
///     .body(1.0, [1.0, 0.0], [0.0, 0.9])
///     .body(0.7, [-1.1, 0.2], [0.1, -0.8])
///     .body(1.9, [0.1, -2.3], [-0.5, 0.0]);
/// let law = Spring { k: 1.3, length: 0.9 };
/// let run = Simulation::scene(triangle.pairs(law)).scheme(DiscreteGradient).dt(0.02).run(1000)?;
/// for kept in [Invariant::Energy, Invariant::AngularMomentum] {
///     assert!(run.drift(kept).unwrap().max_relative() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Stiffness.
    pub k: f64,
    /// Length at rest.
    pub length: f64,
}

impl Default for Spring {
    /// k = ℓ = 1.
    fn default() -> Self {
        Spring { k: 1.0, length: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Spring {
    /// Φ(r) = k (r − ℓ)²/2.
    #[pair]
    pub fn energy(&self, r: f64) -> f64 {
        0.5 * self.k * (r - self.length).powi(2)
    }
}

impl Spring {
    /// The period of two bodies of reduced mass μ that vibrate along the spring and do not turn, 2π √(μ/k), as long as
    /// they do not meet.
    ///
    /// ```
    /// use dmech::{models::pairs::Spring, prelude::*};
    ///
    /// let law = Spring { k: 3.0, length: 1.2 };
    /// let period = law.period(0.75);
    /// let pair = Scene::new().body(1.0, [0.0], [0.0]).body(3.0, [1.5], [0.0]).chain(law);
    /// let run = Simulation::scene(pair).scheme(DiscreteGradient).dt(period / 2000.0).run(2000)?;
    /// assert!((run.last().q[1][0] - run.last().q[0][0] - 1.5).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn period(&self, reduced: f64) -> f64 {
        core::f64::consts::TAU * (reduced / self.k).sqrt()
    }
}
