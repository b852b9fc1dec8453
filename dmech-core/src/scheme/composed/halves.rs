//! Stages that begin and end with half of something: of leap-frog a kick, of Boris's scheme a drift. The halves of two
//! neighbours are one.

use super::{Coefficients, Composed};
use crate::scheme::splitting::{First, Splitting};
use crate::scheme::{Boris, Leapfrog};

/// γ₁/2, and (γ_{k−1} + γ_k)/2: the half at the end of a stage and that at the start of the next.
const fn halves<C: Coefficients<N>, const N: usize>() -> [f64; N] {
    let mut halves = [0.5 * C::GAMMA[0]; N];
    let mut k = 1;
    while k < N {
        halves[k] = 0.5 * (C::GAMMA[k - 1] + C::GAMMA[k]);
        k += 1;
    }
    halves
}

/// What rounding to `f64` leaves out of them.
const fn halves_low<C: Coefficients<N>, const N: usize>() -> [f64; N] {
    let mut low = [0.5 * C::LOW[0]; N];
    let mut k = 1;
    while k < N {
        // The rounding of γ_{k−1} + γ_k, which is exact in two parts (see `two_sum`).
        let (a, b) = (C::GAMMA[k - 1], C::GAMMA[k]);
        let part = (a + b) - a;
        let rounding = (a - ((a + b) - part)) + (b - part);
        low[k] = 0.5 * (rounding + (C::LOW[k - 1] + C::LOW[k]));
        k += 1;
    }
    low
}

/// Drifts of γ_k h, and between them half kicks.
impl<C: Coefficients<N>, const N: usize> Splitting<N> for Composed<Leapfrog, C, N> {
    const FIRST: First = First::Kick;
    const DRIFTS: [f64; N] = C::GAMMA;
    const KICKS: [f64; N] = halves::<C, N>();
    const DRIFTS_LOW: [f64; N] = C::LOW;
    const KICKS_LOW: [f64; N] = halves_low::<C, N>();
}

/// Kicks of γ_k h, and between them half drifts.
impl<C: Coefficients<N>, const N: usize> Splitting<N> for Composed<Boris, C, N> {
    const FIRST: First = First::Drift;
    const BY_MEAN: bool = true;
    const DRIFTS: [f64; N] = halves::<C, N>();
    const KICKS: [f64; N] = C::GAMMA;
    const DRIFTS_LOW: [f64; N] = halves_low::<C, N>();
    const KICKS_LOW: [f64; N] = C::LOW;
}
