//! States as lists of numbers.

/// A state as a list of numbers: its time, then position and velocity of one body after another.
pub trait Flat: Clone + Send {
    /// Coordinates of a body.
    const DIMENSION: usize;
    /// How many bodies there are is known when it runs; else there is one.
    const LISTED: bool;

    /// All numbers.
    fn flat(&self) -> Vec<f64>;

    /// The state of these numbers.
    fn of_flat(numbers: &[f64]) -> Self;
}
