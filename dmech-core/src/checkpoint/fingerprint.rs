//! A fingerprint of what acts.

use core::fmt;

use dmech_scalar::Exact;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::Saved;
use crate::fnv::Fnv;

/// A hash of numbers by their bits, the same on every machine.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Fingerprint(Fnv);

impl Fingerprint {
    pub(crate) fn new() -> Self {
        Fingerprint(Fnv::NOTHING)
    }

    /// Of what acts at a place, and where position and velocity are displaced.
    pub(crate) fn of<Y: Saved>(system: &Y, t: f64, mut place: [Y::Vector; 2]) -> Self {
        let mut fingerprint = Fingerprint::new();
        for probe in 0..2 {
            if probe == 1 {
                place.iter_mut().for_each(|x| displaced(Y::numbers(x)));
            }
            system.sample(t, &place, &mut |numbers| {
                numbers.iter().for_each(|x| x.parts(&mut |part| fingerprint.add(part)));
            });
        }
        fingerprint
    }

    /// Takes in one more number. All NaN are one: their bits may differ from build to build.
    pub(crate) fn add(&mut self, x: f64) {
        let x = if x.is_nan() { f64::NAN } else { x };
        self.add_bits(x.to_bits());
    }

    /// Takes in a whole number.
    pub(super) fn add_bits(&mut self, bits: u64) {
        self.0.word(bits);
    }

    /// Takes in a text, and where it ends.
    pub(super) fn add_text(&mut self, text: &str) {
        self.add_bits(text.len() as u64);
        self.0.bytes(text.as_bytes());
    }

    /// Takes in a list, and where it ends.
    pub(super) fn add_list(&mut self, numbers: &[f64]) {
        self.add_bits(numbers.len() as u64);
        self.add_all(numbers);
    }

    /// The hash itself.
    pub(crate) fn bits(self) -> u64 {
        self.0.0
    }

    fn add_all(&mut self, numbers: &[f64]) {
        numbers.iter().for_each(|&x| self.add(x));
    }
}

/// Numbers moved off by up to about a quarter of the largest, each by another part of it: where nothing is zero by symmetry, or
/// because all is at rest. Without functions whose last bit is not the same everywhere.
fn displaced<R: Exact>(numbers: &mut [R]) {
    let largest = numbers.iter().fold(0.0, |max: f64, x| max.max(x.to_f64().abs()));
    let size = if largest > 0.0 { largest } else { 1.0 };
    for (i, x) in numbers.iter_mut().enumerate() {
        let part = ((i % 1009) * 389 % 1009) as f64 / 1009.0;
        *x += R::from_f64(0.5 * size * (part - 0.47));
    }
}

impl fmt::Debug for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.bits())
    }
}

impl Serialize for Fingerprint {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&format_args!("{self:?}"))
    }
}

impl<'de> Deserialize<'de> for Fingerprint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let bits = u64::from_str_radix(&text, 16);
        bits.map(Fnv).map(Fingerprint).map_err(|_| D::Error::custom(format_args!("`{text}` is not a fingerprint")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_fnv_1a() {
        // The bytes of the number spell "foobar\0\0"; the value comes from the definition, byte by byte.
        let mut fingerprint = Fingerprint::new();
        fingerprint.add(f64::from_bits(u64::from_le_bytes(*b"foobar\0\0")));
        let mut expected: u128 = 14_695_981_039_346_656_037;
        for byte in b"foobar\0\0" {
            expected = (expected ^ u128::from(*byte)) * 1_099_511_628_211 % (1 << 64);
        }
        assert_eq!(u128::from(fingerprint.bits()), expected);
    }

    #[test]
    fn displaced_numbers_differ_from_each_other_and_from_zero() {
        let mut numbers = [0.0_f64; 400];
        displaced(&mut numbers);
        assert!(numbers.iter().all(|&x| x != 0.0 && x.abs() < 0.27));
        let mut sorted = numbers;
        sorted.sort_by(f64::total_cmp);
        assert!(sorted.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
