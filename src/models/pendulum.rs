//! The pendulum without friction.

use super::elliptic::{agm, jacobi};

/// The plane pendulum, Φ(q) = −k cos q.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `k` > 0 | E | greatest torque, m g l; with unit mass g/l |
///
/// q is the angle from the lowest point; the mass of the simulation is the moment of inertia.
///
/// # Domain
/// All angles. |E| < k swings, E > k rotates, E = k is the separatrix.
/// # Invariants
/// Energy.
/// # Source
/// L. D. Landau, E. M. Lifshitz, *Mechanics*, §11, problem 1 (period); Greenspan, TR 122 (1971), §4 with α = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pendulum {
    /// Greatest torque.
    pub k: f64,
}

impl Default for Pendulum {
    /// k = 1, Greenspan's.
    fn default() -> Self {
        Pendulum { k: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Pendulum {
    /// Φ(q) = −k cos q.
    #[potential]
    pub fn energy(&self, q: f64) -> f64 {
        -self.k * q.cos()
    }
}

impl Pendulum {
    /// The period of a swing with amplitude 0 ≤ A < π: 4 K(sin²(A/2))/√k, unit mass.
    ///
    /// ```
    /// let law = dmech::models::Pendulum { k: 4.0 };
    /// assert!((law.period(1e-6) - core::f64::consts::PI).abs() < 1e-11);
    /// assert!((law.period(core::f64::consts::FRAC_PI_2) - 3.708_149_354_602_744).abs() < 1e-14);
    /// ```
    pub fn period(&self, amplitude: f64) -> f64 {
        core::f64::consts::TAU / (self.k.sqrt() * agm((0.5 * amplitude).cos()))
    }

    /// The angle at time t after release from rest at A, |A| < π: 2 asin(s cd(√k t | s²)) with s = sin(A/2), unit mass.
    ///
    /// ```
    /// let law = dmech::models::Pendulum { k: 1.7 };
    /// let half = 0.5 * law.period(2.0);
    /// assert!((law.exact(2.0, 0.0) - 2.0).abs() < 1e-14 && (law.exact(2.0, half) + 2.0).abs() < 1e-14);
    /// ```
    pub fn exact(&self, amplitude: f64, t: f64) -> f64 {
        let s = (0.5 * amplitude).sin();
        let [_, cn, dn] = jacobi(self.k.sqrt() * t, s * s);
        2.0 * (s * cn / dn).asin()
    }
}
