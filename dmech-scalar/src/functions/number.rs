//! What the functions of this module are written with: one number or several, and their bits.

use crate::primitive::FUSED;
use crate::{Mask, Real};

/// The bits of numbers: 64 of each. Sums wrap.
pub(crate) trait Bits: Copy {
    fn splat(bits: u64) -> Self;
    fn plus(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    fn and(self, other: Self) -> Self;
    fn or(self, other: Self) -> Self;
    fn xor(self, other: Self) -> Self;
    fn shl(self, by: u32) -> Self;
    fn shr(self, by: u32) -> Self;
}

/// A [`Real`] whose lanes are `f64`.
pub(crate) trait Number: Real {
    type Bits: Bits;
    /// One number: a branch costs less than computing both sides.
    const SINGLE: bool;

    fn bits(self) -> Self::Bits;
    fn from_bits(bits: Self::Bits) -> Self;
    /// f of each lane.
    fn each(self, f: impl Fn(f64) -> f64) -> Self;
    /// The row of a table with the number in the lowest seven bits.
    fn look_up(table: &[[f64; 3]; 128], row: Self::Bits) -> [Self; 3];
}

impl Bits for u64 {
    #[inline(always)]
    fn splat(bits: u64) -> u64 {
        bits
    }
    #[inline(always)]
    fn plus(self, other: u64) -> u64 {
        self.wrapping_add(other)
    }
    #[inline(always)]
    fn minus(self, other: u64) -> u64 {
        self.wrapping_sub(other)
    }
    #[inline(always)]
    fn and(self, other: u64) -> u64 {
        self & other
    }
    #[inline(always)]
    fn or(self, other: u64) -> u64 {
        self | other
    }
    #[inline(always)]
    fn xor(self, other: u64) -> u64 {
        self ^ other
    }
    #[inline(always)]
    fn shl(self, by: u32) -> u64 {
        self << by
    }
    #[inline(always)]
    fn shr(self, by: u32) -> u64 {
        self >> by
    }
}

impl Number for f64 {
    type Bits = u64;
    const SINGLE: bool = true;

    #[inline(always)]
    fn bits(self) -> u64 {
        self.to_bits()
    }
    #[inline(always)]
    fn from_bits(bits: u64) -> f64 {
        f64::from_bits(bits)
    }
    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> f64 {
        f(self)
    }
    #[inline(always)]
    fn look_up(table: &[[f64; 3]; 128], row: u64) -> [f64; 3] {
        table[row as usize % 128]
    }
}

/// x in every lane.
#[inline(always)]
pub(crate) fn c<R: Number>(x: f64) -> R {
    R::from_f64(x)
}

/// These bits in every lane.
#[inline(always)]
pub(crate) fn b<R: Number>(bits: u64) -> R::Bits {
    R::Bits::splat(bits)
}

/// `near()` where the mask holds, `far()` elsewhere; lanes evaluate `far` only if one of them needs it.
#[inline(always)]
pub(crate) fn by_range<R: Number>(mask: R::Mask, near: impl FnOnce() -> R, far: impl FnOnce() -> R) -> R {
    if mask.all() { near() } else { R::select(mask, near, far) }
}

pub(crate) const SIGN: u64 = 1 << 63;
pub(crate) const ONE: u64 = 0x3ff0_0000_0000_0000;

/// The sign bit, and nothing else.
#[inline(always)]
pub(crate) fn sign<R: Number>(x: R) -> R::Bits {
    x.bits().and(b::<R>(SIGN))
}

/// x with its sign turned where the sign bit of `sign` is set; the other bits of `sign` are 0.
#[inline(always)]
pub(crate) fn turned<R: Number>(x: R, sign: R::Bits) -> R {
    R::from_bits(x.bits().xor(sign))
}

/// Whether the lowest bit is set.
#[inline(always)]
pub(crate) fn odd<R: Number>(n: R::Bits) -> R::Mask {
    R::from_bits(n.shl(63).or(b::<R>(ONE))).less(R::ZERO)
}

/// 1.5 · 2⁵²: added to |x| < 2⁵¹ it leaves the nearest integer in the lowest bits.
pub(crate) const ROUNDER: f64 = 6755399441055744.0;

/// The integer next to x·factor, and the same in the lowest bits of the second.
#[inline(always)]
pub(crate) fn nearest_integer<R: Number>(x: R, factor: f64) -> (R, R::Bits) {
    let shifted = x.mul_add(c(factor), c(ROUNDER));
    (shifted - c(ROUNDER), shifted.bits())
}

/// 2ⁿ for the integer n in the lowest bits, −1022 ≤ n ≤ 1023.
#[inline(always)]
pub(crate) fn power_of_two<R: Number>(n: R::Bits) -> R {
    R::from_bits(n.shl(52).plus(b::<R>(ONE)))
}

/// a + b as (sum, rounding error), for |a| ≥ |b| or a = 0 (T. J. Dekker, Numer. Math. 18 (1971) 224–242).
#[inline(always)]
pub(crate) fn fast_two_sum<R: Real>(a: R, b: R) -> (R, R) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// a · b as (product, rounding error): by a fused multiply-add where the target has it, elsewhere by splitting both factors in
/// halves (Dekker, as above; the splitting is Veltkamp's). The two agree, because the error is a number.
#[inline(always)]
pub(crate) fn two_product<R: Real>(a: R, b: R) -> (R, R) {
    let product = a * b;
    if FUSED {
        return (product, a.mul_add(b, -product));
    }
    (product, split_error(product, [a, b], 134217729.0)) // 2²⁷ + 1
}

/// a b less the rounded product, by splitting both factors in halves with 2ᵏ + 1 (or 2ᵏ, where that has too many digits).
#[inline(always)]
pub(crate) fn split_error<R: Real>(product: R, [a, b]: [R; 2], splitter: f64) -> R {
    // No `map`: it is not inlined where a crate is compiled in parts, and takes half of the time of an energy-exact step there.
    let ((a1, a2), (b1, b2)) = (halves(a, splitter), halves(b, splitter));
    ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2
}

/// The upper half of the digits of a number, and the lower.
#[inline(always)]
fn halves<R: Real>(x: R, splitter: f64) -> (R, R) {
    let wide = x * R::from_f64(splitter);
    let upper = wide - (wide - x);
    (upper, x - upper)
}

/// (p + p′)/(q + q′), where the primed are below the last places: the rounded quotient and what its remainder adds.
#[inline(always)]
pub(crate) fn quotient_terms<R: Number>((p, p_rest): (R, R), (q, q_rest): (R, R)) -> (R, R) {
    let inverse = q.recip();
    let quotient = p * inverse;
    let remainder = if FUSED {
        quotient.mul_add(-q, p)
    } else {
        let (product, error) = two_product(quotient, q);
        (p - product) - error
    };
    let remainder = remainder + (p_rest - quotient * q_rest);
    (quotient, remainder * inverse)
}

/// The same, rounded.
#[inline(always)]
pub(crate) fn quotient<R: Number>(p: (R, R), q: (R, R)) -> R {
    let (quotient, rest) = quotient_terms(p, q);
    quotient + rest
}

/// √(s + s′), where s′ is below the last place of s > 0, as a sum of two.
#[inline(always)]
pub(crate) fn root_terms<R: Number>((s, s_rest): (R, R)) -> (R, R) {
    let root = s.sqrt();
    let (square, error) = two_product(root, root);
    (root, (((s - square) - error) + s_rest) / (root + root))
}
