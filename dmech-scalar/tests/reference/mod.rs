//! The cardinal functions and their slopes with 120 digits.

use crate::exact::{Big, big};

/// A cardinal function or slope: its Taylor coefficients in y = x², and its closed form for x ≠ 0.
#[derive(Clone, Copy)]
pub(crate) struct Exact {
    pub(crate) coefficient: fn(u32) -> Big,
    pub(crate) closed: fn(&Big) -> Big,
}

impl Exact {
    /// g(x), with at least 90 correct digits: the closed forms of the slopes lose x² of their 400 bits.
    pub(crate) fn at(&self, x: &Big) -> Big {
        if x.to_f64().value().abs() < 2f64.powi(-20) { self.series(x, 14) } else { (self.closed)(x) }
    }

    /// The first terms of the series.
    pub(crate) fn series(&self, x: &Big, terms: u32) -> Big {
        let y = x * x;
        (0..terms).rev().fold(big(0.0), |sum, n| sum * &y + (self.coefficient)(n))
    }
}

fn ratio(p: u32, q: u32) -> Big {
    big(p.into()) / big(q.into())
}

fn inverse_factorial(n: u32) -> Big {
    (2..=n).fold(big(1.0), |product, k| product / big(k.into()))
}

fn alternating(n: u32, c: Big) -> Big {
    if n.is_multiple_of(2) { c } else { -c }
}

pub(crate) const SINC: Exact =
    Exact { coefficient: |n| alternating(n, inverse_factorial(2 * n + 1)), closed: |x| x.sin() / x };

pub(crate) const SINC_SLOPE: Exact = Exact {
    coefficient: |n| alternating(n + 1, inverse_factorial(2 * n + 3) * big((2 * n + 2).into())),
    closed: |x| (x.cos() - x.sin() / x) / (x * x),
};

pub(crate) const SINHC: Exact = Exact { coefficient: |n| inverse_factorial(2 * n + 1), closed: |x| x.sinh() / x };

pub(crate) const SINHC_SLOPE: Exact = Exact {
    coefficient: |n| inverse_factorial(2 * n + 3) * big((2 * n + 2).into()),
    closed: |x| (x.cosh() - x.sinh() / x) / (x * x),
};

pub(crate) const ATANC: Exact =
    Exact { coefficient: |n| alternating(n, ratio(1, 2 * n + 1)), closed: |x| x.atan() / x };

pub(crate) const ATANC_SLOPE: Exact = Exact {
    coefficient: |n| alternating(n + 1, ratio(2 * n + 2, 2 * n + 3)),
    closed: |x| (big(1.0) / (big(1.0) + x * x) - x.atan() / x) / (x * x),
};

pub(crate) const ATANHC: Exact = Exact { coefficient: |n| ratio(1, 2 * n + 1), closed: |x| x.atanh() / x };

pub(crate) const ATANHC_SLOPE: Exact = Exact {
    coefficient: |n| ratio(2 * n + 2, 2 * n + 3),
    closed: |x| (big(1.0) / (big(1.0) - x * x) - x.atanh() / x) / (x * x),
};
