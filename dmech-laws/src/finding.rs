//! A law that fails.

use super::grow::Law;
use super::points::Place;
use super::promise::Failure;

/// A law that does not keep a promise, as small as it was found.
#[derive(Clone, Debug)]
pub struct Finding {
    /// Which of the laws it was.
    pub k: u64,
    /// The law.
    pub law: Law,
    /// How the points were chosen.
    pub place: Place,
    /// The points.
    pub ends: [Vec<f64>; 2],
    /// What was not kept.
    pub failure: Failure,
}

impl std::fmt::Display for Finding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "law {}, {:?}, {:?}:", self.k, self.failure.promise, self.place)?;
        writeln!(f, "  {} in {} coordinates", self.law.tree, self.law.dimension)?;
        writeln!(f, "  a = {:?}, b = {:?}", self.ends[0], self.ends[1])?;
        write!(f, "  {}", self.failure.words)
    }
}
