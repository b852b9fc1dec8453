//! Numbers in texts for people.

use core::fmt;

/// A number as it stands in a message or a report: with an exponent outside 10⁻³ … 10⁶, so that it has few digits whatever
/// the units are. The decimals asked for are those of what is shown, in either form; none asked for, as many as it takes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number(pub(crate) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Number(x) = *self;
        if x == 0.0 || !x.is_finite() || (1e-3..1e6).contains(&x.abs()) {
            fmt::Display::fmt(&x, f)
        } else {
            fmt::LowerExp::fmt(&x, f)
        }
    }
}

/// The longest step of a saved motion, 0 or NaN where there was none.
#[cfg(any(feature = "serde", feature = "store"))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Longest(pub(crate) f64);

#[cfg(any(feature = "serde", feature = "store"))]
impl fmt::Display for Longest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 == 0.0 || !self.0.is_finite() { f.write_str("not limited") } else { Number(self.0).fmt(f) }
    }
}

#[cfg(test)]
mod tests {
    use super::Number;

    #[cfg(any(feature = "serde", feature = "store"))]
    #[test]
    fn there_may_be_no_longest_step() {
        let shown = [0.3, 1e-9, 0.0, f64::NAN, f64::INFINITY].map(|dt| super::Longest(dt).to_string());
        assert_eq!(shown, ["0.3", "1e-9", "not limited", "not limited", "not limited"]);
    }

    #[test]
    fn a_number_has_an_exponent_where_it_is_large_or_small() {
        let shown = [
            (0.0, "0"),
            (-0.25, "-0.25"),
            (0.001, "0.001"),
            (999_999.5, "999999.5"),
            (1e6, "1e6"),
            (-0.000_999, "-9.99e-4"),
            (1e300, "1e300"),
            (-1e-300, "-1e-300"),
            (f64::NAN, "NaN"),
            (f64::INFINITY, "inf"),
        ];
        for (x, text) in shown {
            assert_eq!(Number(x).to_string(), text);
            assert_eq!(text.parse::<f64>().unwrap().to_bits() << 1, x.to_bits() << 1, "{text}");
        }
        assert_eq!(format!("{:.3}|{:>9.2}|", Number(-2.648_356_228e33), Number(0.5)), "-2.648e33|     0.50|");
    }
}
