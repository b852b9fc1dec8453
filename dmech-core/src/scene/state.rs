//! The state of a scene.

use dmech_scalar::Compensated;

use crate::snapshot::Snapshot;

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

impl<const D: usize> Snapshot for SceneState<D> {
    type Scalar = f64;

    const DIMENSION: usize = D;
    const LISTED: bool = true;

    fn time(&self) -> f64 {
        self.t
    }

    fn lists(&self) -> [&[f64]; 2] {
        [self.q.as_flattened(), self.v.as_flattened()]
    }

    fn from_numbers(time: f64, bodies: usize, mut number: impl FnMut(usize, usize) -> f64) -> Self {
        let mut all = |list| {
            (0..bodies).map(|body| core::array::from_fn(|k| number(list, body * D + k))).collect::<Vec<[f64; D]>>()
        };
        SceneState { t: time, q: all(0), v: all(1) }
    }
}
