//! Numbers as text that reads back as the same numbers.

use core::fmt::Write;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::error::Difference;

/// A list of `f64`, written as one text with spaces between.
#[derive(Clone, Debug)]
pub(crate) struct Digits(pub(crate) Vec<f64>);

/// Equal to the bit.
impl PartialEq for Digits {
    fn eq(&self, other: &Self) -> bool {
        self.0.iter().map(|x| x.to_bits()).eq(other.0.iter().map(|x| x.to_bits()))
    }
}

impl Digits {
    /// Copies the numbers to where as many belong.
    pub(crate) fn copy_to(&self, place: &mut [f64]) -> Result<(), Difference> {
        if place.len() != self.0.len() {
            return Err(Difference::Damaged { found: self.0.len(), expected: place.len() });
        }
        place.copy_from_slice(&self.0);
        Ok(())
    }

    /// Whether the lists that were saved have the lengths of those here.
    pub(super) fn fit<'a>(
        saved: impl IntoIterator<Item = &'a Digits>,
        here: impl IntoIterator<Item = &'a Digits>,
    ) -> Result<(), Difference> {
        let lengths = |lists: &mut dyn Iterator<Item = &'a Digits>| lists.map(|x| x.0.len()).collect::<Vec<_>>();
        let (saved, here) = (lengths(&mut saved.into_iter()), lengths(&mut here.into_iter()));
        if saved.len() != here.len() {
            return Err(Difference::Damaged { found: saved.len(), expected: here.len() });
        }
        let wrong = saved.into_iter().zip(here).find(|(saved, here)| saved != here);
        wrong.map_or(Ok(()), |(found, expected)| Err(Difference::Damaged { found, expected }))
    }
}

impl Serialize for Digits {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut text = String::with_capacity(20 * self.0.len());
        for (i, x) in self.0.iter().enumerate() {
            // Writing to a string does not fail. The shortest text that reads back as x.
            let _ = write!(text, "{}{x:?}", if i == 0 { "" } else { " " });
        }
        serializer.serialize_str(&text)
    }
}

impl<'de> Deserialize<'de> for Digits {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let read = |word: &str| match word.parse() {
            Ok(x) if f64::is_finite(x) => Ok(x),
            _ => Err(D::Error::custom(format_args!("`{word}` is not a finite number"))),
        };
        text.split_ascii_whitespace().map(read).collect::<Result<_, _>>().map(Digits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_number_survives_json(bits: Vec<u64>) {
            let numbers = Digits(bits.into_iter().map(f64::from_bits).filter(|x| x.is_finite()).collect());
            let text = serde_json::to_string(&numbers).unwrap();
            prop_assert_eq!(&serde_json::from_str::<Digits>(&text).unwrap(), &numbers);
        }
    }

    #[test]
    fn edges_survive_and_words_do_not() {
        let smallest = f64::from_bits(1);
        let numbers = Digits(vec![0.0, -0.0, smallest, -f64::MIN_POSITIVE, f64::MAX, 0.1, 1e300]);
        let text = serde_json::to_string(&numbers).unwrap();
        let read: Digits = serde_json::from_str(&text).unwrap();
        assert_eq!(read, numbers);
        assert_ne!(Digits(vec![0.0]), Digits(vec![-0.0]));
        for word in ["x", "NaN", "inf", "1e999"] {
            let error = serde_json::from_str::<Digits>(&format!("\"1.5 {word} 2\"")).unwrap_err().to_string();
            assert!(error.starts_with(&format!("`{word}` is not a finite number")), "{error}");
        }
    }
}
