//! Force-gradient schemes.

pub(crate) mod coefficients;

use self::coefficients::{ForceGradientCoefficients, Omelyan4S5, Omelyan6S5, Smooth8S14};
use super::splitting::{First, Splitting};
use super::{Leapfrog, Method};
use crate::invariant::{Invariant, Kept};
use crate::name::Name;

/// Drifts and kicks in turn, with kicks that know how the force changes: order 4 in as few as two forces.
///
/// ```text
/// q += a_k h v,   v += b_k h a(q) + e_k h³ a′(q) a(q),   a′a = M⁻¹ H M⁻¹ ∇Φ = ∇(|∇Φ|²)/2m²
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 4, 6, 8 | bounded, O(h^order) | exact | yes | yes | N forces, some of them with a′a |
///
/// A kick with a′a is the motion in the potential Φ − (e/b) (h²/m) |∇Φ|²/2 alone, hence symplectic. The term is made of the
/// law's own expression and shares its roots and divisions ([`Field::gradient_kick`](crate::Field::gradient_kick)):
/// for Kepler's problem it costs two operations more than a kick. Where splittings above order 2 must step backward, sets of order 4
/// with it go forward only and leave the step at no moment.
///
/// [`order4`](ForceGradient::order4), [`order6`](ForceGradient::order6) and [`order8`](ForceGradient::order8) take the sets that
/// were measured to be the best; [`new`](ForceGradient::new) takes any of [`coefficients`](crate::coefficients), or one of
/// your own.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3])).dt(0.2);
/// let run = quartic.clone().scheme(ForceGradient::order4()).run_until(100.0)?;
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-5);
///
/// let chin = quartic.scheme(ForceGradient::new(coefficients::Chin4A)).run_until(100.0)?;
/// assert!(chin.drift(Invariant::Energy).unwrap().max_relative() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// The coefficients have the digits of `f64`: with [`DoubleDouble`](crate::DoubleDouble) numbers the order shows down to
/// errors of 10⁻¹⁶.
///
/// # Requires
/// Forces that do not depend on the velocity. They may depend on the time: a′ is taken at the time of the kick. Where the
/// force is not the gradient of a potential, a′a stands for Σⱼ aⱼ ∂a/∂qⱼ; order and reversibility stay, and nothing is
/// symplectic in such a field in the first place.
/// # Reference
/// S. A. Chin, Phys. Lett. A 226 (1997) 344–348; I. P. Omelyan, I. M. Mryglod and R. Folk, Phys. Rev. E 66 (2002) 026701 and
/// Comput. Phys. Commun. 151 (2003) 272–314.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ForceGradient<C, const KICKS: usize> {
    coefficients: C,
}

impl<C: ForceGradientCoefficients<KICKS>, const KICKS: usize> ForceGradient<C, KICKS> {
    /// A scheme with lengths from [`coefficients`](crate::coefficients), or of your own.
    pub const fn new(coefficients: C) -> Self {
        ForceGradient { coefficients }
    }

    const TITLE: Name = Name::of(&["ForceGradient(", C::NAME, ")"]);
}

impl ForceGradient<Omelyan4S5, 5> {
    /// Order 4, in the five kicks of [`Omelyan4S5`].
    pub const fn order4() -> Self {
        ForceGradient::new(Omelyan4S5)
    }
}

impl ForceGradient<Omelyan6S5, 5> {
    /// Order 6, in the five kicks of [`Omelyan6S5`].
    pub const fn order6() -> Self {
        ForceGradient::new(Omelyan6S5)
    }
}

impl ForceGradient<Smooth8S14, 14> {
    /// Order 8, in the fourteen kicks of [`Smooth8S14`].
    pub const fn order8() -> Self {
        ForceGradient::new(Smooth8S14)
    }
}

impl<C: ForceGradientCoefficients<N>, const N: usize> Method for ForceGradient<C, N> {
    const NAME: &'static str = Self::TITLE.text();
    const ORDER: u32 = C::ORDER;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        Leapfrog::keeps(invariant)
    }
}

impl<C: ForceGradientCoefficients<N>, const N: usize> Splitting<N> for ForceGradient<C, N> {
    const FIRST: First = C::FIRST;
    const DRIFTS: [f64; N] = C::DRIFTS;
    const KICKS: [f64; N] = C::KICKS;
    const GRADIENTS: [f64; N] = C::GRADIENTS;
}
