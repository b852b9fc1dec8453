//! sin, cos and tan, to an accuracy of one ulp for every argument.
//!
//! # Reduction
//! |x| = n π/2 + r with the nearest n, after W. J. Cody and W. Waite (Software Manual for the Elementary Functions,
//! 1980): π/2 = A₁ + A₂ + A₃, where A₁ and A₂ have 36 bits. For n < 2¹⁷ the products n A₁ and n A₂ are exact, and so is the
//! difference |x| − n A₁; the rounding error of the next one is kept. r = r₁ + r₂ is known to 2⁻¹⁰⁰, absolutely. That
//! is enough unless |r| < 2⁻⁴⁰; these arguments and those beyond 2·10⁵ go to [`quarter_turns`](super::quarter_turns).
//! Where |x| < π/4 for all that are asked for, x is r: of the two polynomials sin and cos take one, and eight take a third of the time.
//!
//! # Polynomials
//! With z = r², |r| ≤ π/4: sin r = r + r z S(z), cos r = 1 − z/2 + z² C(z), each with six coefficients, a least-squares fit at Chebyshev
//! points in 60 digits, rounded from the lowest on while the rest is fitted again. Relative error 3.8e−18 and 7.4e−20. The sums at the
//! end are ordered as in fdlibm's `k_sin.c` and `k_cos.c`: what rounding 1 − z/2 leaves is added to the smaller terms.

use super::number::{Bits, Number, SIGN, b, c, fast_two_sum, nearest_integer, odd, quotient, sign, turned};
use super::quarter_turns::quarter_turns;
use crate::Mask;
use crate::polynomial::quintic_of;

const A1: f64 = 1.5707963267923333;
const A2: f64 = 2.5633441515839558e-12;
const A3: f64 = 1.0562999066987428e-23;
const TWO_OVER_PI: f64 = core::f64::consts::FRAC_2_PI;

/// n stays below 2¹⁷ here.
const FAR: f64 = 2e5;
/// 2⁻⁴⁰.
const CLOSE: f64 = 9.094947017729282e-13;

const SIN: [f64; 6] = [
    -0.1666666666666663,
    0.008333333333321945,
    -0.00019841269829484602,
    2.755731359108751e-06,
    -2.5050743528454354e-08,
    1.5896000046150026e-10,
];
const COS: [f64; 6] = [
    0.041666666666666595,
    -0.0013888888888873433,
    2.4801587289088995e-05,
    -2.7557314246727625e-07,
    2.087570973642429e-09,
    -1.1358979878585515e-11,
];

/// |x| = n π/2 + r₁ + r₂.
#[derive(Clone, Copy)]
struct Angle<R: Number> {
    quarters: R::Bits,
    r: R,
    rest: R,
}

/// The angle, and where it may be used.
#[inline(always)]
fn reduced<R: Number>(x: R) -> (Angle<R>, R::Mask) {
    let a = x.abs();
    let (n, quarters) = nearest_integer(a, TWO_OVER_PI);
    let first = n.mul_add(c(-A1), a);
    let second = n * c(A2);
    let r = first - second;
    let rest = n.mul_add(c(-A3), (first - r) - second);
    // For n = 0, r is |x|.
    let sound = a.less(c(FAR)).and(a.min(c(CLOSE)).less_or_equal(r.abs()));
    (Angle { quarters, r, rest }, sound)
}

impl Angle<f64> {
    /// Of any x.
    fn of(x: f64) -> Self {
        let (angle, sound) = reduced(x);
        if sound {
            return angle;
        }
        let (quarters, r, rest) = quarter_turns(x.abs());
        Self { quarters, r, rest }
    }
}

impl<R: Number> Angle<R> {
    /// sin r.
    #[inline(always)]
    fn inner_sin(self) -> R {
        let (large, small) = self.sin_terms();
        large + small
    }

    #[inline(always)]
    fn sin_terms(self) -> (R, R) {
        let Self { r, rest, .. } = self;
        let z = r * r;
        (r, quintic_of(z, SIN, r * z) + rest.mul_add(z * c(-0.5), rest))
    }

    /// cos r.
    #[inline(always)]
    fn inner_cos(self) -> R {
        let (large, small) = self.cos_terms();
        large + small
    }

    #[inline(always)]
    fn cos_terms(self) -> (R, R) {
        let Self { r, rest, .. } = self;
        let z = r * r;
        let half = z * c(0.5);
        let large = R::ONE - half;
        let left = (R::ONE - large) - half;
        (large, quintic_of(z, COS, z * z) + rest.mul_add(-r, left))
    }

    /// sin |x|.
    #[inline(always)]
    fn sin(self) -> R {
        let value = R::either(odd::<R>(self.quarters), self.inner_cos(), self.inner_sin());
        turned(value, self.quarters.shl(62).and(b::<R>(SIGN)))
    }

    /// cos |x|.
    #[inline(always)]
    fn cos(self) -> R {
        let value = R::either(odd::<R>(self.quarters), self.inner_sin(), self.inner_cos());
        turned(value, self.quarters.plus(b::<R>(1)).shl(62).and(b::<R>(SIGN)))
    }

    /// tan |x|: a quotient of two unrounded sums, corrected by its remainder.
    #[inline(always)]
    fn tan(self) -> R {
        let odd = odd::<R>(self.quarters);
        let (sin, sin_rest) = self.sin_terms();
        let (cos, cos_rest) = self.cos_terms();
        let (sin, sin_rest) = fast_two_sum(sin, sin_rest);
        let (cos, cos_rest) = fast_two_sum(cos, cos_rest);
        let (p, p_rest) = (R::either(odd, cos, sin), R::either(odd, cos_rest, sin_rest));
        let (q, q_rest) = (R::either(odd, sin, cos), R::either(odd, sin_rest, cos_rest));
        turned(quotient((p, p_rest), (q, q_rest)), self.quarters.shl(63))
    }
}

/// Nothing is to be taken away from any of these: n = 0 and r₂ = 0.
#[inline(always)]
fn small<R: Number>(x: R) -> bool {
    x.abs().less(c(core::f64::consts::FRAC_PI_4)).all()
}

#[inline]
pub(crate) fn sin<R: Number>(x: R) -> R {
    let sign = sign(x);
    if small(x) {
        let (r, z) = (x.abs(), x * x);
        return turned(r + quintic_of(z, SIN, r * z), sign);
    }
    let (angle, sound) = reduced(x);
    if sound.all() { turned(angle.sin(), sign) } else { any_sin(x) }
}

#[inline]
pub(crate) fn cos<R: Number>(x: R) -> R {
    if small(x) {
        return Angle { quarters: b::<R>(0), r: x.abs(), rest: R::ZERO }.inner_cos();
    }
    let (angle, sound) = reduced(x);
    if sound.all() { angle.cos() } else { any_cos(x) }
}

#[inline]
pub(crate) fn tan<R: Number>(x: R) -> R {
    let (angle, sound) = reduced(x);
    if sound.all() { turned(angle.tan(), sign(x)) } else { any_tan(x) }
}

/// Where an argument is far or close to a multiple of π/2: one by one.
#[cold]
#[inline(never)]
fn any_sin<R: Number>(x: R) -> R {
    x.each(|x| turned(Angle::of(x).sin(), sign(x)))
}

#[cold]
#[inline(never)]
fn any_cos<R: Number>(x: R) -> R {
    x.each(|x| Angle::of(x).cos())
}

#[cold]
#[inline(never)]
fn any_tan<R: Number>(x: R) -> R {
    x.each(|x| turned(Angle::of(x).tan(), sign(x)))
}
