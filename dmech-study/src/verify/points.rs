//! Where to look: points around the start.

use core::array::from_fn;

use dmech_core::Potential;

use dmech_core::extend::vector::{dot, finite};

/// |x|.
pub(super) fn norm<const D: usize>(x: [f64; D]) -> f64 {
    dot(x, x).sqrt()
}

/// The point with x for its coordinate j.
pub(super) fn with<const D: usize>(mut q: [f64; D], j: usize, x: f64) -> [f64; D] {
    q[j] = x;
    q
}

/// Reproducible numbers in (−1, 1): G. Marsaglia, J. Stat. Softw. 8 (2003) no. 14.
pub(super) struct Dice(u64);

impl Dice {
    pub(super) fn new() -> Self {
        Dice(0x9e37_79b9_7f4a_7c15)
    }

    fn throw(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// A point in the cube of half-width `radius` around q, by the coordinates that move.
    pub(super) fn near<const D: usize>(&mut self, q: [f64; D], moves: [bool; D], radius: f64) -> [f64; D] {
        from_fn(|i| if moves[i] { q[i] + radius * self.throw() } else { q[i] })
    }
}

/// The start and points around it where the potential is finite.
pub(super) fn around<P: Potential<D>, const D: usize>(
    field: &P,
    q: [f64; D],
    moves: [bool; D],
    length: f64,
) -> Vec<[f64; D]> {
    let mut dice = Dice::new();
    let near = (0..12).map(|_| dice.near(q, moves, 0.15 * length));
    core::iter::once(q).chain(near).filter(|q| finite(*q) && field.potential(*q).is_finite()).collect()
}
