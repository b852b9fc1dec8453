//! The state of a scene.

use std::io::{self, Write};

use dmech_scalar::Compensated;

use crate::run::{Blend, Columns, Weights, nudge};

/// Time, positions and velocities of the bodies of a scene, in the order in which they were added.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SceneState<const D: usize> {
    /// Time.
    pub t: f64,
    /// Positions.
    #[cfg_attr(feature = "serde", serde(with = "crate::components::list"))]
    pub q: Vec<[f64; D]>,
    /// Velocities.
    #[cfg_attr(feature = "serde", serde(with = "crate::components::list"))]
    pub v: Vec<[f64; D]>,
}

impl<const D: usize> SceneState<D> {
    /// The same positions with all velocities turned round: where a reversible motion goes back from.
    #[must_use = "the state that is turned round is the one that comes back"]
    pub fn reversed(mut self) -> Self {
        for v in &mut self.v {
            *v = v.map(|v| -v);
        }
        self
    }
}

impl<const D: usize> SceneState<D> {
    /// Σ m v.
    pub(super) fn linear_momentum(&self, masses: &[f64]) -> Vec<f64> {
        (0..D).map(|k| sum(masses.iter().zip(&self.v).map(|(m, v)| m * v[k]))).collect()
    }

    /// Σ m (q_k v_l − q_l v_k), k < l.
    pub(super) fn angular_momentum(&self, masses: &[f64]) -> Vec<f64> {
        let components = (0..D).flat_map(|k| (k + 1..D).map(move |l| (k, l)));
        let bodies = || masses.iter().zip(self.q.iter().zip(&self.v));
        components.map(|(k, l)| sum(bodies().map(|(m, (q, v))| m * (q[k] * v[l] - q[l] * v[k])))).collect()
    }
}

/// A sum whose rounding does not grow with the number of bodies: it would show as a drift that is none.
fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    let mut sum = Compensated::new(0.0);
    terms.for_each(|term| sum.add(term));
    sum.value()
}

impl<const D: usize> Blend for SceneState<D> {
    fn time(&self) -> f64 {
        self.t
    }

    fn blend(time: f64, states: &[Self], weights: &[Weights]) -> Self {
        let zero = || states.first().map_or(Vec::new(), |state| vec![[0.0; D]; state.q.len()]);
        let mut sum = SceneState { t: time, q: zero(), v: zero() };
        for (state, &Weights { position: [a, b], velocity: [c, d] }) in states.iter().zip(weights) {
            for (i, (q, v)) in state.q.iter().zip(&state.v).enumerate() {
                for k in 0..D {
                    sum.q[i][k] += a * q[k] + b * v[k];
                    sum.v[i][k] += c * q[k] + d * v[k];
                }
            }
        }
        sum
    }

    fn apart(&self, other: &Self) -> f64 {
        let pairs = self.q.iter().flatten().zip(other.q.iter().flatten());
        pairs.fold(0.0, |most, (x, y)| most.max((x - y).abs()))
    }

    fn numbers(&self) -> usize {
        1 + 2 * D * self.q.len()
    }

    fn nudged(&self, up: &dyn Fn(usize) -> bool) -> Self {
        let all = |vectors: &[[f64; D]], first: usize| {
            let place = |i: usize, k: usize| first + i * D + k;
            let each = |(i, x): (usize, &[f64; D])| core::array::from_fn(|k| nudge(x[k], up(place(i, k))));
            vectors.iter().enumerate().map(each).collect()
        };
        SceneState { t: nudge(self.t, up(0)), q: all(&self.q, 1), v: all(&self.v, 1 + D * self.q.len()) }
    }
}

/// The columns are `t`, then `q3_0` for component 0 of the position of body 3, and `v3_0` for that of its velocity.
impl<const D: usize> Columns for SceneState<D> {
    fn write_names(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "t")?;
        for (name, list) in [("q", &self.q), ("v", &self.v)] {
            for body in 0..list.len() {
                for component in 0..D {
                    write!(out, ",{name}{body}_{component}")?;
                }
            }
        }
        Ok(())
    }

    fn write_values(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "{}", self.t)?;
        for x in self.q.iter().chain(&self.v).flatten() {
            write!(out, ",{x}")?;
        }
        Ok(())
    }

    fn numbers(&self, see: &mut dyn FnMut(f64)) {
        see(self.t);
        self.q.iter().chain(&self.v).flatten().for_each(|&x| see(x));
    }
}

/// Where a list is shorter, as in a state that is refused, NaN stands in it.
#[cfg(any(feature = "ranks", feature = "store"))]
impl<const D: usize> crate::flat::Flat for SceneState<D> {
    type Scalar = f64;

    const DIMENSION: usize = D;
    const LISTED: bool = true;

    fn flat(&self) -> Vec<f64> {
        let lists = [&self.q, &self.v];
        let bodies = self.q.len().max(self.v.len());
        let body = |i: usize| lists.into_iter().flat_map(move |list| list.get(i).copied().unwrap_or([f64::NAN; D]));
        core::iter::once(self.t).chain((0..bodies).flat_map(body)).collect()
    }

    fn of_flat(numbers: &[f64]) -> Self {
        let bodies = numbers[1..].chunks_exact(2 * D);
        let list = |from: usize| bodies.clone().map(|body| core::array::from_fn(|i| body[from + i])).collect();
        SceneState { t: numbers[0], q: list(0), v: list(D) }
    }
}
