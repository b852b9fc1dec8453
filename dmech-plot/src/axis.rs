//! Axes.

use std::ops::Range;

/// An axis: its name, and the range of its values, or of their decimal logarithms.
pub struct Axis<'a> {
    pub(crate) name: &'a str,
    pub(crate) range: Range<f64>,
    pub(crate) mark: fn(&f64) -> String,
    pub(crate) marks: usize,
}

impl<'a> Axis<'a> {
    /// Of numbers.
    pub fn linear(name: &'a str, range: Range<f64>) -> Self {
        Axis { name, range, mark: |x| format!("{}", (1e9 * x).round() / 1e9 + 0.0).replace('-', "−"), marks: 8 }
    }

    /// The points on it are decimal logarithms.
    pub fn powers_of_ten(name: &'a str, range: Range<f64>) -> Self {
        // Of more powers only every second, third … has room.
        let marks = ((range.end - range.start).ceil() as usize + 1).min(18);
        Axis { name, range, mark: power_of_ten, marks }
    }
}

fn power_of_ten(exponent: &f64) -> String {
    let superscript = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    format!("10{}", format!("{exponent:.0}").chars().map(superscript).collect::<String>())
}
