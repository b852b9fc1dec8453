//! Any two bodies: dense, through nalgebra.

use nalgebra::DMatrix;

use super::series::{SMALL, Series};
use super::{Kind, felt, in_no_pivot, leads, opposite};
use crate::scene::vectors::Vectors;

/// J as a matrix of all coordinates (column after column, as in [`Vectors`]), and what solves with 1 + g J.
///
/// In general these are LU factors, made in place by elimination with exchange of rows: nalgebra's own `LU` takes a new
/// matrix each time. With many coordinates and a small g J the power series is faster.
#[derive(Clone, Debug)]
pub struct DenseMatrix<const D: usize> {
    bodies: usize,
    jacobian: DMatrix<f64>,
    /// L below the diagonal, U on it and above.
    factors: DMatrix<f64>,
    /// Row i was exchanged with row `pivots[i]` ≥ i, one after another.
    pivots: Vec<usize>,
    /// Solve by the power series: `factors` is then −g J.
    small: bool,
    series: Series,
    /// No rows were exchanged and all pivots are positive, or there are none.
    positive: bool,
    /// The determinant is negative.
    negative: bool,
}

/// The number of coordinates from which the series is looked at.
const MANY: usize = 30;

/// How small g J must be for n coordinates. Elimination takes the time of about n/3 products with J (measured: 10 for 39
/// coordinates, 105 for 300), two solves by the series that of 2 log ε / log ‖g J‖.
fn limit(n: usize) -> f64 {
    SMALL.min((6.0 * f64::EPSILON.ln() / n as f64).exp())
}

impl<const D: usize> DenseMatrix<D> {
    pub(super) fn new(bodies: usize) -> Self {
        let n = D * bodies;
        let zeros = DMatrix::zeros(n, n);
        DenseMatrix {
            bodies,
            jacobian: zeros.clone(),
            factors: zeros,
            pivots: vec![0; n],
            small: false,
            series: Series::new(n),
            positive: true,
            negative: false,
        }
    }

    pub(super) fn clear(&mut self) {
        self.jacobian.as_mut_slice().fill(0.0);
    }

    #[inline(always)]
    pub(super) fn add_block(&mut self, a: usize, b: usize, block: [[f64; D]; D]) {
        let n = self.bodies;
        for k in 0..D {
            for l in 0..D {
                self.jacobian[(k * n + a, l * n + b)] += block[k][l];
            }
        }
    }

    pub(super) fn multiply_add(&self, x: &[f64], y: &mut [f64]) {
        multiply_add(&self.jacobian, x, y);
    }

    pub(super) fn add_row_sums(&self, rows: &mut [f64]) {
        add_row_sums(&self.jacobian, rows);
    }

    pub(super) fn factorise(&mut self, g: &Vectors<D>, must_be: Kind) -> bool {
        let n = self.jacobian.nrows();
        self.small = n >= MANY && self.series.ends(g, limit(n), |rows| add_row_sums(&self.jacobian, rows));
        let sign = if self.small { -1.0 } else { 1.0 };
        // Slices: the iterators of a matrix's columns keep count of strides.
        let columns = self.factors.as_mut_slice().chunks_exact_mut(n.max(1));
        for ((i, column), known) in columns.enumerate().zip(self.jacobian.as_slice().chunks_exact(n.max(1))) {
            for ((x, j), g) in column.iter_mut().zip(known).zip(g.flat()) {
                *x = sign * g * j;
            }
            if !self.small {
                column[i] += 1.0;
            }
        }
        (self.positive, self.negative) = (true, false);
        self.small || self.eliminate(must_be)
    }

    pub(super) fn is_positive(&self) -> bool {
        self.positive
    }

    /// As [`Matrix::continues`](super::Matrix::continues): the determinant is that of the factors, and a symmetric matrix is eliminated
    /// once more.
    pub(super) fn continues(&self, g: &Vectors<D>) -> bool {
        if self.positive || self.negative || self.leads(g) || !self.is_symmetric() {
            return !self.negative;
        }
        self.clone().factorise(g, Kind::Definite)
    }

    /// Whether each diagonal entry of 1 + g J leads its row.
    fn leads(&self, g: &Vectors<D>) -> bool {
        let mut sums = vec![0.0; self.pivots.len()];
        add_row_sums(&self.jacobian, &mut sums);
        let diagonal = self.jacobian.as_slice().iter().step_by(sums.len() + 1);
        leads(diagonal.copied(), &sums, g.flat())
    }

    fn is_symmetric(&self) -> bool {
        let j = &self.jacobian;
        let entries = (0..j.ncols()).flat_map(|b| (0..j.nrows()).map(move |a| (a, b, j[(a, b)])));
        let felt = felt(self.bodies, entries);
        let alike = |a, b| {
            let pair = [j[(a, b)], j[(b, a)]];
            opposite(pair, [j[(a, a)], j[(b, b)]]) || in_no_pivot([a, b], pair, &felt)
        };
        (0..j.nrows()).all(|a| (0..a).all(|b| alike(a, b)))
    }

    /// Factorises with exchange of rows, which a definite matrix does not need; `false` if a pivot is zero, or there not positive.
    fn eliminate(&mut self, must_be: Kind) -> bool {
        let n = self.factors.nrows();
        let mut regular = true;
        for i in 0..n {
            let pivot = match must_be {
                Kind::Regular => i + self.factors.view_range(i.., i).iamax(),
                Kind::Definite => i,
            };
            self.pivots[i] = pivot;
            self.factors.swap_rows(i, pivot);
            let diagonal = self.factors[(i, i)];
            regular &= match must_be {
                Kind::Regular => diagonal != 0.0,
                Kind::Definite => diagonal > 0.0,
            };
            self.positive &= pivot == i && diagonal > 0.0;
            self.negative ^= (pivot == i) == (diagonal < 0.0);
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

    pub(super) fn solve(&mut self, x: &mut [f64]) {
        if self.small {
            self.series.solve(x, |x, y| multiply_add(&self.factors, x, y));
        } else {
            self.substitute(x);
        }
    }

    /// By the factors.
    fn substitute(&self, x: &mut [f64]) {
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

/// Σ |M| over each row, added to `rows`.
fn add_row_sums(matrix: &DMatrix<f64>, rows: &mut [f64]) {
    for column in matrix.as_slice().chunks_exact(rows.len().max(1)) {
        rows.iter_mut().zip(column).for_each(|(row, m)| *row += m.abs());
    }
}

/// y += M x.
fn multiply_add(matrix: &DMatrix<f64>, x: &[f64], y: &mut [f64]) {
    for (&x, column) in x.iter().zip(matrix.as_slice().chunks_exact(y.len().max(1))) {
        for (y, m) in y.iter_mut().zip(column) {
            *y += m * x;
        }
    }
}
