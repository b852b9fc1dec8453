//! Any two bodies: dense, through nalgebra.

use nalgebra::{DMatrix, DVector, Dyn, LU};

use crate::scene::vectors::Vectors;

/// J as a matrix of all coordinates (column after column, as in [`Vectors`]), and the LU factors of 1 + g J.
#[derive(Clone, Debug)]
pub struct DenseMatrix<const D: usize> {
    bodies: usize,
    jacobian: DMatrix<f64>,
    factors: Option<LU<f64, Dyn, Dyn>>,
    side: DVector<f64>,
}

impl<const D: usize> DenseMatrix<D> {
    pub(super) fn new(bodies: usize) -> Self {
        let n = D * bodies;
        DenseMatrix { bodies, jacobian: DMatrix::zeros(n, n), factors: None, side: DVector::zeros(n) }
    }

    pub(super) fn clear(&mut self) {
        self.jacobian.fill(0.0);
    }

    #[inline]
    pub(super) fn add_block(&mut self, a: usize, b: usize, block: [[f64; D]; D]) {
        let n = self.bodies;
        for k in 0..D {
            for l in 0..D {
                self.jacobian[(k * n + a, l * n + b)] += block[k][l];
            }
        }
    }

    pub(super) fn multiply_add(&self, x: &Vectors<D>, y: &mut Vectors<D>) {
        let rows = self.jacobian.nrows();
        let flat = y.flat_mut();
        for (&x, column) in x.flat().iter().zip(self.jacobian.as_slice().chunks_exact(rows.max(1))) {
            for (y, j) in flat.iter_mut().zip(column) {
                *y += j * x;
            }
        }
    }

    pub(super) fn factorise(&mut self, g: &Vectors<D>) -> bool {
        let n = self.jacobian.nrows();
        let mut matrix = self.jacobian.clone();
        for mut column in matrix.column_iter_mut() {
            for (x, &g) in column.iter_mut().zip(g.flat()) {
                *x *= g;
            }
        }
        for i in 0..n {
            matrix[(i, i)] += 1.0;
        }
        let factors = self.factors.insert(LU::new(matrix));
        factors.is_invertible()
    }

    pub(super) fn solve(&mut self, x: &mut Vectors<D>) {
        let Some(factors) = &self.factors else { return };
        self.side.copy_from_slice(x.flat());
        if factors.solve_mut(&mut self.side) {
            x.flat_mut().copy_from_slice(self.side.as_slice());
        } else {
            x.flat_mut().fill(f64::NAN);
        }
    }
}
