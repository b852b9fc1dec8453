//! Eight numbers side by side: one for each stage of a step.

use core::array::from_fn;
use core::fmt::Debug;

use dmech_scalar::{DoubleDouble, Lanes, Mask, Real};

use super::{Columns, Row, STAGES};

/// A scalar of which eight can stand side by side: `f64` in the lanes of a register, others one by one.
pub trait Staging: Real {
    /// Eight of them.
    type Eight: Eight<Self>;
}

/// Eight numbers of the type R.
pub trait Eight<R>: Copy + Debug + Send + Sync {
    /// The same number eight times.
    fn splat(x: R) -> Self;
    /// Coefficients.
    fn row(row: &Row) -> Self;
    /// Number i, of a row that is known.
    fn to_array(self) -> [R; STAGES];
    /// Component by component.
    fn plus(self, other: Self) -> Self;
    /// Component by component.
    fn minus(self, other: Self) -> Self;
    /// Component by component.
    fn times(self, other: Self) -> Self;
    /// self·b + c.
    fn fused(self, b: Self, c: Self) -> Self;
    /// max(self, |other|) of numbers.
    fn or_larger(self, other: Self) -> Self;
    /// The largest of numbers.
    fn largest(self) -> R;
    /// self ≤ other everywhere.
    fn at_most(self, other: Self) -> bool;
    /// Somewhere self² ≥ least and self < before: this has come nearer, and is not near enough.
    fn comes_nearer(self, least: Self, before: Self) -> bool;
    /// The sum.
    fn sum(self) -> R;
}

const HALF: usize = STAGES / 2;

/// Σⱼ columnⱼ xⱼ, on top of `start`.
#[inline(always)]
pub(crate) fn weighed<R: Real, E: Eight<R>>(columns: &Columns, x: E, start: E) -> E {
    let x = x.to_array();
    // Two sums that do not wait for each other.
    let mut early = start;
    let mut late = E::row(&columns[HALF]).times(E::splat(x[HALF]));
    for j in 0..HALF {
        early = E::row(&columns[j]).fused(E::splat(x[j]), early);
    }
    for j in HALF + 1..STAGES {
        late = E::row(&columns[j]).fused(E::splat(x[j]), late);
    }
    early.plus(late)
}

impl Staging for f64 {
    type Eight = Lanes;
}

impl Eight<f64> for Lanes {
    #[inline(always)]
    fn splat(x: f64) -> Self {
        Lanes::splat(x)
    }
    #[inline(always)]
    fn row(row: &Row) -> Self {
        Lanes::from_array(row.hi)
    }
    #[inline(always)]
    fn to_array(self) -> [f64; STAGES] {
        Lanes::to_array(self)
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self + other
    }
    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        self - other
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        self * other
    }
    #[inline(always)]
    fn fused(self, b: Self, c: Self) -> Self {
        self.mul_add(b, c)
    }
    #[inline(always)]
    fn or_larger(self, other: Self) -> Self {
        self.larger_number(other.abs())
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> bool {
        self.less_or_equal(other).all()
    }
    #[inline(always)]
    fn comes_nearer(self, least: Self, before: Self) -> bool {
        least.less_or_equal(self * self).and(self.less(before)).any()
    }
    #[inline(always)]
    fn largest(self) -> f64 {
        largest(Lanes::to_array(self))
    }
    #[inline(always)]
    fn sum(self) -> f64 {
        Lanes::sum(self)
    }
}

/// The largest, halves folded onto each other.
#[inline(always)]
fn largest<R: Real>(x: [R; STAGES]) -> R {
    let more = |a: R, b: R| R::either(b.less_or_equal(a), a, b);
    let four: [R; 4] = from_fn(|i| more(x[i], x[i + 4]));
    more(more(four[0], four[2]), more(four[1], four[3]))
}

macro_rules! one_by_one {
    ($($real:ty)*) => {$(
        impl Staging for $real {
            type Eight = [$real; STAGES];
        }

        impl Eight<$real> for [$real; STAGES] {
            #[inline]
            fn splat(x: $real) -> Self {
                [x; STAGES]
            }
            #[inline]
            fn row(row: &Row) -> Self {
                from_fn(|i| <$real>::from_f64(row.hi[i]) + <$real>::from_f64(row.lo[i]))
            }
            #[inline]
            fn to_array(self) -> Self {
                self
            }
            #[inline]
            fn plus(self, other: Self) -> Self {
                from_fn(|i| self[i] + other[i])
            }
            #[inline]
            fn minus(self, other: Self) -> Self {
                from_fn(|i| self[i] - other[i])
            }
            #[inline]
            fn times(self, other: Self) -> Self {
                from_fn(|i| self[i] * other[i])
            }
            #[inline]
            fn fused(self, b: Self, c: Self) -> Self {
                from_fn(|i| Real::mul_add(self[i], b[i], c[i]))
            }
            #[inline]
            fn or_larger(self, other: Self) -> Self {
                from_fn(|i| {
                    let other = Real::abs(other[i]);
                    <$real>::either(other.less_or_equal(self[i]), self[i], other)
                })
            }
            #[inline]
            fn at_most(self, other: Self) -> bool {
                (0..STAGES).all(|i| self[i].less_or_equal(other[i]).all())
            }
            #[inline]
            fn comes_nearer(self, least: Self, before: Self) -> bool {
                (0..STAGES).any(|i| least[i].less_or_equal(self[i] * self[i]).and(self[i].less(before[i])).any())
            }
            #[inline]
            fn largest(self) -> $real {
                largest(self)
            }
            #[inline]
            fn sum(self) -> $real {
                let four: [$real; 4] = from_fn(|i| self[i] + self[i + 4]);
                (four[0] + four[2]) + (four[1] + four[3])
            }
        }
    )*};
}

one_by_one! { f32 DoubleDouble Lanes }
