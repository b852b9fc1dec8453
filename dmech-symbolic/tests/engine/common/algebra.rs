//! The kinds of number that expressions are evaluated over: binary64, 77 digits, dual numbers.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use dmech_scalar::Real;
use dmech_symbolic::expression::{Binary, Unary};
use num_dual::DualNum;

/// A binary number with 77 digits.
pub(crate) type Big = FBig<HalfEven, 2>;

const BITS: usize = 256;

/// The very value of x.
pub(crate) fn big(x: f64) -> Big {
    Big::try_from(x).unwrap_or_else(|_| panic!("{x} is not a finite number")).with_precision(BITS).value()
}

pub(crate) fn narrow(x: &Big) -> f64 {
    x.to_f64().value()
}

/// What an expression can be evaluated over.
pub(crate) trait Algebra: Clone {
    fn number(x: f64) -> Self;
    fn plus(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    fn over(&self, other: &Self) -> Self;
    fn less(&self, other: &Self) -> bool;
    fn unary(&self, f: Unary) -> Self;
    fn powf(&self, p: &Self) -> Self;
    fn atan2(&self, x: &Self) -> Self;

    fn power(&self, n: i32) -> Self {
        let magnitude = (0..n.unsigned_abs()).fold(Self::number(1.0), |product, _| product.times(self));
        if n < 0 { Self::number(1.0).over(&magnitude) } else { magnitude }
    }

    fn binary(&self, f: Binary, other: &Self) -> Self {
        match f {
            Binary::Powf => self.powf(other),
            Binary::Atan2 => self.atan2(other),
            Binary::Min | Binary::AtMost => {
                if other.less(self) {
                    other.clone()
                } else {
                    self.clone()
                }
            }
            Binary::Max | Binary::AtLeast => {
                if self.less(other) {
                    other.clone()
                } else {
                    self.clone()
                }
            }
        }
    }

    /// g(x)/x and its like by the series in x² near 0, by the closed form elsewhere.
    fn cardinal(&self, f: Unary) -> Self {
        use Unary::*;
        let (near, terms) = if matches!(f, Sinc | Sinhc | SincSlope | SinhcSlope) { (1.0, 40) } else { (0.25, 70) };
        let near = Self::number(near);
        if self.less(&near) && Self::number(0.0).minus(&near).less(self) {
            let y = self.times(self);
            return (0..terms).rev().fold(Self::number(0.0), |sum, n| sum.times(&y).plus(&coefficient(f, n)));
        }
        let one = Self::number(1.0);
        let y = self.times(self);
        let slope = |limit: Self, base: Self| limit.minus(&base.over(self)).over(&y);
        match f {
            Sinc => self.unary(Sin).over(self),
            Sinhc => self.unary(Sinh).over(self),
            Atanc => self.unary(Atan).over(self),
            Atanhc => self.unary(Atanh).over(self),
            SincSlope => slope(self.unary(Cos), self.unary(Sin)),
            SinhcSlope => slope(self.unary(Cosh), self.unary(Sinh)),
            AtancSlope => slope(one.over(&one.plus(&y)), self.unary(Atan)),
            AtanhcSlope => slope(one.over(&one.minus(&y)), self.unary(Atanh)),
            _ => unreachable!("{f:?} is no cardinal function"),
        }
    }
}

/// The coefficient of x²ⁿ, a quotient of integers.
fn coefficient<T: Algebra>(f: Unary, n: i32) -> T {
    use Unary::*;
    let number = |n: i32| T::number(f64::from(n));
    let inverse_factorial = |n: i32| (2..=n).fold(number(1), |product, k| product.over(&number(k)));
    let sign = |k: i32| number(if k % 2 == 0 { 1 } else { -1 });
    let slope = |c: T| c.times(&number(2 * n + 2));
    match f {
        Sinc => sign(n).times(&inverse_factorial(2 * n + 1)),
        Sinhc => inverse_factorial(2 * n + 1),
        Atanc => sign(n).over(&number(2 * n + 1)),
        Atanhc => number(1).over(&number(2 * n + 1)),
        SincSlope => slope(sign(n + 1).times(&inverse_factorial(2 * n + 3))),
        SinhcSlope => slope(inverse_factorial(2 * n + 3)),
        AtancSlope => slope(sign(n + 1).over(&number(2 * n + 3))),
        AtanhcSlope => slope(number(1).over(&number(2 * n + 3))),
        _ => unreachable!("{f:?} is no cardinal function"),
    }
}

impl Algebra for f64 {
    fn number(x: f64) -> Self {
        x
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn over(&self, other: &Self) -> Self {
        self / other
    }
    fn less(&self, other: &Self) -> bool {
        self < other
    }
    fn unary(&self, f: Unary) -> Self {
        f.apply(*self)
    }
    fn powf(&self, p: &Self) -> Self {
        Real::powf(*self, *p)
    }
    fn atan2(&self, x: &Self) -> Self {
        Real::atan2(*self, *x)
    }
}

/// An exact result (sinh 0) comes without a precision, and cannot be computed with.
fn settled(x: Big) -> Big {
    if x.precision() == 0 { x.with_precision(BITS).value() } else { x }
}

impl Algebra for Big {
    fn number(x: f64) -> Self {
        big(x)
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn over(&self, other: &Self) -> Self {
        self / other
    }
    fn less(&self, other: &Self) -> bool {
        self < other
    }
    fn unary(&self, f: Unary) -> Self {
        use Unary::*;
        let zero = big(0.0);
        settled(match f {
            Sqrt => self.sqrt(),
            Cbrt => self.nth_root(3),
            Exp => self.exp(),
            Exp2 => (self * big(2.0).ln()).exp(),
            ExpM1 => self.exp_m1(),
            Ln => self.ln(),
            Ln1p => self.ln_1p(),
            Log2 => self.ln() / big(2.0).ln(),
            Log10 => self.ln() / big(10.0).ln(),
            Sin => self.sin(),
            Cos => self.cos(),
            Tan => self.tan(),
            Asin => self.asin(),
            Acos => self.acos(),
            Atan => self.atan(),
            Sinh => self.sinh(),
            Cosh => self.cosh(),
            Tanh => self.tanh(),
            Asinh => self.asinh(),
            Acosh => self.acosh(),
            Atanh => self.atanh(),
            Abs => {
                if *self < zero {
                    -self
                } else {
                    self.clone()
                }
            }
            Signum => {
                if *self < zero {
                    big(-1.0)
                } else {
                    big(1.0)
                }
            }
            Round | Floor | Trunc => big(f.apply(narrow(self))),
            _ => self.cardinal(f),
        })
    }
    fn powf(&self, p: &Self) -> Self {
        if *self == big(0.0) { big(0.0) } else { (p * self.ln()).exp() }
    }
    fn atan2(&self, x: &Self) -> Self {
        Big::atan2(self, x)
    }
}

/// A dual number of any kind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dual<T>(pub(crate) T);

impl<T: DualNum<Primitive = f64> + Copy> Algebra for Dual<T> {
    fn number(x: f64) -> Self {
        Self(T::from(x))
    }
    fn plus(&self, other: &Self) -> Self {
        Self(self.0 + other.0)
    }
    fn minus(&self, other: &Self) -> Self {
        Self(self.0 - other.0)
    }
    fn times(&self, other: &Self) -> Self {
        Self(self.0 * other.0)
    }
    fn over(&self, other: &Self) -> Self {
        Self(self.0 / other.0)
    }
    fn less(&self, other: &Self) -> bool {
        self.0.re() < other.0.re()
    }
    fn unary(&self, f: Unary) -> Self {
        use Unary::*;
        let x = self.0;
        Self(match f {
            Sqrt => x.sqrt(),
            Cbrt => x.cbrt(),
            Exp => x.exp(),
            Exp2 => x.exp2(),
            ExpM1 => x.exp_m1(),
            Ln => x.ln(),
            Ln1p => x.ln_1p(),
            Log2 => x.log2(),
            Log10 => x.log10(),
            Sin => x.sin(),
            Cos => x.cos(),
            Tan => x.tan(),
            Asin => x.asin(),
            Acos => x.acos(),
            Atan => x.atan(),
            Sinh => x.sinh(),
            Cosh => x.cosh(),
            // num-dual's slope 1 − tanh² has no digits left where tanh is nearly 1.
            Tanh if x.re().abs() > 0.5 => T::from(1.0) - T::from(2.0) / ((x + x).exp() + T::from(1.0)),
            Tanh => x.tanh(),
            Asinh => x.asinh(),
            Acosh => x.acosh(),
            Atanh => x.atanh(),
            Abs => {
                if x.re() < 0.0 {
                    -x
                } else {
                    x
                }
            }
            Signum | Round | Floor | Trunc => T::from(f.apply(x.re())),
            _ => return self.cardinal(f),
        })
    }
    fn powf(&self, p: &Self) -> Self {
        Self(self.0.powd(p.0))
    }
    fn atan2(&self, x: &Self) -> Self {
        Self(self.0.atan2(x.0))
    }
}
