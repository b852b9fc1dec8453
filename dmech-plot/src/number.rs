//! Numbers in words and at axes.

use core::fmt::Display;

/// A number as it is printed: −2.5, 3·10⁻⁸.
///
/// ```
/// use dmech_plot::number;
///
/// assert_eq!([-2.5, 3e-8, 1e20, 12345.0, f64::NAN].map(number), ["−2.5", "3·10⁻⁸", "10²⁰", "12345", "NaN"]);
/// ```
pub fn number(x: f64) -> String {
    let plain = x == 0.0 || !x.is_finite() || (1e-3..1e6).contains(&x.abs());
    let text = if plain { format!("{x}") } else { format!("{x:e}") };
    let text = match text.split_once('e') {
        Some((mantissa, exponent)) => {
            let power = power("10", exponent);
            match mantissa {
                "1" => power,
                "-1" => format!("-{power}"),
                mantissa => format!("{mantissa}·{power}"),
            }
        }
        None => text,
    };
    text.replace('-', "−")
}

/// The same with so many digits.
pub fn rough(x: f64, digits: usize) -> String {
    let x: f64 = format!("{x:.*e}", digits.saturating_sub(1)).parse().unwrap_or(x);
    number(x)
}

/// From one number to another, with six digits, or with what is added where these do not tell them apart.
///
/// ```
/// use dmech_plot::span;
///
/// assert_eq!([[0.0, 2.5], [1e9, 1e9 + 10.0]].map(span), ["0 … 2.5", "10⁹ … 10⁹ + 10"]);
/// ```
pub fn span([from, to]: [f64; 2]) -> String {
    let [first, last] = [from, to].map(|x| rough(x, 6));
    let alike = first == last && from != to;
    if alike { format!("{first} … {last} + {}", rough(to - from, 6)) } else { format!("{first} … {last}") }
}

/// A whole number in groups of three digits.
pub fn count(n: u64) -> String {
    let digits = n.to_string();
    let grouped = |(i, digit): (usize, char)| {
        let gap = i > 0 && digits.len() > 4 && (digits.len() - i).is_multiple_of(3);
        gap.then_some('\u{202f}').into_iter().chain([digit])
    };
    digits.chars().enumerate().flat_map(grouped).collect()
}

/// A power as it is printed.
///
/// ```
/// use dmech_plot::power;
///
/// assert_eq!([power("10", 1.5), power("n", -2)], ["10¹·⁵", "n⁻²"]);
/// ```
pub fn power(base: &str, exponent: impl Display) -> String {
    let digit = |digit: char| match digit {
        '-' => '⁻',
        '.' => '·',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    let exponent = exponent.to_string();
    base.chars().chain(exponent.chars().map(digit)).collect()
}
