//! The numbers that make a law what it is.

use serde::{Deserialize, Serialize};

use super::Fingerprint;
use crate::error::Difference;

/// A fingerprint of every field that the laws read, by name, and of what they read of the bodies.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Fingerprints<N = String>(Vec<(N, Fingerprint)>);

impl Fingerprints<&'static str> {
    pub(crate) fn new() -> Self {
        Fingerprints(Vec::new())
    }

    /// Takes in one more number; those of one name in a row have one fingerprint.
    pub(crate) fn see(&mut self, name: &'static str, x: f64) {
        match self.0.last_mut() {
            Some((last, fingerprint)) if *last == name => fingerprint.add(x),
            _ => {
                let mut fingerprint = Fingerprint::new();
                fingerprint.add(x);
                self.0.push((name, fingerprint));
            }
        }
    }

    /// As they are saved.
    pub(crate) fn saved(&self) -> Fingerprints {
        Fingerprints(self.0.iter().map(|&(name, fingerprint)| (name.to_owned(), fingerprint)).collect())
    }

    /// The first that differs from what was saved.
    pub(crate) fn compare(&self, saved: &Fingerprints) -> Result<(), Difference> {
        if saved.0.iter().map(|(name, _)| name.as_str()).ne(self.0.iter().map(|&(name, _)| name)) {
            return Err(Difference::Laws);
        }
        let other = self.0.iter().zip(&saved.0).find(|((_, here), (_, saved))| here != saved);
        other.map_or(Ok(()), |(&(name, _), _)| Err(Difference::Field { name }))
    }
}

impl Fingerprints {
    /// Takes all in.
    pub(super) fn add_to(&self, fingerprint: &mut Fingerprint) {
        for (name, field) in &self.0 {
            fingerprint.add_text(name);
            fingerprint.add_bits(field.bits());
        }
    }
}
