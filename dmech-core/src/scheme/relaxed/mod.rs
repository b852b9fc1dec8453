//! Explicit steps whose end is put back onto the energy surface.

mod step;
mod surface;

pub use step::RelaxedMemory;
pub use surface::RelaxedRoom;

use super::coefficients::{Blanes8S19, BlanesMoan6S14, NystromCoefficients};
use super::splitting::{First, Splitting};
use super::{Method, Nystrom};
use crate::invariant::{Invariant, Kept};
use crate::name::Name;
use crate::system::System;

/// Explicit steps of order 6 or 8 whose end is put back onto the energy surface: the energy exact, and no equation to solve.
///
/// ```text
/// (q*, v*) = a step of Nystrom from (q, v),   (q′, v′) = (q* + λ h² M⁻¹∇Φ(q*), v* + λ v*),   H(q′, v′) = H(q₀, v₀)
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 6, 8 | exact | not kept: the error, O(h^order), grows with time | no | no | 14 or 19 forces, and one or two with their potentials |
///
/// The correction is along the gradient of the energy where a position weighs as much as the velocity that leads there in a step:
/// the shortest way. λ is found by Newton's method, and what it leaves is rounding after one or two corrections, as
/// the step errs by O(h^{order+1}). The energy aimed at is that of the start, so that no rounding adds up.
///
/// Positions are as those of [`Nystrom`], not better, and momenta worse: a correction multiplies the velocity by 1 + λ, so that what
/// a free scene has of linear momentum drifts too, unless it is zero. Bodies that are pinned stay, and no test body
/// is corrected, as no energy counts it.
///
/// Of a law that does not keep its energy, or a scene with such a law or a driven body, nothing is corrected: the steps are those
/// of `Nystrom`, and [`Run::kept`](crate::Run::kept) says what they keep.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3])).dt(0.2);
/// let run = quartic.scheme(Relaxed::order6()).run_until(100.0)?;
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Work is Φ(q) − Φ(q′), that of the force along any way between both; where nothing is corrected it is that of the kicks.
///
/// # Requires
/// Forces that do not depend on the velocity, as [`Nystrom`].
/// # Errors
/// Where a step is so long that a correction would change the velocity by more than a part in sixteen, or leads nowhere, a run ends with
/// [`Error::NotConverged`](crate::Error::NotConverged), which has the corrections made and the last |λ|, or, where the law is not finite on
/// the way, with [`Error::LawInStep`](crate::Error::LawInStep).
/// # Reference
/// E. Hairer, C. Lubich and G. Wanner, Geometric Numerical Integration (2nd ed., 2006), IV.4: projection; D. I. Ketcheson, SIAM J. Numer.
/// Anal. 57 (2019) 2850–2870: relaxation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Relaxed<C, const KICKS: usize> {
    coefficients: C,
}

impl Relaxed<BlanesMoan6S14, 14> {
    /// Order 6, in the fourteen kicks of [`BlanesMoan6S14`].
    pub const fn order6() -> Self {
        Relaxed { coefficients: BlanesMoan6S14 }
    }
}

impl Relaxed<Blanes8S19, 19> {
    /// Order 8, in the nineteen kicks of [`Blanes8S19`].
    pub const fn order8() -> Self {
        Relaxed { coefficients: Blanes8S19 }
    }
}

impl<C: NystromCoefficients<N>, const N: usize> Relaxed<C, N> {
    const TITLE: Name = Name::of(&["Relaxed(", C::NAME, ")"]);
}

/// Whether there is an energy surface to return to.
#[inline(always)]
fn corrects<Y: System>(system: &Y) -> bool {
    system.conserves(Invariant::Energy)
}

impl<C: NystromCoefficients<N>, const N: usize> Method for Relaxed<C, N> {
    const NAME: &'static str = Self::TITLE.text();
    const ORDER: u32 = C::ORDER;
    const SYMMETRIC: bool = false;

    fn keeps(invariant: Invariant) -> Kept {
        match invariant {
            Invariant::Energy | Invariant::WorkEnergy => Kept::Exact,
            Invariant::DiscreteEnergy | Invariant::LinearMomentum | Invariant::AngularMomentum => Kept::No,
        }
    }
}

impl<C: NystromCoefficients<N>, const N: usize> Splitting<N> for Relaxed<C, N> {
    const FIRST: First = <Nystrom<C, N> as Splitting<N>>::FIRST;
    const DRIFTS: [f64; N] = <Nystrom<C, N> as Splitting<N>>::DRIFTS;
    const KICKS: [f64; N] = <Nystrom<C, N> as Splitting<N>>::KICKS;
}
