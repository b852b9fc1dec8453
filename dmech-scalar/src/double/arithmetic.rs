//! Sums, products and quotients.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::DoubleDouble;
use crate::functions::two_product;
use crate::{FUSED, two_sum};

/// a + b rounded, and the error of that: for |a| ≥ |b|.
#[inline(always)]
pub(super) const fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// a b rounded, and the error of that, when a program is compiled, as [`two_product`] has it on targets without a fused
/// instruction.
#[inline(always)]
pub(super) const fn split_product(a: f64, b: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134217729.0; // 2²⁷ + 1
    let (wide_a, wide_b) = (SPLITTER * a, SPLITTER * b);
    let (a1, b1) = (wide_a - (wide_a - a), wide_b - (wide_b - b));
    let (a2, b2) = (a - a1, b - b1);
    let product = a * b;
    (product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2)
}

impl DoubleDouble {
    /// hi + lo with |hi| ≥ |lo|; what the operation gives in `f64` where that is not finite, or where an intermediate
    /// result was not.
    #[inline(always)]
    pub(super) fn settled(hi: f64, lo: f64, plain: f64) -> Self {
        let (hi, lo) = fast_two_sum(hi, lo);
        if hi.is_finite() { DoubleDouble { hi, lo } } else { DoubleDouble { hi: plain, lo: 0.0 } }
    }

    /// The product with one `f64` (algorithm 9 of Joldes, Muller and Popescu, their bound 2u² with u = 2⁻⁵³).
    #[inline(always)]
    pub(super) fn times(self, b: f64) -> Self {
        let (product, error) = two_product(self.hi, b);
        let rest = if FUSED { self.lo.mul_add(b, error) } else { self.lo * b + error };
        Self::settled(product, rest, product)
    }

    /// The sum with one `f64` (algorithm 4, 2u²).
    #[inline(always)]
    pub(super) fn plus(self, b: f64) -> Self {
        let (sum, error) = two_sum(self.hi, b);
        Self::settled(sum, self.lo + error, sum)
    }

    /// 2ᵏ times the number, exact unless it overflows or underflows.
    pub(super) fn scaled(self, k: i32) -> Self {
        let power = |k: i32| f64::from_bits(((1023 + k.clamp(-1022, 1023)) as u64) << 52);
        // In three parts: from the smallest number to the largest it takes more than one factor.
        let (a, b) = (k / 3, (k - k / 3) / 2);
        let [a, b, c] = [a, b, k - a - b].map(power);
        let hi = self.hi * a * b * c;
        DoubleDouble { hi, lo: if hi.is_finite() { self.lo * a * b * c } else { 0.0 } }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        DoubleDouble { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// Algorithm 6: 3u².
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        let (sum, error) = two_sum(self.hi, b.hi);
        let (low, low_error) = two_sum(self.lo, b.lo);
        let (hi, rest) = fast_two_sum(sum, error + low);
        Self::settled(hi, low_error + rest, sum)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    /// Algorithm 12, 5u²; without fused instructions algorithm 10, 7u².
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        let (product, error) = two_product(self.hi, b.hi);
        let cross = if FUSED {
            self.lo.mul_add(b.hi, self.hi.mul_add(b.lo, self.lo * b.lo))
        } else {
            self.hi * b.lo + self.lo * b.hi
        };
        Self::settled(product, error + cross, product)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// Algorithm 17: 15u².
    #[inline(always)]
    fn div(self, b: Self) -> Self {
        let quotient = self.hi / b.hi;
        let covered = b.times(quotient);
        let rest = (self.hi - covered.hi) + (self.lo - covered.lo);
        Self::settled(quotient, rest / b.hi, quotient)
    }
}

macro_rules! assign {
    ($($trait:ident::$method:ident: $op:tt;)*) => {$(
        impl $trait for DoubleDouble {
            #[inline(always)]
            fn $method(&mut self, b: Self) {
                *self = *self $op b;
            }
        }
    )*};
}

assign! {
    AddAssign::add_assign: +;
    SubAssign::sub_assign: -;
    MulAssign::mul_assign: *;
    DivAssign::div_assign: /;
}
