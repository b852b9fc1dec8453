//! The state of one particle.

use dmech_scalar::Real;

use crate::snapshot::Snapshot;

/// Time, position and velocity of a particle in D coordinates.
///
/// ```
/// use dmech_core::State;
///
/// let planet = State::new([0.5, 0.0], [0.0, 1.63]).at_time(2.0);
/// assert_eq!((planet.t, planet.q[0], planet.v[1]), (2.0, 0.5, 1.63));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound = "R: serde::Serialize + serde::de::DeserializeOwned"))]
pub struct State<const D: usize, R = f64> {
    /// Time.
    pub t: f64,
    /// Position.
    #[cfg_attr(feature = "serde", serde(with = "crate::components"))]
    pub q: [R; D],
    /// Velocity.
    #[cfg_attr(feature = "serde", serde(with = "crate::components"))]
    pub v: [R; D],
}

impl<const D: usize> State<D> {
    /// Position and velocity at t = 0.
    pub const fn new(q: [f64; D], v: [f64; D]) -> Self {
        State::of(q, v)
    }
}

impl<const D: usize, R> State<D, R> {
    /// Position and velocity at t = 0 in other numbers than `f64`.
    pub const fn of(q: [R; D], v: [R; D]) -> Self {
        State { t: 0.0, q, v }
    }

    /// The same position and velocity at time t.
    #[must_use = "the state itself stays as it is"]
    pub fn at_time(self, t: f64) -> Self {
        State { t, ..self }
    }
}

impl<const D: usize, R: Real> State<D, R> {
    /// The same position with the velocity turned round: where a reversible motion goes back from.
    #[must_use = "the state itself stays as it is"]
    pub fn reversed(self) -> Self {
        State { v: self.v.map(|v| -v), ..self }
    }
}

impl<const D: usize, R: Real> Snapshot for State<D, R> {
    type Scalar = R;

    const DIMENSION: usize = D;
    const LISTED: bool = false;

    fn time(&self) -> f64 {
        self.t
    }

    fn lists(&self) -> [&[R]; 2] {
        [&self.q, &self.v]
    }

    fn from_numbers(time: f64, _: usize, mut number: impl FnMut(usize, usize) -> R) -> Self {
        let [q, v] = [0, 1].map(|list| core::array::from_fn(|i| number(list, i)));
        State { t: time, q, v }
    }
}
