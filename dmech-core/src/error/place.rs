//! Places in messages.

use crate::text::Number;

/// A position as a message shows it: three coordinates at most, and how many there are.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Place {
    first: [f64; 3],
    coordinates: usize,
}

impl Place {
    pub(crate) fn new(q: &[f64]) -> Self {
        let first = core::array::from_fn(|i| q.get(i).copied().unwrap_or(0.0));
        Place { first, coordinates: q.len() }
    }

    /// The coordinates, three at most.
    pub fn first(&self) -> &[f64] {
        &self.first[..self.coordinates.min(3)]
    }
}

impl core::fmt::Display for Place {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        if let [x] = *self.first() {
            return Number(x).fmt(f);
        }
        let shown: Vec<_> = self.first().iter().map(|&x| Number(x).to_string()).collect();
        write!(f, "[{}{}]", shown.join(", "), if self.coordinates > 3 { ", …" } else { "" })
    }
}
