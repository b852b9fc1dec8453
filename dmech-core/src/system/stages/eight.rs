//! Eight numbers side by side: one for each stage of a step.

use core::fmt::Debug;
use core::ops::Add;

use dmech_scalar::{DoubleDouble, Lanes, LanesMask, Mask, Real, Rows};

use super::abreast::{Abreast, ByEight, Singly};
use super::{Columns, Row, STAGES};

/// A scalar of which eight can stand side by side: `f64` in the lanes of a register, others one by one.
pub trait Staging: Real {
    /// Eight of them.
    type Eight: Eight<Self>;
    /// Coordinates that are computed at a time where there are several.
    type Coordinates: Abreast<Self>;

    /// A coefficient of two parts.
    fn coefficient(hi: f64, lo: f64) -> Self;
    /// The larger of two numbers.
    #[inline(always)]
    fn larger_number(self, other: Self) -> Self {
        Self::either(other.less_or_equal(self), self, other)
    }
    /// The smallest normal number.
    #[inline(always)]
    fn smallest() -> Self {
        let [least, of_half_the_digits] = [f64::MIN_POSITIVE, f32::MIN_POSITIVE.into()].map(Self::from_f64);
        Self::either(least.equal(Self::ZERO), of_half_the_digits, least)
    }
}

/// Those of eight numbers that take part in an operation together.
pub(crate) type Part<R> = <<R as Staging>::Eight as Eight<R>>::Part;

/// Eight numbers of the type R.
pub trait Eight<R: Real>: Copy + Debug + Send + Sync {
    /// Those that take part in an operation together: all eight, or one after another.
    type Part: Real;
    /// How many of these there are.
    const PARTS: usize;

    /// The same number eight times.
    fn splat(x: R) -> Self;
    /// The same number for all of a part.
    fn alike(x: R) -> Self::Part;
    /// Coefficients of a part.
    fn row(row: &Row, part: usize) -> Self::Part;
    /// A part of these.
    fn part(&self, part: usize) -> Self::Part;
    /// Puts a part in its place.
    fn set(&mut self, part: usize, x: Self::Part);
    /// Number j, for all of a part.
    fn each(&self, j: usize) -> Self::Part;
    /// max(x, |y|) of numbers.
    fn larger(x: Self::Part, y: Self::Part) -> Self::Part;
    /// min(x, y) of numbers.
    #[inline(always)]
    fn smaller(x: Self::Part, y: Self::Part) -> Self::Part {
        Self::Part::either(x.less(y), x, y)
    }
    /// Whether a comparison holds for all of a part.
    fn all(mask: <Self::Part as Real>::Mask) -> R::Mask;
    /// Whether it holds for some.
    fn any(mask: <Self::Part as Real>::Mask) -> R::Mask;
    /// `yes` where the mask holds, `no` elsewhere.
    fn either(mask: R::Mask, yes: Self::Part, no: Self::Part) -> Self::Part;
    /// The largest of numbers.
    fn largest(&self) -> R;
    /// The sum.
    fn sum(&self) -> R;

    /// Part by part.
    #[inline(always)]
    fn by_part(f: impl Fn(usize) -> Self::Part) -> Self {
        let mut all = Self::splat(R::ZERO);
        for part in 0..Self::PARTS {
            all.set(part, f(part));
        }
        all
    }
}

const HALF: usize = STAGES / 2;

/// A part of Σⱼ columnⱼ xⱼ, on top of `start`.
#[inline(always)]
pub(crate) fn weighed<R: Real, E: Eight<R>>(columns: &Columns, x: &E, part: usize, start: E::Part) -> E::Part {
    let column = |j: usize| E::row(&columns[j], part);
    // Two sums that do not wait for each other.
    let (mut early, mut late) = (start, column(HALF) * x.each(HALF));
    for j in 0..HALF {
        early = column(j).mul_add(x.each(j), early);
    }
    for j in HALF + 1..STAGES {
        late = column(j).mul_add(x.each(j), late);
    }
    early + late
}

impl Staging for f64 {
    type Eight = Lanes;
    type Coordinates = ByEight;

    #[inline(always)]
    fn coefficient(hi: f64, _: f64) -> f64 {
        hi
    }
    /// In this form one instruction.
    #[inline(always)]
    fn larger_number(self, other: f64) -> f64 {
        if other > self { other } else { self }
    }
}

impl Eight<f64> for Lanes {
    type Part = Lanes;
    const PARTS: usize = 1;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        Lanes::splat(x)
    }
    #[inline(always)]
    fn alike(x: f64) -> Self {
        Lanes::splat(x)
    }
    #[inline(always)]
    fn row(row: &Row, _: usize) -> Self {
        Lanes::from_array(row.hi)
    }
    #[inline(always)]
    fn part(&self, _: usize) -> Self {
        *self
    }
    #[inline(always)]
    fn set(&mut self, _: usize, x: Self) {
        *self = x;
    }
    #[inline(always)]
    fn each(&self, j: usize) -> Self {
        Lanes::splat(self[j])
    }
    #[inline(always)]
    fn larger(x: Self, y: Self) -> Self {
        x.larger_number(y.abs())
    }
    #[inline(always)]
    fn smaller(x: Self, y: Self) -> Self {
        x.smaller_number(y)
    }
    #[inline(always)]
    fn all(mask: LanesMask) -> bool {
        mask.all()
    }
    #[inline(always)]
    fn any(mask: LanesMask) -> bool {
        mask.any()
    }
    #[inline(always)]
    fn either(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    #[inline(always)]
    fn largest(&self) -> f64 {
        self.largest_number()
    }
    #[inline(always)]
    fn sum(&self) -> f64 {
        Lanes::sum(*self)
    }
    #[inline(always)]
    fn by_part(f: impl Fn(usize) -> Self) -> Self {
        f(0)
    }
}

/// Eight in one, halves folded onto each other, as [`Lanes::sum`] does.
#[inline(always)]
fn folded<R: Real>(x: &[R; STAGES], onto: impl Fn(R, R) -> R) -> R {
    let four = |i: usize| onto(x[i], x[i + HALF]);
    onto(onto(four(0), four(2)), onto(four(1), four(3)))
}

impl<R: Staging> Eight<R> for [R; STAGES] {
    type Part = R;
    const PARTS: usize = STAGES;

    #[inline(always)]
    fn splat(x: R) -> Self {
        [x; STAGES]
    }
    #[inline(always)]
    fn alike(x: R) -> R {
        x
    }
    #[inline(always)]
    fn row(row: &Row, part: usize) -> R {
        R::coefficient(row.hi[part], row.lo[part])
    }
    #[inline(always)]
    fn part(&self, part: usize) -> R {
        self[part]
    }
    #[inline(always)]
    fn set(&mut self, part: usize, x: R) {
        self[part] = x;
    }
    #[inline(always)]
    fn each(&self, j: usize) -> R {
        self[j]
    }
    #[inline(always)]
    fn larger(x: R, y: R) -> R {
        x.larger_number(y.abs())
    }
    #[inline(always)]
    fn all(mask: R::Mask) -> R::Mask {
        mask
    }
    #[inline(always)]
    fn any(mask: R::Mask) -> R::Mask {
        mask
    }
    #[inline(always)]
    fn either(mask: R::Mask, yes: R, no: R) -> R {
        R::either(mask, yes, no)
    }
    #[inline(always)]
    fn largest(&self) -> R {
        folded(self, R::larger_number)
    }
    #[inline(always)]
    fn sum(&self) -> R {
        folded(self, Add::add)
    }
}

macro_rules! one_by_one {
    ($($real:ty $(, $n:ident)?: |$hi:ident, $lo:ident| $coefficient:expr $(, $larger:ident)?;)*) => {$(
        impl$(<const $n: usize>)? Staging for $real {
            type Eight = [Self; STAGES];
            type Coordinates = Singly;

            #[inline(always)]
            fn coefficient($hi: f64, $lo: f64) -> Self {
                $coefficient
            }
            $(#[inline(always)]
            fn $larger(self, other: Self) -> Self {
                <$real>::$larger(self, other)
            })?
        }
    )*};
}

one_by_one! {
    f32: |hi, lo| hi as f32 + lo as f32;
    DoubleDouble: |hi, lo| DoubleDouble::from(hi) + DoubleDouble::from(lo);
    Lanes: |hi, _lo| Lanes::splat(hi), larger_number;
    // Members side by side, of which each has the bits of one alone.
    Rows<N>, N: |hi, _lo| Self::from_f64(hi), larger_number;
}
