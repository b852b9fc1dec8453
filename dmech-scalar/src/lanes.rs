//! Eight `f64` side by side.

mod number;

use core::fmt;
use core::ops::{Index, IndexMut, Neg};

use wide::bytemuck::cast;
use wide::{f64x2, f64x4, f64x8};

use crate::functions;
use crate::operators::operators;
use crate::primitive::FUSED;
use crate::{Count, Mask, Real};

/// Whether `wide` has the fused instruction where the target does; elsewhere each lane asks for it itself.
const FUSED_WIDE: bool = cfg!(any(
    all(any(target_arch = "x86", target_arch = "x86_64"), target_feature = "fma"),
    all(target_arch = "aarch64", target_feature = "neon"),
));

/// Eight `f64` that take part in every operation together, such as eight pairs of bodies or eight members of an ensemble.
///
/// Each lane of a result is the result of the `f64` operation on that lane, to the bit, so that a loop may run in
/// lanes and its remainder in `f64`. The sign and payload of a NaN are outside this promise, because Rust leaves them open
/// for `f64` itself. (It also leaves open which zero `min` and `max` return for 0 and −0; a test holds the lanes to the
/// one that `f64` gives.)
///
/// The operators, `sqrt`, `recip`, `mul_add`, `powi`, `abs`, `signum`, `round`, `floor`, `trunc`, `min`, `max`, comparisons and `select`
/// are one instruction or a few. The other functions have one source for `f64` and for lanes, without branches where that matters: eight
/// values of sin, exp or ln take about the time of one; of sin and cos half of it where all are within π/4 of 0. Three cases take longer,
/// for all eight if one of them is there:
///
/// - sin, cos and tan beyond |x| = 2·10⁵ and within 10⁻¹² of a multiple of π/2 (0 excepted) are computed one by one,
/// - logarithms, powers, roots and arctan of quotients have a second form for subnormal, infinite, negative or zero
///   arguments, exponentials for results near overflow or underflow, still in lanes,
/// - functions with a series near 0 and a closed form elsewhere compute both where the lanes disagree.
///
/// With AVX-512 the eight are one register, with AVX two, with SSE2 or NEON four.
///
/// [`Real::select`] evaluates both sides and blends them, because its lanes may disagree: neither side may rely on the
/// mask to be free of side effects or to end, and a NaN or infinity in a lane that is not taken does no harm.
///
/// ```
/// use dmech_scalar::{Lanes, Real};
///
/// let x = Lanes::from_fn(|i| i as f64);
/// let r2 = x.mul_add(x, Lanes::ONE);
/// let weight = Lanes::select(r2.less(Lanes::splat(20.0)), || r2.sqrt().recip(), || Lanes::ZERO);
/// assert_eq!((weight[4], weight[5]), (1.0 / 17.0_f64.sqrt(), 0.0));
///
/// let mut stored = [0.0; 10];
/// weight.store(&mut stored[2..]);
/// assert_eq!(Lanes::from_slice(&stored[2..]), weight);
/// ```
#[derive(Clone, Copy, Default, PartialEq)]
#[repr(transparent)]
pub struct Lanes(f64x8);

/// The outcome of a comparison of [`Lanes`]: true or false in each lane.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct LanesMask(f64x8);

impl Lanes {
    /// The number of lanes.
    pub const COUNT: usize = 8;

    /// x in every lane.
    #[inline(always)]
    pub const fn splat(x: f64) -> Self {
        Self(f64x8::new([x; 8]))
    }

    /// The lanes one by one.
    #[inline(always)]
    pub const fn from_array(lanes: [f64; 8]) -> Self {
        Self(f64x8::new(lanes))
    }

    /// f(i) in lane i.
    #[inline(always)]
    pub fn from_fn(mut f: impl FnMut(usize) -> f64) -> Self {
        let mut lanes = [0.0; 8];
        for lane in 0..8 {
            lanes[lane] = f(lane);
        }
        Self::from_array(lanes)
    }

    /// The first eight numbers of a slice; it need not be aligned. `as_chunks::<8>` and [`Lanes::from_array`] do the same
    /// without a check of the length.
    ///
    /// # Panics
    /// If the slice has fewer than eight.
    #[inline(always)]
    pub fn from_slice(x: &[f64]) -> Self {
        let (&eight, _) = x.split_first_chunk().expect("eight numbers for eight lanes");
        Self::from_array(eight).computed()
    }

    /// The same as the result of an operation, of which nothing is left. Numbers that are copied from memory come by way of the stack
    /// where a function lends them to its rare case, in halves that a register of eight waits for.
    #[inline(always)]
    fn computed(self) -> Self {
        Self(self.0 | f64x8::ZERO)
    }

    /// Writes the lanes to the first eight places of a slice.
    ///
    /// # Panics
    /// If the slice has fewer than eight.
    #[inline(always)]
    pub fn store(self, x: &mut [f64]) {
        let (first, _) = x.split_first_chunk_mut().expect("eight places for eight lanes");
        *first = self.to_array();
    }

    /// The lanes one by one.
    #[inline(always)]
    pub fn to_array(self) -> [f64; 8] {
        self.0.to_array()
    }

    /// The lanes one by one, to be written to.
    #[inline(always)]
    pub fn as_mut_slice(&mut self) -> &mut [f64] {
        self.0.as_mut_array()
    }

    /// The larger in each lane, of numbers: [`Real::max`] without its care for NaN, one instruction.
    #[inline(always)]
    pub fn larger_number(self, other: Self) -> Self {
        Self(self.0.fast_max(other.0))
    }

    /// The smaller in each lane, of numbers: [`Real::min`] without its care for NaN, one instruction.
    #[inline(always)]
    pub fn smaller_number(self, other: Self) -> Self {
        Self(self.0.fast_min(other.0))
    }

    /// The last lane.
    #[inline(always)]
    pub fn last(self) -> f64 {
        self.to_array()[7]
    }

    /// Each lane moved up by one, with `first` in the first: what comes before each lane.
    ///
    /// ```
    /// use dmech_scalar::Lanes;
    /// let x = Lanes::from_fn(|i| i as f64);
    /// assert_eq!(x.after(-1.0), x - Lanes::splat(1.0));
    /// ```
    #[inline(always)]
    pub fn after(self, first: f64) -> Self {
        let [x0, x1, x2, x3, x4, x5, x6, _] = self.to_array();
        Self::from_array([first, x0, x1, x2, x3, x4, x5, x6])
    }

    /// The same with the last lane of `before` in the first: registers in a row need no number between them.
    #[inline(always)]
    pub fn following(self, before: Self) -> Self {
        self.after(before.last())
    }

    /// The sum of the lanes, halves folded onto each other, on every target in this order:
    /// ((x₀ + x₄) + (x₂ + x₆)) + ((x₁ + x₅) + (x₃ + x₇)).
    ///
    /// ```
    /// use dmech_scalar::Lanes;
    /// let x = Lanes::from_array([1e16, 1.0, -3.0, 0.5, -1e16, 0.25, 3.0, 2.0]);
    /// assert_eq!(x.sum(), 3.75);
    /// ```
    #[inline(always)]
    pub fn sum(self) -> f64 {
        let x = self.to_array();
        let four = [x[0] + x[4], x[1] + x[5], x[2] + x[6], x[3] + x[7]];
        let two = [four[0] + four[2], four[1] + four[3]];
        two[0] + two[1]
    }

    /// The largest lane, of numbers.
    ///
    /// ```
    /// use dmech_scalar::Lanes;
    /// assert_eq!(Lanes::from_array([1.0, -3.0, 0.5, 2.0, 4.0, -9.0, 3.5, 2.5]).largest_number(), 4.0);
    /// ```
    #[inline(always)]
    pub fn largest_number(self) -> f64 {
        // Halves onto each other, in registers of their sizes: number by number compilers would look for other neighbours.
        let [x0, x1, x2, x3, x4, x5, x6, x7] = self.to_array();
        let [x0, x1, x2, x3] = f64x4::new([x0, x1, x2, x3]).fast_max(f64x4::new([x4, x5, x6, x7])).to_array();
        let [x0, x1] = f64x2::new([x0, x1]).fast_max(f64x2::new([x2, x3])).to_array();
        if x1 > x0 { x1 } else { x0 }
    }

    /// In lane k the [sum](Lanes::sum) of register k, to the bit.
    ///
    /// ```
    /// use dmech_scalar::Lanes;
    /// let x: [Lanes; 8] = core::array::from_fn(|k| Lanes::from_fn(|i| 0.1 + (i * k) as f64));
    /// assert_eq!(Lanes::sums(x), Lanes::from_fn(|k| x[k].sum()));
    /// ```
    #[inline(always)]
    pub fn sums(registers: [Self; 8]) -> Self {
        Self::folded(registers, |x, y| x + y)
    }

    /// In lane k the [largest](Lanes::largest_number) of register k.
    ///
    /// ```
    /// use dmech_scalar::Lanes;
    /// let x: [Lanes; 8] = core::array::from_fn(|k| Lanes::from_fn(|i| ((3 * i + k) % 8) as f64 - k as f64));
    /// assert_eq!(Lanes::largest_numbers(x), Lanes::from_fn(|k| 7.0 - k as f64));
    /// ```
    #[inline(always)]
    pub fn largest_numbers(registers: [Self; 8]) -> Self {
        Self::folded(registers, f64x4::fast_max)
    }

    /// Each register folded onto itself, four of them together.
    #[inline(always)]
    fn folded(registers: [Self; 8], onto: impl Fn(f64x4, f64x4) -> f64x4) -> Self {
        let half = |x: Self| -> [f64x2; 2] {
            let [low, high]: [f64x4; 2] = cast(x.0);
            cast(onto(low, high))
        };
        let quarters = |x: Self, y: Self| -> [f64; 4] {
            let ([x, x_high], [y, y_high]) = (half(x), half(y));
            onto(cast([x, y]), cast([x_high, y_high])).to_array()
        };
        let four = |a, b, c, d| {
            let (x, y) = (quarters(a, c), quarters(b, d));
            onto(f64x4::new([x[0], y[0], x[2], y[2]]), f64x4::new([x[1], y[1], x[3], y[3]]))
        };
        let [a, b, c, d, e, f, g, h] = registers;
        Self(cast([four(a, b, c, d), four(e, f, g, h)]))
    }
}

impl From<[f64; 8]> for Lanes {
    #[inline(always)]
    fn from(lanes: [f64; 8]) -> Self {
        Self::from_array(lanes)
    }
}

impl From<Lanes> for [f64; 8] {
    #[inline(always)]
    fn from(lanes: Lanes) -> Self {
        lanes.to_array()
    }
}

/// Lane i.
///
/// # Panics
/// If i is not below eight.
impl Index<usize> for Lanes {
    type Output = f64;
    #[inline(always)]
    fn index(&self, i: usize) -> &f64 {
        &self.0.as_array()[i]
    }
}

impl IndexMut<usize> for Lanes {
    #[inline(always)]
    fn index_mut(&mut self, i: usize) -> &mut f64 {
        &mut self.0.as_mut_array()[i]
    }
}

impl fmt::Debug for Lanes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&self.to_array(), f)
    }
}

/// As `f64` in each lane, precision and width too: `[1.00, 2.00, …]` for `{:.2}`.
impl fmt::Display for Lanes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, x) in self.to_array().iter().enumerate() {
            f.write_str(if i == 0 { "[" } else { ", " })?;
            fmt::Display::fmt(x, f)?;
        }
        f.write_str("]")
    }
}

impl Lanes {
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64x8, f64x8) -> f64x8) -> Self {
        Self(f(self.0, other.0))
    }
}

operators!(Lanes, []);

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl LanesMask {
    /// The outcome in each lane.
    #[inline(always)]
    pub fn to_array(self) -> [bool; 8] {
        let bits = self.0.to_bitmask();
        core::array::from_fn(|i| bits >> i & 1 == 1)
    }
}

impl fmt::Debug for LanesMask {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&self.to_array(), f)
    }
}

impl Mask for LanesMask {
    type Count = Lanes;

    const LANES: usize = Lanes::COUNT;

    /// By comparisons and not as constants, around which loops are laid out otherwise: Gauss steps of few bodies in lanes then take
    /// 2 % longer.
    #[inline(always)]
    fn of(holds: bool) -> Self {
        if holds { Lanes::ZERO.less(Lanes::ONE) } else { Lanes::ONE.less(Lanes::ZERO) }
    }
    #[inline(always)]
    fn all(self) -> bool {
        self.0.all()
    }
    #[inline(always)]
    fn any(self) -> bool {
        self.0.any()
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
    #[inline(always)]
    fn count(self, holds: Lanes, fails: Lanes) -> Lanes {
        Lanes::either(self, holds, fails)
    }
}

/// Whole numbers below 2⁵³.
impl Count for Lanes {
    #[inline(always)]
    fn of(n: u32) -> Self {
        Lanes::from_f64(n.into())
    }
    #[inline(always)]
    fn to_u64(self) -> u64 {
        self.to_f64() as u64
    }
}

/// `method(argument)` becomes a call of this crate's function of the same name.
macro_rules! own {
    ($($name:ident($($arg:ident)?);)*) => {$(
        #[inline]
        fn $name(self $(, $arg: Self)?) -> Self {
            functions::$name(self.computed() $(, $arg.computed())?)
        }
    )*};
}

impl Real for Lanes {
    type Mask = LanesMask;

    const ZERO: Self = Self::splat(0.0);
    const ONE: Self = Self::splat(1.0);
    const EPSILON: Self = Self::splat(f64::EPSILON);

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self::splat(x)
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.to_array()[0]
    }
    #[inline(always)]
    fn less(self, other: Self) -> LanesMask {
        LanesMask(self.0.simd_lt(other.0))
    }
    #[inline(always)]
    fn less_or_equal(self, other: Self) -> LanesMask {
        LanesMask(self.0.simd_le(other.0))
    }
    #[inline(always)]
    fn equal(self, other: Self) -> LanesMask {
        LanesMask(self.0.simd_eq(other.0))
    }
    #[inline(always)]
    fn finite(self) -> LanesMask {
        self.abs().less(Self::splat(f64::INFINITY))
    }
    #[inline(always)]
    fn select(mask: LanesMask, yes: impl FnOnce() -> Self, no: impl FnOnce() -> Self) -> Self {
        Self(mask.0.select(yes().0, no().0))
    }
    #[inline]
    fn lent(self, by: LanesMask) -> Self {
        let first = by.to_array().into_iter().position(|holds| holds);
        first.map_or(self, |lane| Self::either(by, self, Self::splat(self[lane])))
    }
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        if FUSED_WIDE {
            Self(self.0.mul_add(b.0, c.0))
        } else if FUSED {
            let (a, b, c) = (self.to_array(), b.to_array(), c.to_array());
            Self::from_fn(|i| a[i].mul_add(b[i], c[i]))
        } else {
            self * b + c
        }
    }
    #[inline(always)]
    fn recip(self) -> Self {
        Self::ONE / self
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn signum(self) -> Self {
        let sign = Self::ONE.0 | (self.0 & Self::splat(-0.0).0);
        Self(self.0.is_nan().select(self.0, sign))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // The other way round for the sake of signed zeros: `wide` returns its second argument when the two are equal, `f64`
        // the first.
        Self(other.0.min(self.0))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(other.0.max(self.0))
    }
    /// By squaring and multiplying, lowest bit first, and one division for n < 0: the products that `f64::powi` forms.
    #[inline(always)]
    fn powi(self, n: i32) -> Self {
        let (mut square, mut rest) = (self, n.unsigned_abs());
        let mut power = if rest & 1 == 1 { self } else { Self::ONE };
        while rest > 1 {
            rest >>= 1;
            square *= square;
            if rest & 1 == 1 {
                power *= square;
            }
        }
        if n < 0 { power.recip() } else { power }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    own! {
        exp(); exp2(); exp_m1(); ln(); ln_1p(); log2(); log10();
        sin(); cos(); tan(); asin(); acos(); atan(); atan2(x);
        sinh(); cosh(); tanh(); asinh(); acosh(); atanh(); powf(p); cbrt();
        sinc(); sinc_slope(); sinhc(); sinhc_slope(); atanc(); atanc_slope(); atanhc(); atanhc_slope();
    }
    #[inline(always)]
    fn round(self) -> Self {
        // The largest number below 1/2: what is less than half away from 0 stays so.
        let half = Self(f64x8::splat(0.5_f64.next_down()).copysign(self.0));
        (self + half).trunc()
    }
    #[inline(always)]
    fn floor(self) -> Self {
        Self(self.0.floor())
    }
    #[inline(always)]
    fn trunc(self) -> Self {
        Self(self.0.trunc())
    }
}
