//! What states are made of.

use dmech_scalar::Real;

/// A state of some bodies, told by its numbers: what is done with states of one law and of a scene alike is written with it, once.
pub trait Snapshot: Clone + Send {
    /// The numbers of positions and velocities.
    type Scalar: Real;

    /// Coordinates of a body.
    const DIMENSION: usize;
    /// How many bodies there are is known when it runs; else there is one.
    const LISTED: bool;

    /// Its time.
    fn time(&self) -> f64;

    /// Positions and velocities, one body after another. Of a state that is refused one may be longer.
    fn lists(&self) -> [&[Self::Scalar]; 2];

    /// The state of so many bodies whose positions (list 0) and velocities (1) have these numbers at their places.
    fn from_numbers(time: f64, bodies: usize, number: impl FnMut(usize, usize) -> Self::Scalar) -> Self;

    /// That of list 0 or 1 at a place; NaN where it is too short.
    fn number(&self, list: usize, place: usize) -> Self::Scalar {
        self.lists()[list].get(place).copied().unwrap_or(Self::Scalar::from_f64(f64::NAN))
    }

    /// How many bodies it has.
    fn bodies(&self) -> usize {
        let most = self.lists().map(<[_]>::len).into_iter().max();
        if Self::LISTED { most.and_then(|most| most.checked_div(Self::DIMENSION)).unwrap_or(0) } else { 1 }
    }
}
