//! Numbers that know what rounding may have done to them.

use core::fmt;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use dmech_scalar::{Mask, Real};

/// u, half the distance from 1 to the next number.
pub(super) const ROUNDING: f64 = 0.5 * f64::EPSILON;

/// By how many times the error of one way to compute a formula another may differ: it may round as often again, in
/// helpers and loops that a normal form has made short.
pub(super) const MARGIN: f64 = 64.0;

/// A number with its rounding errors to first order: a running error analysis of the formula that computes it.
///
/// Every number that goes in and every operation is off by one rounding, and a sum by those of what is added up, as in
/// another order it may be reached over them. The error is therefore that of every way to compute the same formula which
/// rounds about as often, and the natural size of what may cancel in it: of 1 − cos x it is of the order of u, not of x² u.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tracked {
    value: f64,
    /// In units of u.
    error: f64,
}

impl Tracked {
    /// By how many units of u it may be off.
    pub(super) fn error(self) -> f64 {
        self.error
    }

    /// With a rounding of its own, also where it is too small for a relative one.
    fn rounded(value: f64, inherited: f64) -> Self {
        Tracked { value, error: inherited + value.abs() + f64::MIN_POSITIVE }
    }

    /// |slope| error, 0 where there is no error.
    fn share(slope: f64, error: f64) -> f64 {
        if error == 0.0 { 0.0 } else { (slope * error).abs() }
    }

    /// f(x). What the error of x does is looked up where it is larger by `FAR`, so that the rounding of f does not hide it,
    /// and inside the domain where that is on one side only.
    fn through(self, f: impl Fn(f64) -> f64) -> Self {
        const FAR: f64 = 1024.0;
        let (value, step) = (f(self.value), FAR * ROUNDING * self.error);
        let change = |x: f64| (f(x) - value).abs();
        let moved = change(self.value + step).max(change(self.value - step));
        Tracked::rounded(value, moved / (FAR * ROUNDING))
    }

    /// A step function: exact, unless rounding could lead to the next step.
    fn stepped(self, f: impl Fn(f64) -> f64) -> Self {
        let (value, reach) = (f(self.value), MARGIN * ROUNDING * self.error);
        let sure = f(self.value - reach) == f(self.value + reach);
        Tracked { value, error: if sure { 0.0 } else { 1.0 / ROUNDING } }
    }

    fn through_both(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let (first, second) = (self.through(|x| f(x, other.value)), other.through(|y| f(self.value, y)));
        Tracked { value: first.value, error: first.error + second.error }
    }
}

/// A comparison, and whether rounding could change it.
#[derive(Clone, Copy, Debug)]
pub struct TrackedMask {
    holds: bool,
    sure: bool,
}

impl Mask for TrackedMask {
    type Count = u32;

    fn of(holds: bool) -> Self {
        TrackedMask { holds, sure: true }
    }
    fn all(self) -> bool {
        self.holds
    }
    fn any(self) -> bool {
        self.holds
    }
    fn and(self, other: Self) -> Self {
        // What is surely false decides alone.
        let decided = (self.sure && !self.holds) || (other.sure && !other.holds);
        TrackedMask { holds: self.holds && other.holds, sure: decided || (self.sure && other.sure) }
    }
    fn or(self, other: Self) -> Self {
        self.not().and(other.not()).not()
    }
    fn not(self) -> Self {
        TrackedMask { holds: !self.holds, ..self }
    }
    fn count(self, holds: u32, fails: u32) -> u32 {
        if self.holds { holds } else { fails }
    }
}

impl Tracked {
    fn compared(self, other: Self, holds: bool) -> TrackedMask {
        let apart = (self.value - other.value).abs();
        TrackedMask { holds, sure: apart > MARGIN * ROUNDING * (self.error + other.error) }
    }
}

impl fmt::Display for Tracked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ± {:e}", self.value, ROUNDING * self.error)
    }
}

impl Add for Tracked {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let mut sum = Tracked::rounded(self.value + other.value, self.error + other.error);
        sum.error += self.value.abs() + other.value.abs();
        sum
    }
}

impl Sub for Tracked {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Tracked {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let inherited = Tracked::share(other.value, self.error) + Tracked::share(self.value, other.error);
        Tracked::rounded(self.value * other.value, inherited)
    }
}

impl Div for Tracked {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Tracked { value: self.value / other.value, ..self * other.recip() }
    }
}

impl Neg for Tracked {
    type Output = Self;
    fn neg(self) -> Self {
        Tracked { value: -self.value, ..self }
    }
}

macro_rules! assigned {
    ($($operation:ident::$method:ident = $by:ident;)*) => {$(
        impl $operation for Tracked {
            fn $method(&mut self, other: Self) {
                *self = self.$by(other);
            }
        }
    )*};
}

assigned! { AddAssign::add_assign = add; SubAssign::sub_assign = sub; MulAssign::mul_assign = mul; DivAssign::div_assign = div; }

macro_rules! as_in_f64 {
    ($($name:ident)*) => {$(
        fn $name(self) -> Self {
            self.through(<f64 as Real>::$name)
        }
    )*};
}

impl Real for Tracked {
    type Mask = TrackedMask;

    const ZERO: Self = Tracked { value: 0.0, error: 0.0 };
    const ONE: Self = Tracked { value: 1.0, error: 1.0 };
    const EPSILON: Self = Tracked { value: f64::EPSILON, error: 0.0 };

    fn from_f64(x: f64) -> Self {
        Tracked { value: x, error: x.abs() }
    }
    fn to_f64(self) -> f64 {
        self.value
    }
    fn less(self, other: Self) -> TrackedMask {
        self.compared(other, self.value < other.value)
    }
    fn less_or_equal(self, other: Self) -> TrackedMask {
        self.compared(other, self.value <= other.value)
    }
    fn equal(self, other: Self) -> TrackedMask {
        self.compared(other, self.value == other.value)
    }
    fn finite(self) -> TrackedMask {
        TrackedMask { holds: self.value.is_finite(), sure: true }
    }
    /// Where rounding could change the choice, the other branch may be meant as well.
    fn select(mask: TrackedMask, yes: impl FnOnce() -> Self, no: impl FnOnce() -> Self) -> Self {
        if mask.sure {
            return if mask.holds { yes() } else { no() };
        }
        let (yes, no) = (yes(), no());
        let error = yes.error.max(no.error) + (yes.value - no.value).abs() / ROUNDING;
        // A branch that is not finite is as far away as can be.
        let error = if error.is_nan() { f64::INFINITY } else { error };
        Tracked { value: if mask.holds { yes.value } else { no.value }, error }
    }

    fn mul_add(self, b: Self, c: Self) -> Self {
        self * b + c
    }
    fn recip(self) -> Self {
        let value = 1.0 / self.value;
        Tracked::rounded(value, Tracked::share(value * value, self.error))
    }
    fn abs(self) -> Self {
        Tracked { value: self.value.abs(), ..self }
    }
    fn signum(self) -> Self {
        let zero = self.less(Self::ZERO);
        let value = self.value.signum();
        Tracked { value, error: if zero.sure { 0.0 } else { 2.0 / ROUNDING } }
    }
    fn round(self) -> Self {
        self.stepped(f64::round)
    }
    fn floor(self) -> Self {
        self.stepped(f64::floor)
    }
    fn trunc(self) -> Self {
        self.stepped(f64::trunc)
    }
    fn min(self, other: Self) -> Self {
        Tracked { value: self.value.min(other.value), error: self.error.max(other.error) }
    }
    fn max(self, other: Self) -> Self {
        Tracked { value: self.value.max(other.value), error: self.error.max(other.error) }
    }
    fn powi(self, n: i32) -> Self {
        // Of so many products.
        let power = self.through(|x| x.powi(n));
        Tracked::rounded(power.value, power.error + f64::from(n.unsigned_abs()) * power.value.abs())
    }
    fn powf(self, p: Self) -> Self {
        self.through_both(p, f64::powf)
    }
    fn atan2(self, x: Self) -> Self {
        self.through_both(x, f64::atan2)
    }
    as_in_f64! {
        sqrt cbrt exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh
        sinc sinc_slope sinhc sinhc_slope atanc atanc_slope atanhc atanhc_slope
    }
}
