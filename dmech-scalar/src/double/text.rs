//! Decimal digits.

use core::fmt::{self, Debug, Display, LowerExp};
use core::str::FromStr;

use super::DoubleDouble;

/// Digits that every number has. With those of a number whose parts lie apart, as 1 + 10⁻⁴⁰, there are more.
const DIGITS: usize = 31;

/// More digits than any `f64` has: the smallest have 767.
const ALL: usize = 800;

/// A number in decimal digits, all of them.
#[derive(Clone, Debug)]
struct Decimal {
    negative: bool,
    /// Without zeros in front and at the end; none at all for 0.
    digits: Vec<u8>,
    /// The power of ten of the first digit.
    exponent: i64,
}

impl Decimal {
    fn new(negative: bool, digits: Vec<u8>, exponent: i64) -> Self {
        let zeros = digits.iter().take_while(|&&digit| digit == 0).count();
        let end = digits.iter().rposition(|&digit| digit > 0).map_or(zeros, |last| last + 1);
        Decimal { negative, digits: digits[zeros..end].to_vec(), exponent: exponent - zeros as i64 }
    }

    /// The digits of a text that `f64` reads, or `None` if its exponent is beyond all bounds.
    fn read(text: &str) -> Option<Self> {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let exponent: i64 = exponent.parse().ok()?;
        let whole = mantissa.split('.').next().unwrap_or_default();
        let figures =
            |text: &str| text.bytes().filter(u8::is_ascii_digit).map(|digit| digit - b'0').collect::<Vec<_>>();
        let before = figures(whole).len() as i64;
        Some(Decimal::new(mantissa.starts_with('-'), figures(mantissa), exponent.checked_add(before - 1)?))
    }

    /// The number itself: a part has finitely many digits.
    fn of(x: f64) -> Self {
        Decimal::read(&format!("{x:.ALL$e}")).unwrap_or(Decimal::new(false, Vec::new(), 0))
    }

    /// Behind the last digit.
    fn end(&self) -> i64 {
        self.exponent - self.digits.len() as i64
    }

    fn plus(&self, other: &Decimal) -> Self {
        let (top, end) = (self.exponent.max(other.exponent) + 1, self.end().min(other.end()));
        let mut places = vec![0_i8; (top - end) as usize];
        for part in [self, other] {
            let first = (top - part.exponent) as usize;
            for (place, &digit) in places[first..].iter_mut().zip(&part.digits) {
                *place += if part.negative { -(digit as i8) } else { digit as i8 };
            }
        }
        let negative = places.iter().find(|place| **place != 0).is_some_and(|place| *place < 0);
        let mut carried = 0;
        for place in places.iter_mut().rev() {
            let sum = carried + if negative { -*place } else { *place };
            (*place, carried) = (sum.rem_euclid(10), sum.div_euclid(10));
        }
        Decimal::new(negative, places.into_iter().map(|place| place as u8).collect(), top)
    }

    fn opposite(mut self) -> Self {
        self.negative = !self.negative;
        self
    }

    /// So many digits, rounded half up; none and less than none are of a number that is 0 there, or has become 1.
    fn rounded(&self, digits: i64) -> Self {
        let length = digits.clamp(0, self.digits.len() as i64) as usize;
        let up = digits >= 0 && self.digits.get(length).is_some_and(|&digit| digit >= 5);
        let kept = Decimal::new(self.negative, self.digits[..length].to_vec(), self.exponent);
        if !up {
            return kept;
        }
        kept.plus(&Decimal::new(self.negative, vec![1], self.exponent + 1 - length as i64))
    }

    /// The digit of 10ᵏ.
    fn at(&self, k: i64) -> char {
        let digit = usize::try_from(self.exponent - k).ok().and_then(|place| self.digits.get(place));
        char::from(b'0' + digit.copied().unwrap_or(0))
    }

    /// With `decimals` places behind the point.
    fn fixed(&self, decimals: usize) -> String {
        let mut text: String = (0..=self.exponent.max(0)).rev().map(|k| self.at(k)).collect();
        if decimals > 0 {
            text.push('.');
            text.extend((1..=decimals).map(|k| self.at(-(k as i64))));
        }
        text
    }

    /// With one digit before the point and `decimals` behind.
    fn scientific(&self, decimals: usize) -> String {
        let mut text = String::from(self.at(self.exponent));
        if decimals > 0 {
            text.push('.');
            text.extend((1..=decimals).map(|k| self.at(self.exponent - k as i64)));
        }
        format!("{text}e{}", self.exponent)
    }
}

impl DoubleDouble {
    /// All digits of |self|.
    fn decimal(self) -> Decimal {
        let mut sum = Decimal::of(self.hi).plus(&Decimal::of(self.lo));
        sum.negative = false;
        sum
    }

    /// The fewest digits of |self| that read back as the same number, 31 or more but for zeros at the end.
    fn shortest(self) -> Decimal {
        let (all, negative) = (self.decimal(), self.hi < 0.0);
        for digits in DIGITS..all.digits.len() {
            let rounded = all.rounded(digits as i64);
            let back = DoubleDouble::nearest(&Decimal { negative, ..rounded.clone() });
            if (back.hi, back.lo) == (self.hi, self.lo) {
                return rounded;
            }
        }
        all
    }

    /// The number nearest to these digits: the nearest `f64`, and that to what is missing.
    fn nearest(decimal: &Decimal) -> Self {
        let nearest = |decimal: &Decimal| {
            let text = decimal.scientific(decimal.digits.len().saturating_sub(1));
            let size = text.parse().unwrap_or(f64::NAN);
            if decimal.negative { -size } else { size }
        };
        let hi = nearest(decimal);
        if !hi.is_finite() {
            return hi.into();
        }
        DoubleDouble::pair(hi, nearest(&decimal.plus(&Decimal::of(hi).opposite())))
    }
}

impl Debug for DoubleDouble {
    /// Both parts, with which the number can be made again.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "DoubleDouble({:?}, {:?})", self.hi, self.lo)
    }
}

impl Display for DoubleDouble {
    /// As many digits as it takes to read the same number back, or as many behind the point as asked for; very large and
    /// very small numbers with an exponent.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.hi.is_finite() || self.hi == 0.0 {
            return Display::fmt(&self.hi, f);
        }
        let text = match f.precision() {
            Some(decimals) => {
                let decimal = self.decimal();
                decimal.rounded(decimal.exponent + 1 + decimals as i64).fixed(decimals)
            }
            None => {
                let decimal = self.shortest();
                if (-7..DIGITS as i64).contains(&decimal.exponent) {
                    decimal.fixed((-1 - decimal.end()).max(0) as usize)
                } else {
                    decimal.scientific(decimal.digits.len() - 1)
                }
            }
        };
        f.pad_integral(self.hi > 0.0, "", &text)
    }
}

impl LowerExp for DoubleDouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.hi.is_finite() || self.hi == 0.0 {
            return LowerExp::fmt(&self.hi, f);
        }
        let text = match f.precision() {
            Some(decimals) => self.decimal().rounded(decimals as i64 + 1).scientific(decimals),
            None => {
                let decimal = self.shortest();
                decimal.scientific(decimal.digits.len() - 1)
            }
        };
        f.pad_integral(self.hi > 0.0, "", &text)
    }
}

/// A text that is not a decimal number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParseDoubleDoubleError;

impl Display for ParseDoubleDoubleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("not a decimal number, such as 0.1, -12 or 6.62607015e-34")
    }
}

impl core::error::Error for ParseDoubleDoubleError {}

impl FromStr for DoubleDouble {
    type Err = ParseDoubleDoubleError;

    /// Whatever `f64` reads, as the nearest number: the nearest `f64`, and that to the rest.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        // The grammar is that of `f64`; what is not finite there is not here.
        let plain: f64 = text.parse().map_err(|_| ParseDoubleDoubleError)?;
        if !plain.is_finite() || plain == 0.0 {
            return Ok(plain.into());
        }
        Decimal::read(text).map(|decimal| DoubleDouble::nearest(&decimal)).ok_or(ParseDoubleDoubleError)
    }
}
