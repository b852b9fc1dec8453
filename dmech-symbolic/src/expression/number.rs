//! Numbers that can be compared and hashed, and arithmetic that knows when it is exact.

use dmech_scalar::Real;

/// A binary64 number; −0 is stored as 0, so that equal numbers have equal bits.
/// The order is that of the bits: a fixed one, not that of the numbers.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Number(u64);

impl Number {
    /// 0.
    pub const ZERO: Self = Self(0);
    /// 1.
    pub const ONE: Self = Self(1.0_f64.to_bits());

    /// What stands for [`Real::least`] of whatever scalar there will be.
    pub const LEAST: Self = Self(1e-307_f64.to_bits());

    /// What stands for [`Real::rounding`].
    pub const ROUNDING: Self = Self((7.0 * f64::EPSILON).to_bits());

    /// The number x.
    pub fn new(x: f64) -> Self {
        Self((x + 0.0).to_bits())
    }

    /// Its value.
    pub fn value(self) -> f64 {
        f64::from_bits(self.0)
    }

    /// Its value in a scalar type.
    pub fn of<R: Real>(self) -> R {
        match self {
            Self::LEAST => R::least(),
            Self::ROUNDING => R::rounding(),
            _ => R::from_f64(self.value()),
        }
    }

    /// Whether it is ±2ᵏ, so that products with it are exact.
    pub fn is_power_of_two(self) -> bool {
        self.value().is_normal() && self.0 << 12 == 0
    }

    /// −self.
    pub fn negated(self) -> Self {
        Self::new(-self.value())
    }

    /// self + other where that is exact.
    pub fn exact_sum(self, other: Self) -> Option<Self> {
        let (a, b) = (self.value(), other.value());
        let sum = a + b;
        let t = sum - a;
        let error = (a - (sum - t)) + (b - t);
        (error == 0.0 && sum.is_finite()).then(|| Self::new(sum))
    }

    /// self·other where that is exact.
    pub fn exact_product(self, other: Self) -> Option<Self> {
        let (a, b) = (self.value(), other.value());
        let product = a * b;
        let normal = product.is_normal() && product.abs() > 1e-250 || a == 0.0 || b == 0.0;
        (normal && a.mul_add(b, -product) == 0.0).then(|| Self::new(product))
    }

    /// self/other where that is exact.
    pub fn exact_quotient(self, other: Self) -> Option<Self> {
        let quotient = Self::new(self.value() / other.value());
        (quotient.value().is_normal() && quotient.exact_product(other) == Some(self)).then_some(quotient)
    }

    /// selfⁿ where that is exact.
    pub fn exact_power(self, n: i32) -> Option<Self> {
        if n < 0 {
            let inverse = Self::new(1.0 / self.value());
            return (self.exact_product(inverse) == Some(Self::ONE)).then(|| inverse.exact_power(-n))?;
        }
        let mut power = Self::ONE;
        // An exact power other than of ±2ᵏ leaves 53 bits long before the 64th.
        for _ in 0..n.min(1100) {
            if power == Self::ZERO || (self == Self::ONE) {
                break;
            }
            power = power.exact_product(self)?;
        }
        Some(power)
    }

    /// √self where that is exact.
    pub fn exact_sqrt(self) -> Option<Self> {
        let root = self.value().sqrt();
        (root * root == self.value() && Self::new(root).exact_product(Self::new(root)).is_some())
            .then(|| Self::new(root))
    }
}

/// Combines numbers two by two until no two of them have an exact combination: what is left, in a fixed order, is not
/// changed by doing it again.
pub(super) fn combined(mut numbers: Vec<Number>, combine: fn(Number, Number) -> Option<Number>) -> Vec<Number> {
    numbers.sort_unstable();
    let pair = |numbers: &[Number]| {
        let pairs = (0..numbers.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        pairs.into_iter().find_map(|(i, j)| Some((i, j, combine(numbers[i], numbers[j])?)))
    };
    while let Some((i, j, number)) = pair(&numbers) {
        numbers.remove(j);
        numbers[i] = number;
        numbers.sort_unstable();
    }
    numbers
}

impl std::fmt::Debug for Number {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.value())
    }
}
