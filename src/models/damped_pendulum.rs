//! The pendulum with friction.

/// The damped pendulum, Φ(q) = −k cos q with F = −α v.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `k` > 0 | E | greatest torque; with unit mass g/l |
/// | `alpha` ≥ 0 | E T | friction, torque per angular velocity |
///
/// # Domain
/// All angles and velocities.
/// # Invariants
/// None; dE/dt = −α v². The work-energy balance holds by each scheme's own definition of work.
/// # Source
/// Greenspan, TR 122 (1971), §4: q″ = −α q′ − sin q.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedPendulum {
    /// Greatest torque.
    pub k: f64,
    /// Friction.
    pub alpha: f64,
}

impl Default for DampedPendulum {
    /// k = 1, α = 0.1.
    fn default() -> Self {
        DampedPendulum { k: 1.0, alpha: 0.1 }
    }
}

#[dmech_macros::law(crate = crate)]
impl DampedPendulum {
    /// Φ(q) = −k cos q.
    #[potential]
    pub fn energy(&self, q: f64) -> f64 {
        -self.k * q.cos()
    }
    /// F(v) = −α v.
    #[force]
    pub fn friction(&self, v: f64) -> f64 {
        -self.alpha * v
    }
}

impl DampedPendulum {
    /// The period of small damped swings, 2π/√(k − α²/4) for α < 2√k, unit mass; NaN when overdamped.
    pub fn small_period(&self) -> f64 {
        core::f64::consts::TAU / (self.k - 0.25 * self.alpha * self.alpha).sqrt()
    }

    /// The steps for which small swings stay bounded under `Explicit`: dt < min(2α/k, 2/α), unit mass.
    ///
    /// One step of the linear law has determinant 1 − hα + h²k/2 and trace 2 − hα − h²k/2; both eigenvalues lie in the
    /// unit disc exactly for these h. With k = 1 it is min(2α, 2/α).
    ///
    /// ```
    /// use dmech::{models::DampedPendulum, prelude::*};
    ///
    /// let law = DampedPendulum { k: 1.3, alpha: 0.2 };
    /// let far = |dt: f64| {
    ///     let run = Simulation::new(law, State::new([1e-6], [0.0])).scheme(Explicit).dt(dt).run(2000).unwrap();
    ///     run.last().q[0].abs()
    /// };
    /// assert!(far(0.98 * law.explicit_limit()) < 1e-6 && far(1.02 * law.explicit_limit()) > 1e-6);
    /// ```
    pub fn explicit_limit(&self) -> f64 {
        (2.0 * self.alpha / self.k).min(2.0 / self.alpha)
    }
}
