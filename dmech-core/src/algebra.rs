//! States, gradients and Hessians as vectors and matrices of nalgebra (feature `nalgebra`).

use nalgebra::{SMatrix, SVector, Scalar};

use crate::law::Potential;
use crate::state::State;

impl<const D: usize, R: Scalar + Copy> State<D, R> {
    /// Position and velocity at t = 0 (feature `nalgebra`).
    pub fn of_vectors(q: SVector<R, D>, v: SVector<R, D>) -> Self {
        State::of(q.into(), v.into())
    }

    /// The position as a vector (feature `nalgebra`).
    pub fn position(&self) -> SVector<R, D> {
        self.q.into()
    }

    /// The velocity as a vector (feature `nalgebra`).
    pub fn velocity(&self) -> SVector<R, D> {
        self.v.into()
    }
}

#[cfg(feature = "scene")]
impl<const D: usize> crate::scene::SceneState<D> {
    /// The positions as vectors, in the order of the bodies (feature `nalgebra`).
    pub fn positions(&self) -> impl ExactSizeIterator<Item = SVector<f64, D>> {
        self.q.iter().map(|&q| q.into())
    }

    /// The velocities likewise (feature `nalgebra`).
    pub fn velocities(&self) -> impl ExactSizeIterator<Item = SVector<f64, D>> {
        self.v.iter().map(|&v| v.into())
    }
}

/// The functions of a [`Potential`] over vectors of nalgebra (feature `nalgebra`), for every potential.
///
/// ```
/// use dmech_core::extend::OfVectors;
/// use dmech_core::prelude::*;
/// use nalgebra::{Matrix1, Vector1};
/// # #[derive(Clone, Copy)]
/// # struct Quartic { k: f64 }
/// # impl Potential<1> for Quartic {
/// #     fn potential(&self, [x]: [f64; 1]) -> f64 { 0.25 * self.k * x.powi(4) }
/// #     fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] { [self.k * x.powi(3)] }
/// #     fn hessian(&self, [x]: [f64; 1]) -> [[f64; 1]; 1] { [[3.0 * self.k * x * x]] }
/// #     fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] { [0.25 * self.k * (a + b) * (a * a + b * b)] }
/// #     fn discrete_gradient_jacobian(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
/// #         [[0.25 * self.k * (a * a + 2.0 * a * b + 3.0 * b * b)]]
/// #     }
/// # }
/// let law = Quartic { k: 2.0 };
/// assert_eq!(law.gradient_at(Vector1::new(0.5)), Vector1::new(0.25));
/// assert_eq!(law.hessian_at(Vector1::new(0.5)), Matrix1::new(1.5));
/// ```
pub trait OfVectors<const D: usize>: Potential<D> {
    /// ∇Φ(q).
    fn gradient_at(&self, q: SVector<f64, D>) -> SVector<f64, D> {
        self.gradient(q.into()).into()
    }

    /// ∂²Φ/∂qᵢ∂qⱼ at q.
    fn hessian_at(&self, q: SVector<f64, D>) -> SMatrix<f64, D, D> {
        matrix(self.hessian(q.into()))
    }

    /// ∇̄Φ(a, b).
    fn discrete_gradient_at(&self, a: SVector<f64, D>, b: SVector<f64, D>) -> SVector<f64, D> {
        self.discrete_gradient(a.into(), b.into()).into()
    }

    /// ∂∇̄Φ(a, b)ᵢ/∂bⱼ in row i and column j.
    fn discrete_gradient_jacobian_at(&self, a: SVector<f64, D>, b: SVector<f64, D>) -> SMatrix<f64, D, D> {
        matrix(self.discrete_gradient_jacobian(a.into(), b.into()))
    }
}

impl<P: Potential<D>, const D: usize> OfVectors<D> for P {}

/// Rows as a matrix: nalgebra takes an array for the columns.
fn matrix<const D: usize>(rows: [[f64; D]; D]) -> SMatrix<f64, D, D> {
    SMatrix::from_fn(|i, j| rows[i][j])
}
