//! Several registers of eight `f64` side by side.

use core::array::from_fn;
use core::fmt;
use core::ops::{Index, IndexMut, Neg};

use crate::operators::operators;
use crate::{Count, Lanes, LanesMask, Mask, Real};

/// N registers of eight lanes that take part in every operation one after another, each as [`Lanes`] do: a division waits for the one
/// before it in its own row only.
///
/// ```
/// use dmech_scalar::{Real, Rows};
///
/// let x = Rows::<2>::from_fn(|i| i as f64);
/// assert_eq!((Rows::<2>::COUNT, x.sqrt()[9]), (16, 3.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rows<const N: usize>([Lanes; N]);

/// The outcome of a comparison of [`Rows`].
#[derive(Clone, Copy, Debug)]
pub struct RowsMask<const N: usize>([LanesMask; N]);

impl<const N: usize> Rows<N> {
    /// The number of lanes.
    pub const COUNT: usize = N * Lanes::COUNT;

    /// f(i) in lane i.
    #[inline(always)]
    pub fn from_fn(mut f: impl FnMut(usize) -> f64) -> Self {
        let mut rows = Self::ZERO;
        for lane in 0..Self::COUNT {
            rows[lane] = f(lane);
        }
        rows
    }

    /// The larger in each lane, of numbers: [`Lanes::larger_number`].
    #[inline(always)]
    pub fn larger_number(self, other: Self) -> Self {
        self.with(other, Lanes::larger_number)
    }

    /// Component by component.
    #[inline(always)]
    fn map(self, f: impl Fn(Lanes) -> Lanes) -> Self {
        let mut all = self;
        for i in 0..N {
            all.0[i] = f(self.0[i]);
        }
        all
    }

    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(Lanes, Lanes) -> Lanes) -> Self {
        let mut all = self;
        for i in 0..N {
            all.0[i] = f(self.0[i], other.0[i]);
        }
        all
    }

    #[inline(always)]
    fn compare(self, other: Self, f: impl Fn(Lanes, Lanes) -> LanesMask) -> RowsMask<N> {
        RowsMask(from_fn(|i| f(self.0[i], other.0[i])))
    }
}

impl<const N: usize> Default for Rows<N> {
    fn default() -> Self {
        Self::ZERO
    }
}

/// As eight lanes after another.
impl<const N: usize> fmt::Display for Rows<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|row| row.fmt(f))
    }
}

/// Lane i.
///
/// # Panics
/// If there are not so many.
impl<const N: usize> Index<usize> for Rows<N> {
    type Output = f64;
    #[inline(always)]
    fn index(&self, i: usize) -> &f64 {
        &self.0[i / Lanes::COUNT][i % Lanes::COUNT]
    }
}

/// Lane i.
///
/// # Panics
/// If there are not so many.
impl<const N: usize> IndexMut<usize> for Rows<N> {
    #[inline(always)]
    fn index_mut(&mut self, i: usize) -> &mut f64 {
        &mut self.0[i / Lanes::COUNT][i % Lanes::COUNT]
    }
}

impl<const N: usize> RowsMask<N> {
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(LanesMask, LanesMask) -> LanesMask) -> Self {
        Self(from_fn(|i| f(self.0[i], other.0[i])))
    }
}

impl<const N: usize> Mask for RowsMask<N> {
    type Count = Rows<N>;

    const LANES: usize = Rows::<N>::COUNT;

    #[inline(always)]
    fn of(holds: bool) -> Self {
        Self([Mask::of(holds); N])
    }
    #[inline(always)]
    fn all(self) -> bool {
        self.0.into_iter().all(Mask::all)
    }
    #[inline(always)]
    fn any(self) -> bool {
        self.0.into_iter().any(Mask::any)
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self.with(other, Mask::and)
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self.with(other, Mask::or)
    }
    #[inline(always)]
    fn not(self) -> Self {
        Self(self.0.map(Mask::not))
    }
    #[inline(always)]
    fn count(self, holds: Rows<N>, fails: Rows<N>) -> Rows<N> {
        Rows::either(self, holds, fails)
    }
}

/// Whole numbers below 2⁵³.
impl<const N: usize> Count for Rows<N> {
    #[inline(always)]
    fn of(n: u32) -> Self {
        Rows::from_f64(n.into())
    }
    #[inline(always)]
    fn to_u64(self) -> u64 {
        self.to_f64() as u64
    }
}

operators!(Rows<N>, [const N: usize]);

impl<const N: usize> Neg for Rows<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(Neg::neg)
    }
}

macro_rules! row_by_row {
    (of_one: $($one:ident)*; of_two: $($two:ident)*; compare: $($compare:ident)*;) => {
        $(#[inline(always)]
        fn $one(self) -> Self {
            self.map(Real::$one)
        })*
        $(#[inline(always)]
        fn $two(self, other: Self) -> Self {
            self.with(other, Real::$two)
        })*
        $(#[inline(always)]
        fn $compare(self, other: Self) -> RowsMask<N> {
            self.compare(other, Real::$compare)
        })*
    };
}

impl<const N: usize> Real for Rows<N> {
    type Mask = RowsMask<N>;

    const ZERO: Self = Self([Lanes::ZERO; N]);
    const ONE: Self = Self([Lanes::ONE; N]);
    const EPSILON: Self = Self([Lanes::EPSILON; N]);

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self([Lanes::splat(x); N])
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self[0]
    }
    #[inline(always)]
    fn finite(self) -> RowsMask<N> {
        RowsMask(self.0.map(Real::finite))
    }
    #[inline(always)]
    fn select(mask: RowsMask<N>, yes: impl FnOnce() -> Self, no: impl FnOnce() -> Self) -> Self {
        let (yes, mut all) = (yes(), no());
        for i in 0..N {
            all.0[i] = Lanes::either(mask.0[i], yes.0[i], all.0[i]);
        }
        all
    }
    #[inline]
    fn lent(self, by: RowsMask<N>) -> Self {
        let first = by.0.iter().flat_map(|row| row.to_array()).position(|holds| holds);
        first.map_or(self, |lane| Self::either(by, self, Self::from_f64(self[lane])))
    }
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        let mut all = self;
        for i in 0..N {
            all.0[i] = self.0[i].mul_add(b.0[i], c.0[i]);
        }
        all
    }
    #[inline(always)]
    fn powi(self, n: i32) -> Self {
        self.map(|row| row.powi(n))
    }
    row_by_row! {
        of_one:
        recip abs signum round floor trunc sqrt cbrt exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan asin
        acos atan sinh cosh tanh asinh acosh atanh sinc sinc_slope sinhc sinhc_slope atanc atanc_slope atanhc atanhc_slope;
        of_two: min max powf atan2;
        compare: less less_or_equal equal;
    }
}
