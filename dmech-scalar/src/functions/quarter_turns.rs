//! Arguments of any size less their multiple of π/2, after M. H. Payne and R. N. Hanek (ACM SIGNUM Newsletter 18 (1983)
//! 19–24): only those digits of 2/π are multiplied that leave neither whole turns nor less than needed.

/// 2/π = 0.a2f9…₁₆, after one word of zeros: x may be as small as 1/2.
const TWO_OVER_PI: [u64; 21] = [
    0,
    0xa2f9_836e_4e44_1529,
    0xfc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041,
    0xfe51_63ab_debb_c561,
    0xb724_6e3a_424d_d2e0,
    0x0649_2eea_09d1_921c,
    0xfe1d_eb1c_b129_a73e,
    0xe882_35f5_2ebb_4484,
    0xe99c_7026_b45f_7e41,
    0x3991_d639_8353_39f4,
    0x9c84_5f8b_bdf9_283b,
    0x1ff8_97ff_de05_980f,
    0xef2f_118b_5a0a_6d1f,
    0x6d36_7ecf_27cb_09b7,
    0x4f46_3f66_9e5f_ea2d,
    0x7527_bac7_ebe5_f17b,
    0x3d07_39f7_8a52_92ea,
    0x6bfb_5fb1_1f8d_5d08,
    0x5603_3046_fc7b_6bab,
    0xf0cf_bc20_9af4_361d,
];

/// π/2, rounded, and what the rounding leaves.
const QUARTER: [f64; 2] = [core::f64::consts::FRAC_PI_2, 6.123233995736766e-17];

/// 2⁻¹²⁸.
const LAST_BIT: f64 = f64::from_bits((1023 - 128) << 52);

/// (n, r₁, r₂) with x = n π/2 + r₁ + r₂ up to whole turns and |r₁ + r₂| ≤ π/4, for x ≥ 1/2; NaN for ∞ and NaN.
///
/// x = m 2ᵉ with an integer m < 2⁵³. Of 2/π the 192 bits from the weight 2¹⁻ᵉ on are multiplied with m, modulo 2¹⁹²: two
/// bits of the product are the quarter turns modulo 4, and at least 137 more are right. No `f64` comes closer to a multiple
/// of π/2 than 2⁻⁶¹ (J.-M. Muller et al., Handbook of Floating-Point Arithmetic, 2018, section 10.2), so 66 bits of the 128 that
/// are kept remain.
pub(super) fn quarter_turns(x: f64) -> (u64, f64, f64) {
    if !x.is_finite() {
        return (0, f64::NAN, f64::NAN);
    }
    let biased = x.to_bits() >> 52;
    let m = x.to_bits() & ((1 << 52) - 1) | 1 << 52;
    // e = biased − 1075; the window starts at bit e − 1 of 2/π, whose first bit is number 1 and stands behind 64 zeros.
    let start = biased as usize + 64 - 2 - 1075;
    let (word, shift) = (start / 64, start % 64);
    let window = |i: usize| {
        let pair =
            u128::from(TWO_OVER_PI[word + i]) << 64 | u128::from(TWO_OVER_PI.get(word + i + 1).copied().unwrap_or(0));
        (pair << shift >> 64) as u64
    };
    let low = u128::from(m) * u128::from(window(2));
    let middle = (u128::from(m) * u128::from(window(1))).wrapping_add(low >> 64);
    let top = m.wrapping_mul(window(0)).wrapping_add((middle >> 64) as u64);
    // 192 bits: top, middle, low. Two of quarter turns, then the fraction.
    let fraction = u128::from(top) << 66 | u128::from(middle as u64) << 2 | u128::from(low as u64 >> 62);
    let signed = fraction as i128;
    let quarters = (top >> 62).wrapping_add(u64::from(signed < 0));
    // The nearest f64 may be 2¹²⁷ itself, which an i128 cannot hold: unsigned.
    let magnitude = signed.unsigned_abs();
    let nearest = magnitude as f64;
    let left = magnitude.wrapping_sub(nearest as u128) as i128 as f64;
    let (high, low) = (nearest * LAST_BIT, left * LAST_BIT);
    let (r, error) = super::number::two_product(high, QUARTER[0]);
    let rest = error + (high * QUARTER[1] + low * QUARTER[0]);
    if signed < 0 { (quarters, -r, -rest) } else { (quarters, r, rest) }
}
