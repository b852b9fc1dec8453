//! [`Real`] for double-double numbers.

use super::{DoubleDouble, cardinal, exponential, hyperbolic, power, trigonometric};
use crate::{Real, functions};

/// A method that is a function of this folder.
macro_rules! from_here {
    ($($module:ident::$name:ident;)*) => {$(
        #[inline]
        fn $name(self) -> Self {
            $module::$name(self)
        }
    )*};
}

impl Real for DoubleDouble {
    type Mask = bool;

    const ZERO: Self = DoubleDouble::pair(0.0, 0.0);
    const ONE: Self = DoubleDouble::pair(1.0, 0.0);
    /// 2⁻¹⁰⁴, twice the largest rounding of a sum beside 1; lo may hold smaller parts.
    const EPSILON: Self = DoubleDouble::pair(4.0 * (0.5 * f64::EPSILON) * (0.5 * f64::EPSILON), 0.0);

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        x.into()
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.hi
    }
    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn less_or_equal(self, other: Self) -> bool {
        self <= other
    }
    #[inline(always)]
    fn equal(self, other: Self) -> bool {
        self == other
    }
    #[inline(always)]
    fn finite(self) -> bool {
        self.hi.is_finite()
    }
    #[inline(always)]
    fn select(mask: bool, yes: impl FnOnce() -> Self, no: impl FnOnce() -> Self) -> Self {
        if mask { yes() } else { no() }
    }
    /// Rounded twice: the product has 31 digits itself.
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        self * b + c
    }
    /// To the rounding of the products of its halves, 53 digits each.
    #[inline(always)]
    fn product(self, b: Self) -> (Self, Self) {
        let product = self * b;
        (product, functions::split_error(product, [self, b], 9007199254740992.0)) // 2⁵³
    }
    #[inline(always)]
    fn recip(self) -> Self {
        Self::ONE / self
    }
    #[inline(always)]
    fn signum(self) -> Self {
        self.hi.signum().into()
    }
    /// Halves are exact, and so is |self| + 1/2 next to one.
    #[inline]
    fn round(self) -> Self {
        let up = (self.abs() + Self::from(0.5)).floor();
        if self.hi < 0.0 { -up } else { up }
    }
    #[inline]
    fn floor(self) -> Self {
        let whole = self.hi.floor();
        if whole == self.hi { Self::new(whole, self.lo.floor()) } else { whole.into() }
    }
    #[inline]
    fn trunc(self) -> Self {
        if self.hi < 0.0 { -(-self).floor() } else { self.floor() }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other || other.hi.is_nan() { self } else { other }
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other || other.hi.is_nan() { self } else { other }
    }
    #[inline]
    fn powi(self, n: i32) -> Self {
        power::powi(self, n)
    }
    #[inline]
    fn powf(self, p: Self) -> Self {
        power::powf(self, p)
    }
    #[inline]
    fn sin(self) -> Self {
        trigonometric::sin_cos(self).0
    }
    #[inline]
    fn cos(self) -> Self {
        trigonometric::sin_cos(self).1
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        trigonometric::atan2(self, x)
    }
    from_here! {
        power::sqrt; power::cbrt;
        exponential::exp; exponential::exp2; exponential::exp_m1;
        exponential::ln; exponential::ln_1p; exponential::log2; exponential::log10;
        trigonometric::tan; trigonometric::asin; trigonometric::acos; trigonometric::atan;
        hyperbolic::abs; hyperbolic::sinh; hyperbolic::cosh; hyperbolic::tanh;
        hyperbolic::asinh; hyperbolic::acosh; hyperbolic::atanh;
        cardinal::sinc; cardinal::sinc_slope; cardinal::sinhc; cardinal::sinhc_slope;
        cardinal::atanc; cardinal::atanc_slope; cardinal::atanhc; cardinal::atanhc_slope;
    }
}
