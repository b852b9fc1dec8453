//! Axes.

use std::ops::Range;

use crate::number::{number, power};

/// The largest number on an axis: beyond it the length of an axis is no number.
const MOST: f64 = 1e300;

/// An axis: its name, and the range of its values, or of their decimal logarithms.
///
/// Any range will do: one that is reversed is turned round, one that is empty is widened, and an end that is no number is
/// taken for 0 or 1. One shorter than 10⁻¹¹ has no marks: [`Fit`](crate::Fit) shows such values in units of a power of ten.
pub struct Axis<'a> {
    pub(crate) name: &'a str,
    pub(crate) range: Range<f64>,
    pub(crate) mark: Box<dyn Fn(&f64) -> String>,
    pub(crate) marks: usize,
}

impl<'a> Axis<'a> {
    /// Of numbers.
    pub fn linear(name: &'a str, range: Range<f64>) -> Self {
        let range = sound(range);
        // Marks are sums of steps: what is below a thousandth of the range is rounding.
        let unit = 1e-3 * 10_f64.powf((range.end - range.start).log10().floor()).max(f64::MIN_POSITIVE);
        // Marks are found to 10⁻¹⁶.
        let marks = if range.end - range.start < 1e-11 { 0 } else { 8 };
        Axis { name, range, mark: Box::new(move |x| number(rounded(*x, unit))), marks }
    }

    /// The points on it are decimal logarithms.
    pub fn powers_of_ten(name: &'a str, range: Range<f64>) -> Self {
        let mut range = sound(range);
        range = range.start.clamp(-400.0, 399.0)..range.end.clamp(-399.0, 400.0);
        if range.end - range.start < 1.0 {
            range = range.start.floor()..range.end.floor() + 1.0;
        }
        // Of more powers only every second, third … has room.
        let marks = ((range.end - range.start).ceil() as usize + 1).min(18);
        Axis { name, range, mark: Box::new(power_of_ten), marks }
    }

    /// With no more marks than about so many.
    pub fn marks(self, marks: usize) -> Self {
        Axis { marks: marks.min(self.marks), ..self }
    }
}

fn power_of_ten(exponent: &f64) -> String {
    // Between the powers there is room for marks where there are few of them.
    if (exponent - exponent.round()).abs() > 1e-6 { String::new() } else { power("10", *exponent as i64) }
}

/// A range that can be divided and marked.
pub(crate) fn sound(Range { start, end }: Range<f64>) -> Range<f64> {
    let finite = |x: f64, other: f64| if x.is_nan() { other } else { x.clamp(-MOST, MOST) };
    let [a, b] = [finite(start, 0.0), finite(end, 1.0)];
    let (start, end) = (a.min(b), a.max(b));
    let most = a.abs().max(b.abs());
    if end - start > 1e-9 * most {
        return start..end;
    }
    let half = if most == 0.0 { 0.5 } else { 0.1 * most };
    start - half..end + half
}

/// To a multiple of a power of ten, and the number nearest to it.
pub(crate) fn rounded(x: f64, unit: f64) -> f64 {
    let digits = (-unit.log10().round()).clamp(-300.0, 300.0) as usize;
    let multiple = (x / unit).round() * unit;
    let text = if unit < 0.5 { format!("{multiple:.digits$}") } else { format!("{multiple}") };
    text.parse::<f64>().unwrap_or(multiple) + 0.0
}
