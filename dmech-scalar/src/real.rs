//! The scalar that laws and schemes are generic over.

use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::functions;

/// The outcome of a comparison: `bool` for one number, one bit per lane for several.
pub trait Mask: Copy + Debug {
    /// How often something happens to each of the numbers that are compared.
    type Count: Count;

    /// How many numbers were compared.
    const LANES: usize = 1;

    /// The same in every lane.
    fn of(holds: bool) -> Self;
    /// True if the comparison holds in every lane.
    fn all(self) -> bool;
    /// True if the comparison holds in some lane.
    fn any(self) -> bool;
    /// Lane-wise conjunction.
    fn and(self, other: Self) -> Self;
    /// Lane-wise disjunction.
    fn or(self, other: Self) -> Self;
    /// Lane-wise negation.
    fn not(self) -> Self;
    /// `holds` where the comparison does, `fails` elsewhere.
    fn count(self, holds: Self::Count, fails: Self::Count) -> Self::Count;
}

/// How often something happens: of several numbers side by side, to each its own.
pub trait Count: Copy + Debug + Default + PartialEq + AddAssign {
    /// So often to each.
    fn of(n: u32) -> Self;
    /// How often (for several lanes: to the first).
    fn to_u64(self) -> u64;
}

/// A real number, or several side by side.
///
/// Generated kernels and schemes are generic over this trait. It has no `PartialOrd`: comparisons
/// give a [`Mask`] and choices go through [`Real::select`], so that SIMD lanes fit as well as `f64`,
/// `f32` and [`DoubleDouble`](crate::DoubleDouble) numbers.
///
/// The functions of `f64` and of its lanes are this crate's own: both have the same bits, whatever the C library of the
/// target does, and are within one unit in the last place (ulp) of the exact value for every argument. They are built on `mul_add`, so
/// that last bits may differ between targets with a fused instruction and without ([`FUSED`](crate::FUSED)).
///
/// The cardinal functions `sinc`, `sinhc`, `atanc`, `atanhc` are f(x)/x for f = sin, sinh, atan, atanh, continued to 1 at 0, and each has
/// a *slope* g′(x)/x, which is even and regular too. Divided differences are written with them because they have no 0/0. An
/// implementation keeps them within 4 ulp for every argument, of double-double numbers within 8 [`EPSILON`](Real::EPSILON); only
/// `sinc_slope`, which changes sign wherever tan x = x, is beyond |x| = 4 held to that part of the larger of its two terms.
pub trait Real:
    Copy
    + Debug
    + Display
    + Default
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// What a comparison gives.
    type Mask: Mask;

    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// Distance from 1 to the next larger number; of double-double numbers, which have none, 2⁻¹⁰⁴.
    const EPSILON: Self;

    /// What rounding may leave of a sum whose parts are 1: seven times [`EPSILON`](Self::EPSILON).
    #[inline(always)]
    fn rounding() -> Self {
        Self::from_f64(7.0) * Self::EPSILON
    }

    /// The nearest number of this type.
    fn from_f64(x: f64) -> Self;
    /// What is less than this has an inverse that is infinite or nearly so.
    #[inline(always)]
    fn least() -> Self {
        Self::from_f64(1e-307)
    }
    /// The nearest `f64` (for several lanes: the first).
    fn to_f64(self) -> f64;

    /// self < other.
    fn less(self, other: Self) -> Self::Mask;
    /// self ≤ other.
    fn less_or_equal(self, other: Self) -> Self::Mask;
    /// self = other.
    fn equal(self, other: Self) -> Self::Mask;
    /// Neither infinite nor NaN.
    fn finite(self) -> Self::Mask;
    /// `yes()` where the mask holds, `no()` elsewhere. A single number evaluates one branch only.
    fn select(mask: Self::Mask, yes: impl FnOnce() -> Self, no: impl FnOnce() -> Self) -> Self;
    /// `yes` where the mask holds, `no` elsewhere: [`select`](Real::select) between what is known already.
    #[inline(always)]
    fn either(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self::select(mask, || yes, || no)
    }

    /// Where the mask does not hold, the number of the first lane where it does; a single number stays what it is.
    #[inline(always)]
    fn lent(self, _by: Self::Mask) -> Self {
        self
    }

    /// self·b + c, rounded once where the target has the instruction, twice elsewhere
    /// (never a slow call into a library).
    fn mul_add(self, b: Self, c: Self) -> Self;
    /// self·b, rounded, and what the rounding left out.
    ///
    /// With [`quotient`](Real::quotient) for sums that grow by h v and L/h in each of many steps: where h is close to a short
    /// fraction, such as 0.2 or 0.15, these round with a preferred sign.
    ///
    /// ```
    /// use dmech_scalar::Real;
    /// let (product, rest) = 0.2_f64.product(3.0);
    /// assert_eq!((product, rest), (0.6000000000000001, -2f64.powi(-54)));
    /// ```
    #[inline(always)]
    fn product(self, b: Self) -> (Self, Self) {
        functions::two_product(self, b)
    }
    /// self/b and what that leaves out, rounded in its turn, by 1/b: without a division, for many quotients by one number.
    #[inline(always)]
    fn quotient(self, b: Self, per_b: Self) -> (Self, Self) {
        let quotient = self * per_b;
        let (product, rest) = quotient.product(b);
        (quotient, ((self - product) - rest) * per_b)
    }
    /// 1/self.
    fn recip(self) -> Self;
    /// |self|.
    fn abs(self) -> Self;
    /// ±1, with the sign of self (also of a signed zero).
    fn signum(self) -> Self;
    /// The nearest integer, halves away from 0.
    fn round(self) -> Self;
    /// The largest integer that is not larger.
    fn floor(self) -> Self;
    /// The integer toward 0.
    fn trunc(self) -> Self;
    /// The smaller.
    fn min(self, other: Self) -> Self;
    /// The larger.
    fn max(self, other: Self) -> Self;
    /// The smaller; NaN where this is NaN.
    #[inline(always)]
    fn at_most(self, most: Self) -> Self {
        Self::either(most.less(self), most, self)
    }
    /// The larger; NaN where this is NaN.
    #[inline(always)]
    fn at_least(self, least: Self) -> Self {
        Self::either(self.less(least), least, self)
    }
    /// selfⁿ.
    fn powi(self, n: i32) -> Self;
    /// selfᵖ.
    fn powf(self, p: Self) -> Self;
    /// √self.
    fn sqrt(self) -> Self;
    /// ∛self.
    fn cbrt(self) -> Self;
    /// e^self.
    fn exp(self) -> Self;
    /// 2^self.
    fn exp2(self) -> Self;
    /// e^self − 1.
    fn exp_m1(self) -> Self;
    /// ln self.
    fn ln(self) -> Self;
    /// ln (1 + self).
    fn ln_1p(self) -> Self;
    /// log₂ self.
    fn log2(self) -> Self;
    /// log₁₀ self.
    fn log10(self) -> Self;
    /// sin self.
    fn sin(self) -> Self;
    /// cos self.
    fn cos(self) -> Self;
    /// tan self.
    fn tan(self) -> Self;
    /// arcsin self.
    fn asin(self) -> Self;
    /// arccos self.
    fn acos(self) -> Self;
    /// arctan self.
    fn atan(self) -> Self;
    /// The angle of the point (x, self).
    fn atan2(self, x: Self) -> Self;
    /// sinh self.
    fn sinh(self) -> Self;
    /// cosh self.
    fn cosh(self) -> Self;
    /// tanh self.
    fn tanh(self) -> Self;
    /// arsinh self.
    fn asinh(self) -> Self;
    /// arcosh self.
    fn acosh(self) -> Self;
    /// artanh self.
    fn atanh(self) -> Self;

    /// sin(x)/x.
    fn sinc(self) -> Self;
    /// sinc′(x)/x = (cos x − sinc x)/x²; −1/3 at 0.
    fn sinc_slope(self) -> Self;
    /// sinh(x)/x.
    fn sinhc(self) -> Self;
    /// sinhc′(x)/x = (cosh x − sinhc x)/x²; 1/3 at 0.
    fn sinhc_slope(self) -> Self;
    /// arctan(x)/x.
    fn atanc(self) -> Self;
    /// atanc′(x)/x = (1/(1 + x²) − atanc x)/x²; −2/3 at 0.
    fn atanc_slope(self) -> Self;
    /// artanh(x)/x for |x| < 1; ∞ at ±1, NaN beyond.
    fn atanhc(self) -> Self;
    /// atanhc′(x)/x = (1/(1 − x²) − atanhc x)/x²; 2/3 at 0.
    fn atanhc_slope(self) -> Self;
}
