//! Gauss's method with eight stages, side by side.

mod cancelling;
mod ended;
mod line_integral;
mod parts;
mod step;
mod sweeps;

#[cfg(test)]
mod tests;

pub use line_integral::LineIntegral;
pub use step::GaussMemory;

use crate::system::tableau::{GAUSS, STAGES, Tableau};
use step::Stages;

use super::Method;
use crate::invariant::{Invariant, Kept};

/// Gauss's method with eight stages, which stand in the eight lanes of a register: the last digits of any smooth motion.
///
/// ```text
/// Vᵢ = v + h Σⱼ aᵢⱼ A(Qⱼ, Vⱼ, t + cⱼ h),   Qᵢ = q + h Σⱼ aᵢⱼ Vⱼ,   v′ = v + h Σ bⱼ Aⱼ,   q′ = q + h Σ bⱼ Vⱼ
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 16 | bounded, O(h¹⁶) | exact | yes, to the bit | yes | 4 to 15 sweeps of 8 forces side by side |
///
/// Each sweep puts the accelerations Aⱼ of the last into the positions of all stages, q + cᵢ h v + h² Σⱼ (A²)ᵢⱼ Aⱼ, which
/// contracts by h²; the first guess continues the polynomial of the last step. They end when only rounding is left.
/// Coefficients are such that the step is symplectic in floating point: μᵢⱼ = aᵢⱼ/bⱼ with μᵢⱼ + μⱼᵢ = 1. Sums are compensated.
/// Work is Σ bᵢ h F(Qᵢ)·Vᵢ, and changes the kinetic energy exactly.
///
/// It takes forces that depend on the velocity and the time as they are, and steps that differ. A step may be long: of a
/// period a tenth to a twentieth where twelve digits are wanted. Where its sweeps do not come nearer, a step is made in two halves, and
/// these again in halves; such steps, and those in which the force of a law with choices bends or jumps (which costs
/// order), are counted in [`Report::rough`](crate::Report::rough). What is held at rest by forces that cancel is known as well as these are,
/// and no better.
///
/// **As it is computed.** The unknowns are the pushes Lᵢ = −(h²/m) bᵢ S(Qᵢ, Vᵢ, t + cᵢ h), with the slope S = ∇Φ − F. They are lengths,
/// and positions and velocities follow from them as [`Staged`](crate::extend::Staged) says. The work of a step is Σ m Ṽᵢ·Lᵢ/h with the
/// velocities Ṽᵢ = v + Σⱼ λᵢⱼ Lⱼ/h at which the force works. Here λ = μ, and Ṽᵢ is Vᵢ; in [`LineIntegral`] it is Vᵢ projected on the
/// polynomials below degree S.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3]));
/// let long = quartic.clone().scheme(Gauss::order16()).dt(1.0).run_until(1000.0)?;
/// assert!(long.drift(Invariant::Energy).unwrap().max_relative() < 1e-8);
/// let short = quartic.scheme(Gauss::order16()).dt(0.25).run_until(1000.0)?;
/// assert!(short.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Requires
/// A law that can be asked for eight positions at once: every law that a macro writes, and a law by hand that is implemented for
/// every scalar.
/// # Errors
/// Where halving does not help a run ends with [`Error::NotConverged`](crate::Error::NotConverged), which has the sweeps made and the last
/// change of a push in units of rounding, or, where the law is not finite on the way, with
/// [`Error::LawInStep`](crate::Error::LawInStep).
/// # Reference
/// J. C. Butcher, Math. Comp. 18 (1964) 50–64. M. Antoñana, J. Makazaga and A. Murua, arXiv:2511.03655 (2025), and Numer. Algor. 76
/// (2017) 861–880: coefficients that are symplectic in floating point, and sweeps to rounding. E. Hairer, C. Lubich and
/// G. Wanner, Geometric Numerical Integration (2nd ed., 2006), II.1.3, VIII.6.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gauss {
    _made_by_order: (),
}

impl Gauss {
    /// Eight stages.
    pub const fn order16() -> Self {
        Gauss { _made_by_order: () }
    }

    /// Symplectic whatever the law.
    const fn kept_by(_: Option<u32>, invariant: Invariant) -> Kept {
        match invariant {
            Invariant::Energy => Kept::Bounded,
            Invariant::WorkEnergy | Invariant::AngularMomentum | Invariant::LinearMomentum => Kept::Exact,
            Invariant::DiscreteEnergy => Kept::No,
        }
    }
}

impl Method for Gauss {
    const NAME: &'static str = "Gauss(16)";
    const ORDER: u32 = 2 * STAGES as u32;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        Gauss::kept_by(None, invariant)
    }
}

impl Stages for Gauss {
    const TABLEAU: &'static Tableau = &GAUSS;
}
