//! Decimal digits.

use core::fmt::{self, Debug, Display, LowerExp, Write};
use core::str::FromStr;

use super::DoubleDouble;
use super::hyperbolic::abs;
use super::power::powi;

/// Digits that a number has.
const DIGITS: usize = 31;

const TEN: DoubleDouble = DoubleDouble::pair(10.0, 0.0);

/// Decimal digits and the power of ten of the first one.
struct Decimal {
    digits: [u8; DIGITS + 1],
    length: usize,
    exponent: i32,
}

/// x 10ᵏ, by a power that is exact for |k| ≤ 45.
fn shifted(x: DoubleDouble, k: i32) -> DoubleDouble {
    // 10³⁰⁸ is finite, 10³²⁴ is not.
    if k > 300 {
        return shifted(shifted(x, 300), k - 300);
    }
    if k < -300 {
        return shifted(shifted(x, -300), k + 300);
    }
    let power = powi(TEN, k.abs());
    if k < 0 { x / power } else { x * power }
}

impl Decimal {
    /// The digits of a positive finite number: as many as asked for, or as many as end `decimals` places behind the point.
    fn of(x: DoubleDouble, significant: usize, decimals: Option<usize>) -> Self {
        let mut exponent = x.hi.log10().floor() as i32;
        let mut rest = shifted(x, -exponent);
        if rest.hi < 1.0 || (rest.hi == 1.0 && rest.lo < 0.0) {
            (rest, exponent) = (rest * TEN, exponent - 1);
        } else if rest.hi > 10.0 || (rest.hi == 10.0 && rest.lo >= 0.0) {
            (rest, exponent) = (rest / TEN, exponent + 1);
        }
        let wanted = decimals.map_or(significant as i64, |decimals| decimals as i64 + i64::from(exponent) + 1);
        let length = wanted.clamp(0, DIGITS as i64) as usize;
        let mut digits = [0; DIGITS + 1];
        for digit in &mut digits[..length] {
            let mut whole = rest.hi.floor();
            if rest.hi == whole && rest.lo < 0.0 {
                whole -= 1.0;
            }
            *digit = whole.clamp(0.0, 9.0) as u8;
            rest = rest.plus(-whole) * TEN;
        }
        let mut decimal = Decimal { digits, length, exponent };
        if wanted >= 0 && rest.hi >= 5.0 {
            decimal.round_up();
        }
        decimal
    }

    /// Adds one in the last place.
    fn round_up(&mut self) {
        for digit in self.digits[..self.length].iter_mut().rev() {
            if *digit < 9 {
                *digit += 1;
                return;
            }
            *digit = 0;
        }
        // 9.99… has become 10.
        self.digits.copy_within(0..DIGITS, 1);
        self.digits[0] = 1;
        self.exponent += 1;
        self.length = (self.length + 1).min(DIGITS);
    }

    /// Without the zeros at the end.
    fn trimmed(mut self) -> Self {
        while self.length > 1 && self.digits[self.length - 1] == 0 {
            self.length -= 1;
        }
        self
    }

    /// The digit of 10ᵏ.
    fn at(&self, k: i32) -> char {
        let place = i64::from(self.exponent) - i64::from(k);
        let digit = if (0..self.length as i64).contains(&place) { self.digits[place as usize] } else { 0 };
        char::from(b'0' + digit)
    }

    /// With `decimals` places behind the point.
    fn fixed(&self, decimals: usize) -> String {
        let mut text: String = (0..=self.exponent.max(0)).rev().map(|k| self.at(k)).collect();
        if decimals > 0 {
            text.push('.');
            text.extend((1..=decimals).map(|k| self.at(-(k as i32))));
        }
        text
    }

    /// With one digit before the point and `decimals` behind.
    fn scientific(&self, decimals: usize) -> Result<String, fmt::Error> {
        let mut text = String::from(self.at(self.exponent));
        if decimals > 0 {
            text.push('.');
            text.extend((1..=decimals).map(|k| self.at(self.exponent - k as i32)));
        }
        write!(text, "e{}", self.exponent)?;
        Ok(text)
    }
}

impl Debug for DoubleDouble {
    /// Both parts, with which the number can be made again.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "DoubleDouble({:?}, {:?})", self.hi, self.lo)
    }
}

impl Display for DoubleDouble {
    /// Up to 31 digits, or as many behind the point as asked for; very large and very small numbers with an exponent.
    ///
    /// The last digits are right for magnitudes from 10⁻⁴⁵ to 10⁴⁵; farther out the last two may not be.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.hi.is_finite() || self.hi == 0.0 {
            return Display::fmt(&self.hi, f);
        }
        let x = abs(*self);
        let text = match f.precision() {
            Some(decimals) => Decimal::of(x, DIGITS, Some(decimals)).fixed(decimals),
            None => {
                let decimal = Decimal::of(x, DIGITS, None).trimmed();
                let last = decimal.length as i32 - 1 - decimal.exponent;
                if (-7..DIGITS as i32).contains(&decimal.exponent) {
                    decimal.fixed(last.max(0) as usize)
                } else {
                    decimal.scientific(decimal.length - 1)?
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
        let x = abs(*self);
        let text = match f.precision() {
            Some(decimals) => Decimal::of(x, decimals.saturating_add(1), None).scientific(decimals)?,
            None => {
                let decimal = Decimal::of(x, DIGITS, None).trimmed();
                decimal.scientific(decimal.length - 1)?
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

    /// Whatever `f64` reads, with all its digits: within 2⁻¹⁰³ for up to 31 digits and exponents to ±45.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        // The grammar is that of `f64`; what is not finite there is not here.
        let plain: f64 = text.parse().map_err(|_| ParseDoubleDoubleError)?;
        if !plain.is_finite() || plain == 0.0 {
            return Ok(plain.into());
        }
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let mut exponent: i32 = exponent.parse().map_err(|_| ParseDoubleDoubleError)?;
        let (mut value, mut significant, mut behind) = (DoubleDouble::pair(0.0, 0.0), 0, false);
        for c in mantissa.chars() {
            let Some(digit) = c.to_digit(10) else {
                behind |= c == '.';
                continue;
            };
            if significant > DIGITS + 1 {
                exponent += i32::from(!behind);
                continue;
            }
            value = (value * TEN).plus(f64::from(digit));
            significant += usize::from(digit > 0 || significant > 0);
            exponent -= i32::from(behind);
        }
        let value = shifted(value, exponent);
        Ok(if mantissa.starts_with('-') { -value } else { value })
    }
}
