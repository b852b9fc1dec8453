//! arcsin, arccos, arctan and the angle of a point.
//!
//! # arctan
//! An angle is measured from the nearest multiple of π/4. For the point (b, a) in the first octant, a ≤ b,
//!
//! - t = a/b, or (a − b)/(a + b) from tan π/8 on, with π/4 added,
//! - arctan t = t + t z P(z), z = t², with eleven coefficients, a least-squares fit at Chebyshev points in 60 digits; relative error
//!   1.4e−18.
//!
//! Sums and quotient are taken with what their rounding leaves, and the angle n π/4 ± arctan t is put together from the
//! octant.
//!
//! # arcsin, arccos
//! - |x| ≤ 1/2: arcsin x = x + x z R(z), z = x²,
//! - beyond: arcsin |x| = π/2 − 2 arcsin √w, w = (1 − |x|)/2, which is exact; the root is taken with its remainder,
//!
//! R with thirteen coefficients, fitted likewise; relative error 1.0e−18. arccos x = π/2 − arcsin x, without the difference for x > 1/2.

use super::number::{Number, c, fast_two_sum, quotient_terms, root_terms, sign, turned};
use crate::Mask;
use crate::polynomial::{tenth_of, twelfth_of};

const ATAN: [f64; 11] = [
    -0.33333333333333187,
    0.19999999999951162,
    -0.14285714279986597,
    0.11111110774144752,
    -0.09090897515236795,
    0.07692056255596419,
    -0.06663062308672647,
    0.05847605334984511,
    -0.050381006125094815,
    0.038035620935304756,
    -0.01787709907094219,
];

const ASIN: [f64; 13] = [
    0.1666666666666676,
    0.07499999999971048,
    0.044642857174297765,
    0.030381942724964518,
    0.02237221446897879,
    0.017351621680535938,
    0.01398070256804337,
    0.011399883105498927,
    0.010774824438216462,
    0.0037267448301756185,
    0.021658578249008832,
    -0.020930973186465963,
    0.032586801610281546,
];

/// π/4, rounded, and what the rounding leaves. The last three bits of the first are 0: its multiples up to 4 are exact.
const EIGHTH: [f64; 2] = [core::f64::consts::FRAC_PI_4, 3.061616997868383e-17];
/// π/2, rounded, and what the rounding leaves.
const QUARTER: [f64; 2] = [core::f64::consts::FRAC_PI_2, 6.123233995736766e-17];
/// About tan π/8.
const TURN: f64 = 0.41421356;

/// n π/4 + σ arctan (p/q), n and σ by the signs and sizes: the angle of the point (x, |y|), y ≥ 0, in terms of
/// a = min(|x|, y), b = max(|x|, y).
#[inline(always)]
fn angle<R: Number>(a: R, b: R, steep: R::Mask, left: R::Mask) -> R {
    let beyond = (b * c(TURN)).less(a);
    let (difference, difference_rest) = fast_two_sum(b, -a);
    let (sum, sum_rest) = fast_two_sum(b, a);
    let p = (R::either(beyond, -difference, a), R::either(beyond, -difference_rest, R::ZERO));
    let q = (R::either(beyond, sum, b), R::either(beyond, sum_rest, R::ZERO));
    let (t, rest) = quotient_terms(p, q);
    let z = t * t;
    let small = tenth_of(z, ATAN, t * z) + rest.mul_add(-z, rest);
    // Eighths of the turn below which, or above which, the direction lies.
    let n = R::either(beyond, R::ONE, R::ZERO);
    let n = R::either(steep, c::<R>(2.0) - n, n);
    let n = R::either(left, c::<R>(4.0) - n, n);
    let falling = R::either(steep, -R::ONE, R::ONE);
    let falling = R::either(left, -falling, falling);
    let (t, small) = (t * falling, small * falling);
    let (large, error) = fast_two_sum(n * c(EIGHTH[0]), t);
    large + n.mul_add(c(EIGHTH[1]), error + small)
}

#[inline]
pub(crate) fn atan<R: Number>(x: R) -> R {
    let a = x.abs();
    // Beyond 2⁶⁰ the angle is π/2.
    let a = R::either(c::<R>(1152921504606846976.0).less(a), c(1152921504606846976.0), a);
    if R::SINGLE && a.less_or_equal(c(TURN)).all() {
        let z = a * a;
        return turned(a + tenth_of(z, ATAN, a * z), sign(x));
    }
    let steep = R::ONE.less(a);
    let (low, high) = (R::either(steep, R::ONE, a), R::either(steep, a, R::ONE));
    turned(angle(low, high, steep, R::Mask::of(false)), sign(x))
}

#[inline]
pub(crate) fn atan2<R: Number>(y: R, x: R) -> R {
    let (a, b) = (y.abs(), x.abs());
    let steep = b.less(a);
    let (low, high) = (R::either(steep, b, a), R::either(steep, a, b));
    let left = x.signum().less(R::ZERO);
    // Neither overflow nor what a remainder loses among subnormal numbers.
    let tame = high.less(c(1e290)).and(c::<R>(1e-250).less(low).or(low.equal(R::ZERO).and(c::<R>(1e-250).less(high))));
    let value = if tame.all() { angle(low, high, steep, left) } else { wild(low, high, steep, left, tame) };
    turned(value, sign(y))
}

/// Where a or b is very large or very small, or not a number. The tame among them are left as they are.
#[cold]
#[inline(never)]
fn wild<R: Number>(a: R, b: R, steep: R::Mask, left: R::Mask, tame: R::Mask) -> R {
    let infinite = b.equal(c(f64::INFINITY));
    let a = R::either(infinite, R::either(a.equal(b), R::ONE, a * R::ZERO), a);
    let b = R::either(infinite.or(b.equal(R::ZERO)), R::ONE, b);
    // By 2⁻⁶⁰⁰, or by 2⁶⁰⁰, twice for the smallest numbers: b ends far from both borders.
    let times = |exponent: u64, mask: R::Mask, (a, b): (R, R)| {
        let factor = R::either(mask.and(tame.not()), c(f64::from_bits(exponent << 52)), R::ONE);
        (a * factor, b * factor)
    };
    let (a, b) = times(1023 - 600, c::<R>(1e250).less(b), (a, b));
    let (a, b) = times(1023 + 600, b.less(c(1e-50)), (a, b));
    let (a, b) = times(1023 + 400, b.less(c(1e-50)), (a, b));
    // Where the angle itself may be subnormal, it is the quotient, and nothing may be corrected.
    let flat = a.less(b * c(1e-30)).and(steep.or(left).or(tame).not());
    R::either(flat, a / b, angle(a, b, steep, left))
}

/// arcsin x − x = x z R(z).
#[inline(always)]
fn beyond_x<R: Number>(x: R, z: R) -> R {
    twelfth_of(z, ASIN, x * z)
}

#[inline]
pub(crate) fn asin<R: Number>(x: R) -> R {
    let a = x.abs();
    let inner = a.less_or_equal(c(0.5));
    if R::SINGLE && inner.all() {
        return turned(a + beyond_x(a, a * a), sign(x));
    }
    let Folded { root, rest, series } = Folded::of(a, a, inner);
    let (large, error) = fast_two_sum(c(QUARTER[0]), -(root + root));
    let far = large + c::<R>(-2.0).mul_add(series + rest, error + c(QUARTER[1]));
    turned(R::either(inner, a + series, far), sign(x))
}

/// √w with what its rounding leaves, and the terms of arcsin beyond the first: of x where |x| ≤ 1/2, of √w elsewhere. Lanes that
/// disagree take one polynomial.
struct Folded<R> {
    root: R,
    rest: R,
    series: R,
}

impl<R: Number> Folded<R> {
    #[inline(always)]
    fn of(x: R, a: R, inner: R::Mask) -> Self {
        let w = (R::ONE - a) * c(0.5);
        let (root, rest) = half_root(w);
        let series = beyond_x(R::either(inner, x, root), R::either(inner, x * x, w));
        Self { root, rest, series }
    }
}

/// √w; of 0 it is 0.
#[inline(always)]
fn half_root<R: Number>(w: R) -> (R, R) {
    let (root, rest) = root_terms((w, R::ZERO));
    (root, R::either(w.equal(R::ZERO), R::ZERO, rest))
}

#[inline]
pub(crate) fn acos<R: Number>(x: R) -> R {
    let a = x.abs();
    let inner = a.less_or_equal(c(0.5));
    let from_quarter = |x: R, terms: R| {
        let (large, error) = fast_two_sum(c(QUARTER[0]), -x);
        large + ((error + c(QUARTER[1])) - terms)
    };
    if R::SINGLE && inner.all() {
        return from_quarter(x, beyond_x(x, x * x));
    }
    let Folded { root, rest, series } = Folded::of(x, a, inner);
    let terms = R::either(inner, series, series + rest);
    let difference = from_quarter(R::either(inner, x, root), terms);
    let half = R::either(x.less(R::ZERO), difference, root + terms);
    R::either(inner, difference, half + half)
}
