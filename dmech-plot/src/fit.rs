//! Axes that fit any values.

use std::ops::Range;

use crate::axis::{rounded, sound};
use crate::number::{number, power};

/// How values of any size are shown on an axis: less an offset that they have in common, in units of a power of ten.
///
/// ```
/// use dmech_plot::Fit;
///
/// let tiny = Fit::of([0.0, 2e-20, f64::NAN]);
/// assert_eq!((tiny.name("x"), tiny.at(2e-20).round()), ("x / 10⁻²⁰".to_owned(), 2.0));
/// let close = Fit::of([5.0, 5.0 + 2e-9]);
/// assert_eq!(close.name("x"), "(x − 5) / 10⁻⁹");
/// assert!((close.at(5.0 + 2e-9) - 2.0).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Fit {
    least: f64,
    most: f64,
    offset: f64,
    exponent: i32,
}

impl Fit {
    /// Of values; those that are no finite numbers are left out.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let finite = values.into_iter().filter(|x| x.is_finite());
        let (least, most) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (x.min(a), x.max(b)));
        let (least, most) = if least > most { (0.0, 0.0) } else { (least, most) };
        let (half, size) = (0.5 * most - 0.5 * least, least.abs().max(most.abs()));
        let offset = if half > 0.0 && half < 1e-4 * size {
            rounded(least, 10_f64.powi(magnitude(half)).max(f64::MIN_POSITIVE))
        } else {
            0.0
        };
        let exponent = magnitude((least - offset).abs().max((most - offset).abs()));
        Fit { least, most, offset, exponent: if (-2..5).contains(&exponent) { 0 } else { exponent } }
    }

    /// On one scale with another: distances can be compared.
    pub fn alike(self, other: &Fit) -> [Fit; 2] {
        let exponent =
            [self, *other].into_iter().max_by(|a, b| a.width().total_cmp(&b.width())).map_or(0, |fit| fit.exponent);
        [self, *other].map(|fit| Fit { exponent, ..fit })
    }

    /// The length of their range.
    pub fn width(&self) -> f64 {
        0.5 * self.most - 0.5 * self.least
    }

    /// Where a value stands on the axis.
    pub fn at(&self, x: f64) -> f64 {
        // In two factors: 10³⁰⁸ is a number and 10⁻³²⁰ hardly is.
        let half = self.exponent / 2;
        (x - self.offset) / 10_f64.powi(half) / 10_f64.powi(self.exponent - half)
    }

    /// From the least value to the largest, as they stand on the axis, and a part of it more at both ends.
    pub fn range(&self, more: f64) -> Range<f64> {
        let Range { start, end } = sound(self.at(self.least)..self.at(self.most));
        let margin = more * (end - start);
        start - margin..end + margin
    }

    /// The name of the axis, of a quantity.
    pub fn name(&self, quantity: &str) -> String {
        let less = match self.offset {
            0.0 => quantity.to_owned(),
            offset if offset < 0.0 => format!("{quantity} + {}", number(-offset)),
            offset => format!("{quantity} − {}", number(offset)),
        };
        match (self.exponent, self.offset) {
            (0, _) => less,
            (exponent, 0.0) => format!("{less} / {}", power("10", exponent)),
            (exponent, _) => format!("({less}) / {}", power("10", exponent)),
        }
    }
}

/// The power of ten below a number.
fn magnitude(x: f64) -> i32 {
    if x > 0.0 { x.log10().floor() as i32 } else { 0 }
}
