//! The pendulum with friction and a periodic torque.

/// The damped and driven pendulum, Φ(q) = −k cos q with F = −α v + a cos ωt.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `k` > 0 | E | greatest torque of gravity; with unit mass g/l |
/// | `alpha` ≥ 0 | E T | friction |
/// | `amplitude` | E | greatest driving torque |
/// | `omega` | 1/T | driving frequency |
///
/// # Domain
/// All angles, velocities and times. With the default parameters the motion is chaotic.
/// # Invariants
/// None; the work-energy balance holds.
/// # Source
/// G. L. Baker, J. P. Gollub, *Chaotic Dynamics: An Introduction*, Cambridge University Press (1990), ch. 3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrivenPendulum {
    /// Greatest torque of gravity.
    pub k: f64,
    /// Friction.
    pub alpha: f64,
    /// Greatest driving torque.
    pub amplitude: f64,
    /// Driving frequency.
    pub omega: f64,
}

impl Default for DrivenPendulum {
    /// Quality factor 2, driving 1.5 at two thirds of the natural frequency: chaos.
    fn default() -> Self {
        DrivenPendulum { k: 1.0, alpha: 0.5, amplitude: 1.5, omega: 2.0 / 3.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl DrivenPendulum {
    /// Φ(q) = −k cos q.
    #[potential]
    pub fn energy(&self, q: f64) -> f64 {
        -self.k * q.cos()
    }
    /// F(v, t) = −α v + a cos ωt.
    #[force]
    pub fn torque(&self, v: f64, t: f64) -> f64 {
        -self.alpha * v + self.amplitude * (self.omega * t).cos()
    }
}

impl DrivenPendulum {
    /// The period of the driving torque, 2π/ω: the time between points of a Poincaré section.
    ///
    /// ```
    /// let law = dmech::models::DrivenPendulum { omega: 0.5, ..Default::default() };
    /// assert_eq!(law.driving_period(), 4.0 * core::f64::consts::PI);
    /// ```
    pub fn driving_period(&self) -> f64 {
        core::f64::consts::TAU / self.omega
    }
}
