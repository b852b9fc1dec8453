//! Sums that carry their own rounding error.
//!
//! A state advanced by q += Δq loses up to half an ulp of q at every step; after n steps the lost parts are a walk of
//! length √n ulp at best, and n ulp where the roundings have a preferred sign. A compensated sum keeps the lost
//! part and gives it back with the next increment: what remains is half an ulp of each increment, |Δq| ≪ |q|, which
//! is no more than the increment's own rounding.

use crate::Real;

/// s = a + b rounded, and the error e of that rounding: s + e = a + b exactly, as long as nothing overflows.
///
/// Six operations, no comparison of |a| and |b|, so it serves SIMD lanes as well.
///
/// ```
/// use dmech_scalar::two_sum;
/// assert_eq!(two_sum(1e16, 1.0), (1e16, 1.0));
/// assert_eq!(two_sum(1.0, 1e16), (1e16, 1.0));
/// ```
///
/// # Reference
/// O. Møller, BIT 5 (1965) 37–50; D. E. Knuth, The Art of Computer Programming, volume 2, section 4.2.2,
/// theorem B.
#[inline(always)]
pub fn two_sum<R: Real>(a: R, b: R) -> (R, R) {
    let sum = a + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    (sum, (a - a_part) + (b - b_part))
}

/// A running sum hi + lo: hi is the sum rounded, lo what the rounding left out, |lo| ≤ ulp(hi)/2.
///
/// After n increments hi + lo differs from their exact sum by at most (ε/2) Σ|Δ| + n (ε²/4) max|hi|, where plain addition
/// leaves up to n (ε/2) max|hi| (ε = [`Real::EPSILON`]). An increment much larger than the sum is added
/// correctly, but costs the digits of `lo` that are below its own half ulp. Both parts are public because
/// a saved run must restore both to continue bit for bit.
///
/// ```
/// use dmech_scalar::Compensated;
///
/// let (mut plain, mut sum) = (0.0, Compensated::new(0.0));
/// for _ in 0..1_000_000 {
///     plain += 0.1_f64;
///     sum.add(0.1);
/// }
/// assert_eq!(sum.value(), 100_000.0);
/// assert!((plain - 100_000.0).abs() > 1e-6);
/// ```
///
/// # Reference
/// W. Kahan, Comm. ACM 8 (1965) 40: his recurrence, y = Δ + lo, (hi, lo) = hi + y; with [`two_sum`] in place of
/// his three operations, which need |hi| ≥ |y|. A. Neumaier, Z. angew. Math. Mech. 54 (1974) 39–51, makes the
/// same distinction by a comparison.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Compensated<R> {
    /// The sum, rounded.
    pub hi: R,
    /// The part of the sum that `hi` does not hold.
    pub lo: R,
}

impl<R: Real> Compensated<R> {
    /// The sum that starts from x.
    #[inline(always)]
    pub fn new(x: R) -> Self {
        Self { hi: x, lo: R::ZERO }
    }

    /// Adds dx together with what the last rounding left out.
    #[inline(always)]
    pub fn add(&mut self, dx: R) {
        (self.hi, self.lo) = two_sum(self.hi, dx + self.lo);
    }

    /// The sum, rounded.
    #[inline(always)]
    pub fn value(&self) -> R {
        self.hi
    }
}

/// D running sums side by side, such as the position or velocity of a particle; each as [`Compensated`].
///
/// ```
/// use dmech_scalar::CompensatedVector;
///
/// let mut q = CompensatedVector::new([1.0, -2.0]);
/// for _ in 0..1000 {
///     q.add([1e-17, 2e-17]); // too small to move 1.0 or −2.0 by itself
/// }
/// assert_eq!(q.value(), [1.0 + 1e-14, -2.0 + 2e-14]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompensatedVector<const D: usize, R> {
    /// The sums, rounded.
    pub hi: [R; D],
    /// The parts of the sums that `hi` does not hold.
    pub lo: [R; D],
}

impl<const D: usize, R: Real> CompensatedVector<D, R> {
    /// The sums that start from x.
    #[inline(always)]
    pub fn new(x: [R; D]) -> Self {
        Self { hi: x, lo: [R::ZERO; D] }
    }

    /// Adds dx, component by component, together with what the last roundings left out.
    #[inline(always)]
    pub fn add(&mut self, dx: [R; D]) {
        for i in 0..D {
            (self.hi[i], self.lo[i]) = two_sum(self.hi[i], dx[i] + self.lo[i]);
        }
    }

    /// The sums, rounded.
    #[inline(always)]
    pub fn value(&self) -> [R; D] {
        self.hi
    }
}
