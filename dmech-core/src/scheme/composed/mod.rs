//! Compositions: schemes of order 4, 6 and 8 from symmetric schemes of order 2.

mod halves;
mod predictor;
mod stages;
mod steps;

pub mod coefficients;

#[cfg(test)]
mod tests;

pub use coefficients::Coefficients;
pub(super) use predictor::SlopeAt;
pub use stages::StagesMemory;
pub use steps::{OneStep, Steps, StepsMemory, StepsRoom};

use dmech_scalar::Real;

use self::coefficients::{SofroniouSpaletta6, SofroniouSpaletta8, Suzuki4S7};
use super::splitting::{First, digits, ends};
use super::{Boris, DiscreteGradient, Implicit, Leapfrog, Method};
use crate::invariant::{Invariant, Kept};
use crate::name::Name;
use crate::system::System;

/// A symmetric scheme composed of steps of different lengths, forward and backward, to order 4, 6 or 8.
///
/// ```text
/// Ψ_h = Φ_{γ_N h} ∘ … ∘ Φ_{γ₂ h} ∘ Φ_{γ₁ h},   γ_k = γ_{N+1−k},   Σγ = 1,   Σγ³ = 0, …
/// ```
///
/// | of | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|---|
/// | [`Leapfrog`] | 4, 6, 8 | bounded, O(h^order) | exact | yes | yes | N forces |
/// | [`Boris`] | 4, 6, 8 | exact in a magnetic field, else bounded, O(h^order) | exact (central laws) | no | yes | N forces |
/// | [`DiscreteGradient`](struct@DiscreteGradient) | 4, 6, 8 | exact | exact (central laws) | no | yes | N nonlinear solves |
/// | [`Implicit`](struct@Implicit) | 4, 6, 8 | bounded, O(h^order), where the motion is reversible | bounded | no | yes | N nonlinear solves |
///
/// Every stage is a step of the scheme itself, from t + c_{k−1} h to t + c_k h with c_k = γ₁ + … + γ_k, so a composition of
/// energy-exact steps is energy-exact. Between stages of leap-frog the two half kicks are one, and the last of a step is
/// one with the first of the next: the force is taken once per stage. Between stages of Boris's scheme the half drifts are.
///
/// [`order4`](Composed::order4), [`order6`](Composed::order6) and [`order8`](Composed::order8) take the sets of stages
/// that were measured to be the best; [`new`](Composed::new) takes any of [`coefficients`].
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3])).dt(0.05);
/// let run = quartic.clone().scheme(Composed::order6(DiscreteGradient)).run_until(100.0)?;
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
///
/// let other = quartic.scheme(Composed::new(Leapfrog, coefficients::SuzukiUmeno8)).run_until(100.0)?;
/// assert!((other.last().q[0] - run.last().q[0]).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// With scalars of more digits, [`DoubleDouble`](crate::DoubleDouble), the order of these shows down to 10⁻²⁵ and less; that
/// of other sets, whose lengths have the digits of `f64`, down to 10⁻¹⁶.
///
/// # Requires
/// What the scheme requires, also between the ends of the step: the stages leave it by up to 0.6 h in the sets of order
/// 6 and 8 and go backward in time, where a damping force excites.
/// # Reference
/// E. Hairer, C. Lubich and G. Wanner, Geometric Numerical Integration (2nd ed., 2006), II.4 and V.3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Composed<S, C, const STAGES: usize> {
    pub(crate) scheme: S,
    coefficients: C,
}

/// A symmetric scheme that goes from one state to the next and can go backward: it can be composed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be composed to a higher order",
    label = "not a symmetric one-step scheme",
    note = "`Kanatani` is a two-step scheme: its step needs the position before, at the same distance in time",
    note = "`Explicit` is not symmetric; compose `Leapfrog`, `Boris`, `Implicit` or `DiscreteGradient`",
    note = "a scheme of your own stands in `Steps`: `Composed::order4(Steps(scheme))`"
)]
pub trait Composable: Method {}

impl Composable for Leapfrog {}
impl Composable for Boris {}
impl Composable for Implicit {}
impl Composable for DiscreteGradient {}

impl<S: Composable, C: Coefficients<STAGES>, const STAGES: usize> Composed<S, C, STAGES> {
    /// A composition with stages from [`coefficients`], or of your own: a palindrome, or it does not compile.
    ///
    /// ```compile_fail
    /// use dmech_core::prelude::*;
    /// #[derive(Clone, Copy, Debug)]
    /// struct Uneven;
    /// impl coefficients::Coefficients<3> for Uneven {
    ///     const NAME: &'static str = "Uneven";
    ///     const ORDER: u32 = 2;
    ///     const GAMMA: [f64; 3] = [0.2, 0.3, 0.5];
    /// }
    /// let scheme = Composed::new(Leapfrog, Uneven);
    /// ```
    pub const fn new(scheme: S, coefficients: C) -> Self {
        let () = Self::PALINDROME;
        Composed { scheme, coefficients }
    }

    /// Half kicks are joined, and steps are reversible, only where the stages are.
    const PALINDROME: () = {
        let mut k = 0;
        while k < STAGES {
            assert!(C::GAMMA[k] == C::GAMMA[STAGES - 1 - k], "the stages of a composition must be a palindrome");
            k += 1;
        }
    };

    const TITLE: Name = Name::of(&["Composed(", S::NAME, ", ", C::NAME, ")"]);

    /// c₁, …, c_N: where in the step the stages end.
    pub(crate) const ENDS: [f64; STAGES] = ends(First::Kick, C::GAMMA);

    /// Where in the step a stage begins.
    pub(crate) const fn begins(k: usize) -> f64 {
        if k == 0 { 0.0 } else { Self::ENDS[k - 1] }
    }
}

/// γ_k, to all the digits that the scalar has and that are known.
#[inline(always)]
fn gamma<R: Real, C: Coefficients<N>, const N: usize>(k: usize) -> R {
    digits(C::GAMMA[k], C::LOW[k])
}

/// The steps of the stages, γ_k h long each.
fn strides<Y: System, C: Coefficients<N>, const N: usize>(
    system: &Y,
    stride: &Y::Stride,
    share: f64,
) -> [Y::Stride; N] {
    core::array::from_fn(|k| system.stage(stride, gamma::<_, C, N>(k), share))
}

impl<S: Composable> Composed<S, Suzuki4S7, 7> {
    /// Order 4, in the seven stages of [`Suzuki4S7`].
    pub const fn order4(scheme: S) -> Self {
        Composed::new(scheme, Suzuki4S7)
    }
}

impl<S: Composable> Composed<S, SofroniouSpaletta6, 13> {
    /// Order 6, in the thirteen stages of [`SofroniouSpaletta6`].
    pub const fn order6(scheme: S) -> Self {
        Composed::new(scheme, SofroniouSpaletta6)
    }
}

impl<S: Composable> Composed<S, SofroniouSpaletta8, 21> {
    /// Order 8, in the twenty-one stages of [`SofroniouSpaletta8`].
    pub const fn order8(scheme: S) -> Self {
        Composed::new(scheme, SofroniouSpaletta8)
    }
}

impl<S: Composable, C: Coefficients<STAGES>, const STAGES: usize> Method for Composed<S, C, STAGES> {
    const NAME: &'static str = Self::TITLE.text();
    const ORDER: u32 = C::ORDER;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        S::keeps(invariant)
    }
}
