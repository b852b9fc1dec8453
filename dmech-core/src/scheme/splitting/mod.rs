//! Drifts and kicks in turn: what compositions of leap-frog, the Nyström splittings and the force-gradient schemes have in
//! common.
//!
//! A step is the composition of motions with constant velocity, q += a_k h v, and of kicks at a fixed position,
//! v += b_k h a(q), to which force-gradient schemes add e_k h³ a′(q) a(q), or in which Boris's scheme has the force at the mean
//! velocity. It reads the same from either end, so that it is
//! symmetric. One that begins with a kick ends with it, and that kick is joined to the first of the next step.

mod step;

#[cfg(test)]
mod conditions;

pub use step::SplittingMemory;
pub(super) use step::{drift, kick};

use dmech_scalar::Real;

use super::Method;

/// What a step begins and ends with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum First {
    /// A kick; the last is made together with the first of the next step.
    Kick,
    /// A drift.
    Drift,
}

/// A scheme of N drifts and N kicks in a step.
pub(crate) trait Splitting<const N: usize>: Method {
    const FIRST: First;
    /// Kicks take the force at the mean of the velocities before and after, which may be linear in it.
    const BY_MEAN: bool = false;
    const DRIFTS: [f64; N];
    const KICKS: [f64; N];
    const GRADIENTS: [f64; N] = [0.0; N];
    /// What rounding to `f64` leaves out of drifts and kicks, where it is known.
    const DRIFTS_LOW: [f64; N] = [0.0; N];
    const KICKS_LOW: [f64; N] = [0.0; N];

    /// The kick after drift k.
    const JOINED: [f64; N] = joined(Self::FIRST, Self::KICKS);
    const JOINED_LOW: [f64; N] = joined(Self::FIRST, Self::KICKS_LOW);
    /// And its gradient term.
    const JOINED_GRADIENTS: [f64; N] = joined(Self::FIRST, Self::GRADIENTS);
    /// a₁ + … + a_k: where in the step the kick after drift k is made.
    const ENDS: [f64; N] = ends(Self::FIRST, Self::DRIFTS);
}

/// high + low, where the scalar has more digits than `f64`; elsewhere high, at no cost.
#[inline(always)]
pub(crate) fn digits<R: Real>(high: f64, low: f64) -> R {
    if R::EPSILON.to_f64() < f64::EPSILON { R::from_f64(high) + R::from_f64(low) } else { R::from_f64(high) }
}

/// The last kick of a step that begins with one is the first, twice.
const fn joined<const N: usize>(first: First, kicks: [f64; N]) -> [f64; N] {
    if matches!(first, First::Drift) {
        return kicks;
    }
    let mut joined = [2.0 * kicks[0]; N];
    let mut k = 0;
    while k + 1 < N {
        joined[k] = kicks[k + 1];
        k += 1;
    }
    joined
}

/// Where in the step its drifts end.
pub(crate) const fn ends<const N: usize>(first: First, drifts: [f64; N]) -> [f64; N] {
    let mut ends = [1.0; N];
    let whole = matches!(first, First::Kick);
    let (mut sum, mut k) = (0.0, 0);
    while k + (whole as usize) < N {
        sum += drifts[k];
        ends[k] = sum;
        k += 1;
    }
    ends
}

/// All N of x₁, …, x_H that are a palindrome of their own: x_k = x_{N+1−k}.
pub(crate) const fn palindrome<const HALF: usize, const N: usize>(half: [f64; HALF]) -> [f64; N] {
    let mut all = [0.0; N];
    let mut k = 0;
    while k < HALF {
        all[k] = half[k];
        all[N - 1 - k] = half[k];
        k += 1;
    }
    all
}

/// The first N of x₁, …, x_H, … that are a palindrome of N + 1: x_k = x_{N+2−k}.
pub(crate) const fn opening<const HALF: usize, const N: usize>(half: [f64; HALF]) -> [f64; N] {
    let mut all = [0.0; N];
    let mut k = 0;
    while k < HALF {
        all[k] = half[k];
        if k > 0 {
            all[N - k] = half[k];
        }
        k += 1;
    }
    all
}
