//! Contact with a wall.

/// A particle driven against a wall that gives way, Φ(q) = g q + k max(−q, 0)²/2.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `k` > 0 | E/L² | stiffness of the wall, a one-sided spring at q < 0 |
/// | `pull` ≥ 0 | E/L | constant force g towards the wall; weight |
///
/// # Domain
/// All positions. The force is continuous and has a kink at q = 0; a step across the kink has a local error of its own,
/// so the measured order is not that of the scheme, while `DiscreteGradient` keeps the energy all the same.
/// # Invariants
/// Energy.
/// # Source
/// The one-sided linear spring of penalty methods: P. Wriggers, *Computational Contact Mechanics*, Springer (2006), ch. 6.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// Stiffness of the wall.
    pub k: f64,
    /// Force towards the wall.
    pub pull: f64,
}

impl Default for Wall {
    /// k = 100, g = 1.
    fn default() -> Self {
        Wall { k: 100.0, pull: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Wall {
    /// Φ(q) = g q + k max(−q, 0)²/2.
    #[potential]
    pub fn energy(&self, q: f64) -> f64 {
        let depth = (-q).max(0.0);
        self.pull * q + 0.5 * self.k * depth * depth
    }
}

impl Wall {
    /// The duration of a contact that begins with speed u > 0: 2 (π − atan(u √k/g))/√k, unit mass; π/√k for g = 0.
    ///
    /// ```
    /// let contact = dmech::models::Wall { k: 4.0, pull: 0.0 }.contact_time(0.7);
    /// assert!((contact - core::f64::consts::FRAC_PI_2).abs() < 1e-15);
    /// ```
    pub fn contact_time(&self, speed: f64) -> f64 {
        let root = self.k.sqrt();
        2.0 * (core::f64::consts::PI - (speed * root).atan2(self.pull)) / root
    }

    /// The period of the bouncing that meets the wall with speed u > 0: flight 2 u/g and contact, unit mass, g > 0.
    ///
    /// ```
    /// use dmech::{models::Wall, prelude::*};
    ///
    /// let law = Wall { k: 40.0, pull: 1.3 };
    /// let period = law.period(0.9);
    /// let start = State::new([0.0], [0.9]);
    /// let run = Simulation::new(law, start).scheme(DiscreteGradient).dt(period / 4000.0).run(4000)?;
    /// assert!(run.last().q[0].abs() < 1e-4 && (run.last().v[0] - 0.9).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn period(&self, speed: f64) -> f64 {
        2.0 * speed / self.pull + self.contact_time(speed)
    }
}
