//! Where to look: scales of length and time from the start, and points around it.

use core::array::from_fn;

use crate::law::{Field, Law, Potential};
use crate::state::State;
use crate::system::vector::{dot, finite};

/// The mass that all checks use, and a length and a time that are typical of the start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales {
    pub(crate) mass: f64,
    pub(crate) length: f64,
    pub(crate) time: f64,
}

impl Scales {
    /// The length is |q|∞ (1 at the origin); the time is the shortest of length/|v|, √(length/|a|) and 1/√‖∂a/∂q‖.
    pub(crate) fn new<L: Law<D>, const D: usize>(law: &L, start: &State<D>, mass: f64) -> Self {
        let positive = |x: &f64| *x > 0.0 && x.is_finite();
        let length = Some(largest(&start.q)).filter(positive).unwrap_or(1.0);
        let field = law.field(mass, start.t);
        let acceleration = largest(&field.slope(start.q, start.v)) / mass;
        let stiffness = field.hessian(start.q).iter().map(largest).fold(0.0, f64::max) / mass;
        let times = [length / largest(&start.v), (length / acceleration).sqrt(), stiffness.sqrt().recip()];
        let time = times.into_iter().filter(positive).fold(f64::INFINITY, f64::min);
        Scales { mass, length, time: if time.is_finite() { time } else { 1.0 } }
    }
}

/// max |xᵢ|.
pub(super) fn largest<const D: usize>(x: &[f64; D]) -> f64 {
    x.iter().map(|x| x.abs()).fold(0.0, f64::max)
}

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

    /// A point in the cube of half-width `radius` around q.
    pub(super) fn near<const D: usize>(&mut self, q: [f64; D], radius: f64) -> [f64; D] {
        from_fn(|i| q[i] + radius * self.throw())
    }
}

/// The start and points around it where the potential is finite.
pub(super) fn around<P: Potential<D>, const D: usize>(field: &P, q: [f64; D], length: f64) -> Vec<[f64; D]> {
    let mut dice = Dice::new();
    let near = (0..12).map(|_| dice.near(q, 0.15 * length));
    core::iter::once(q).chain(near).filter(|q| finite(*q) && field.potential(*q).is_finite()).collect()
}
