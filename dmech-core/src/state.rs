//! The state of one particle.

use dmech_scalar::Real;

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

#[cfg(any(feature = "ranks", feature = "store"))]
impl<const D: usize, R: dmech_scalar::Exact> crate::flat::Flat for State<D, R> {
    type Scalar = R;

    const DIMENSION: usize = D;
    const LISTED: bool = false;

    fn flat(&self) -> Vec<f64> {
        let mut numbers = Vec::with_capacity(1 + Self::BODY);
        crate::run::Columns::parts(self, &mut |x| numbers.push(x));
        numbers
    }

    fn of_flat(numbers: &[f64]) -> Self {
        let mut numbers = numbers.iter().copied();
        let mut next = || numbers.next().unwrap_or(f64::NAN);
        let t = next();
        let [q, v] = core::array::from_fn(|_| core::array::from_fn(|_| R::of_parts(&mut next)));
        State { t, q, v }
    }
}
