//! States as lists of numbers.

use dmech_scalar::Exact;

/// A state as a list of numbers: its time, then position and velocity of one body after another, each number by its
/// [parts](Exact::parts).
pub trait Flat: Clone + Send {
    /// The numbers of positions and velocities.
    type Scalar: Exact;

    /// Coordinates of a body.
    const DIMENSION: usize;
    /// How many bodies there are is known when it runs; else there is one.
    const LISTED: bool;
    /// How much of the list a body takes.
    const BODY: usize = 2 * Self::DIMENSION * Self::Scalar::PARTS;

    /// All numbers.
    fn flat(&self) -> Vec<f64>;

    /// The state of these numbers.
    fn of_flat(numbers: &[f64]) -> Self;
}
