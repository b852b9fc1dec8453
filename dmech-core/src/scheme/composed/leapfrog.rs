//! Stages of leap-frog: drifts of γ_k h, and between them the half kicks of both neighbours in one.

use super::{Coefficients, Composed};
use crate::scheme::Leapfrog;
use crate::scheme::splitting::{First, Splitting};

impl<C: Coefficients<N>, const N: usize> Splitting<N> for Composed<Leapfrog, C, N> {
    const FIRST: First = First::Kick;
    const DRIFTS: [f64; N] = C::GAMMA;
    /// γ₁/2, and (γ_{k−1} + γ_k)/2: the half kick at the end of a stage and that at the start of the next.
    const KICKS: [f64; N] = {
        let mut kicks = [0.5 * C::GAMMA[0]; N];
        let mut k = 1;
        while k < N {
            kicks[k] = 0.5 * (C::GAMMA[k - 1] + C::GAMMA[k]);
            k += 1;
        }
        kicks
    };
    const GRADIENTS: [f64; N] = [0.0; N];
    const DRIFTS_LOW: [f64; N] = C::LOW;
    const KICKS_LOW: [f64; N] = {
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
    };
}
