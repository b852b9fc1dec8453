//! Any two bodies: dense, through nalgebra.

use nalgebra::DMatrix;

use crate::scene::vectors::Vectors;

/// J as a matrix of all coordinates (column after column, as in [`Vectors`]), and the LU factors of 1 + g J.
///
/// The factors are made in place, by elimination with exchange of rows: nalgebra's own `LU` takes a new matrix each time.
#[derive(Clone, Debug)]
pub struct DenseMatrix<const D: usize> {
    bodies: usize,
    jacobian: DMatrix<f64>,
    /// L below the diagonal, U on it and above.
    factors: DMatrix<f64>,
    /// Row i was exchanged with row `pivots[i]` ≥ i, one after another.
    pivots: Vec<usize>,
}

impl<const D: usize> DenseMatrix<D> {
    pub(super) fn new(bodies: usize) -> Self {
        let n = D * bodies;
        let zeros = DMatrix::zeros(n, n);
        DenseMatrix { bodies, jacobian: zeros.clone(), factors: zeros, pivots: vec![0; n] }
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
        for ((i, mut column), known) in self.factors.column_iter_mut().enumerate().zip(self.jacobian.column_iter()) {
            for ((x, j), g) in column.iter_mut().zip(&known).zip(g.flat()) {
                *x = g * j;
            }
            column[i] += 1.0;
        }
        let mut regular = true;
        for i in 0..n {
            let pivot = i + self.factors.view_range(i.., i).iamax();
            self.pivots[i] = pivot;
            self.factors.swap_rows(i, pivot);
            let diagonal = self.factors[(i, i)];
            regular &= diagonal != 0.0;
            let (mut done, mut rest) = self.factors.columns_range_pair_mut(i, i + 1..);
            let mut multipliers = done.rows_range_mut(i + 1..);
            multipliers *= diagonal.recip();
            for mut column in rest.column_iter_mut() {
                let head = column[i];
                column.rows_range_mut(i + 1..).axpy(-head, &multipliers, 1.0);
            }
        }
        regular
    }

    pub(super) fn solve(&mut self, x: &mut Vectors<D>) {
        let x = x.flat_mut();
        for (i, &pivot) in self.pivots.iter().enumerate() {
            x.swap(i, pivot);
        }
        let rows = x.len().max(1);
        let columns = || self.factors.as_slice().chunks_exact(rows).enumerate();
        for (i, column) in columns() {
            let known = x[i];
            for (x, l) in x[i + 1..].iter_mut().zip(&column[i + 1..]) {
                *x -= l * known;
            }
        }
        for (i, column) in columns().rev() {
            x[i] /= column[i];
            let known = x[i];
            for (x, u) in x[..i].iter_mut().zip(&column[..i]) {
                *x -= u * known;
            }
        }
    }
}
