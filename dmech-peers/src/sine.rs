//! The sine of eight numbers side by side, for the pendulum by hand.

use wide::{f64x8, u64x8};

/// π in two parts: its f64, and what is left.
const PI: [f64; 2] = [core::f64::consts::PI, 1.2246467991473532e-16];

/// 1.5 · 2⁵²: added to a small number, it leaves the nearest integer in the lowest bits.
const ROUND: f64 = 6755399441055744.0;

/// (−1)ⁿ/(2n + 1)! for n = 1 … 10.
const TERMS: [f64; 10] = {
    let (mut terms, mut term, mut n) = ([0.0; 10], 1.0, 0);
    while n < 10 {
        term = -term / ((2 * n + 2) * (2 * n + 3)) as f64;
        terms[n] = term;
        n += 1;
    }
    terms
};

/// sin x for |x| < 7: x − k π between −π/2 and π/2, its series to degree 21, and the sign of (−1)ᵏ. The products k π with k to 2
/// are exact, with or without a fused instruction.
#[inline(always)]
pub(crate) fn sine(x: f64x8) -> f64x8 {
    let c = |n: usize| f64x8::splat(TERMS[n]);
    let shifted = x.mul_add(f64x8::splat(core::f64::consts::FRAC_1_PI), f64x8::splat(ROUND));
    let k = shifted - f64x8::splat(ROUND);
    let r = k.mul_neg_add(f64x8::splat(PI[0]), x);
    let r = k.mul_neg_add(f64x8::splat(PI[1]), r);
    let z = r * r;
    let z2 = z * z;
    let z4 = z2 * z2;
    // Pairs, pairs of pairs, …: a chain of 5 in place of 10.
    let pair = |n: usize| z.mul_add(c(n + 1), c(n));
    let low = z2.mul_add(pair(2), pair(0));
    let high = z2.mul_add(pair(6), pair(4));
    let series = z4.mul_add(z4.mul_add(pair(8), high), low);
    let odd: f64x8 = bytemuck::cast(bytemuck::cast::<f64x8, u64x8>(shifted) << 63_u64);
    (r * z).mul_add(series, r) ^ odd
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Within 2·10⁻¹⁶ of the library's over a revolution either way.
    #[test]
    fn it_is_the_sine() {
        for n in -690..690 {
            let x: [f64; 8] = core::array::from_fn(|lane| 0.01 * f64::from(n) + 0.001 * lane as f64);
            let found = sine(f64x8::new(x)).to_array();
            for (x, found) in x.into_iter().zip(found) {
                assert!((found - x.sin()).abs() < 2.3e-16, "sin {x}: {found} and {}", x.sin());
            }
        }
    }
}
