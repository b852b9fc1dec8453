//! The Newton matrix of a scene: its pattern follows from what links the bodies.

pub(super) mod block;
mod chain;
#[cfg(feature = "sparse")]
mod definite;
mod dense;
mod near;
#[cfg(feature = "sparse")]
mod orientation;
mod series;
#[cfg(feature = "sparse")]
mod sparse;

use chain::ChainMatrix;
use dense::DenseMatrix;
use near::NearMatrix;
#[cfg(feature = "sparse")]
use sparse::SparseMatrix;

use super::topology::Topology;
use super::vectors::Vectors;

/// What 1 + g J must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Not singular.
    Regular,
    /// For a symmetric J (that of links which one end does not feel may be 0 there): positive definite, which 1 + g J of a force
    /// that is linear is where it has not been singular for any shorter step.
    Definite,
}

/// Whether each diagonal entry of 1 + g J is larger than all beside it in its row together, by the diagonal of J, Σ |J| over each row
/// and g.
fn leads(diagonal: impl Iterator<Item = f64>, sums: &[f64], g: &[f64]) -> bool {
    diagonal.zip(sums).zip(g).all(|((d, sum), g)| 1.0 + g * (d + d.abs() - sum) > 0.0)
}

/// Whether two entries of J are opposite each other in a symmetric one, to the rounding of sums as large as what is on the diagonal.
fn opposite([x, y]: [f64; 2], [a, b]: [f64; 2]) -> bool {
    const ROUNDING: f64 = 1e-11;
    (x - y).abs() <= ROUNDING * (x.abs() + y.abs() + a.abs() + b.abs())
}

/// The bodies whose places others feel, by the entries of J, each with its row and column: component after component, as in
/// [`Vectors`]. What a body feels that is not among them, as a test body, is in no pivot.
fn felt(bodies: usize, entries: impl Iterator<Item = (usize, usize, f64)>) -> Vec<bool> {
    let mut felt = vec![false; bodies];
    for (row, column, entry) in entries {
        felt[column % bodies] |= row % bodies != column % bodies && entry != 0.0;
    }
    felt
}

/// Whether an entry and the one opposite to it are of two bodies, and what is not 0 of them is in no pivot.
fn in_no_pivot([row, column]: [usize; 2], [x, y]: [f64; 2], felt: &[bool]) -> bool {
    let [a, b] = [row, column].map(|place| place % felt.len());
    a != b && (x == 0.0 || y == 0.0) && !felt[if x == 0.0 { b } else { a }]
}

/// A Jacobian in D×D blocks, and the factors of 1 + g J made of it.
#[derive(Clone, Debug)]
pub enum Matrix<const D: usize> {
    /// Consecutive bodies are linked: block-tridiagonal, O(n).
    Chain(ChainMatrix<D>),
    /// The bodies of a list are linked: sparse, with the fill of its elimination (feature `sparse`).
    #[cfg(feature = "sparse")]
    Sparse(Box<SparseMatrix<D>>),
    /// Bodies within reach are linked: the blocks as they come, and no factors, O(links).
    Near(Box<NearMatrix<D>>),
    /// Any bodies may be linked: dense, O(n³) to factorise.
    Dense(DenseMatrix<D>),
}

/// The same of a matrix of any kind; of a chain, which goes from body to body, perhaps something else.
macro_rules! each {
    ($self:expr, $matrix:ident => $what:expr) => {
        each!($self, $matrix => $what, $matrix => $what)
    };
    ($self:expr, $chain:ident => $of_chain:expr, $matrix:ident => $what:expr) => {
        match $self {
            Matrix::Chain($chain) => $of_chain,
            #[cfg(feature = "sparse")]
            Matrix::Sparse($matrix) => $what,
            Matrix::Near($matrix) => $what,
            Matrix::Dense($matrix) => $what,
        }
    };
}

impl<const D: usize> Matrix<D> {
    /// The matrix that fits a topology. For a list of bonds it is sparse with the feature `sparse`, and dense without.
    pub fn new(bodies: usize, topology: &Topology) -> Self {
        match topology {
            Topology::Chain => Matrix::Chain(ChainMatrix::new(bodies)),
            #[cfg(feature = "sparse")]
            Topology::Sparse { bonds, chain } => {
                let neighbours = (1..if *chain { bodies } else { 0 }).map(|b| (b - 1, b));
                let sparse = SparseMatrix::new(bodies, bonds.iter().copied().chain(neighbours));
                sparse
                    .map_or_else(|| Matrix::Dense(DenseMatrix::new(bodies)), |sparse| Matrix::Sparse(Box::new(sparse)))
            }
            // A dense matrix fits everything.
            #[cfg(not(feature = "sparse"))]
            Topology::Sparse { .. } => Matrix::Dense(DenseMatrix::new(bodies)),
            Topology::Near => Matrix::Near(Box::new(NearMatrix::new(bodies))),
            Topology::Dense => Matrix::Dense(DenseMatrix::new(bodies)),
        }
    }

    /// J ← 0.
    pub fn clear(&mut self) {
        each!(self, matrix => matrix.clear())
    }

    /// J_ab += block.
    #[inline(always)]
    pub fn add_block(&mut self, a: usize, b: usize, block: [[f64; D]; D]) {
        each!(self, matrix => matrix.add_block(a, b, block))
    }

    /// What a link with ∂G_d/∂d = block adds: G_a = G_d and G_b = −G_d.
    #[inline(always)]
    pub fn add_link(&mut self, a: usize, b: usize, block: [[f64; D]; D]) {
        match self {
            Matrix::Chain(matrix) => return matrix.add_link(a, b, block),
            Matrix::Near(matrix) => return matrix.add_link(a, b, block),
            _ => {}
        }
        let mut opposite = block;
        opposite.as_flattened_mut().iter_mut().for_each(|x| *x = -*x);
        self.add_block(a, a, block);
        self.add_block(a, b, opposite);
        self.add_block(b, a, opposite);
        self.add_block(b, b, block);
    }

    /// y += J x.
    pub fn multiply_add(&self, x: &Vectors<D>, y: &mut Vectors<D>) {
        each!(self, chain => chain.multiply_add(x, y), matrix => matrix.multiply_add(x.flat(), y.flat_mut()))
    }

    /// out += Σ |J| over each row.
    pub fn add_row_sums(&self, out: &mut Vectors<D>) {
        each!(self, chain => chain.add_row_sums(out), matrix => matrix.add_row_sums(out.flat_mut()))
    }

    /// Factorises 1 + g J, with one g for each coordinate (0 for those of pinned bodies). `false` if it is not as it must be.
    pub fn factorise(&mut self, g: &Vectors<D>, must_be: Kind) -> bool {
        each!(self, matrix => matrix.factorise(g, must_be))
    }

    /// Whether the factors of a regular matrix say at once what [`continues`](Matrix::continues) finds, which is so where the step
    /// resolves the motion.
    #[inline]
    pub fn is_positive(&self) -> bool {
        each!(self, matrix => matrix.is_positive())
    }

    /// Whether 1 + g J, with the g that was factorised, may be that at a root which continues that of a shorter step. It grows from
    /// the unit matrix with the step, and on the way is not singular: its determinant is positive, and where J is symmetric it is
    /// positive definite.
    #[cold]
    pub fn continues(&mut self, g: &Vectors<D>) -> bool {
        each!(self, chain => chain.continues(), matrix => matrix.continues(g))
    }

    /// x ← (1 + g J)⁻¹ x, with the g that was factorised.
    pub fn solve(&mut self, g: &Vectors<D>, x: &mut Vectors<D>) {
        each!(self, chain => chain.solve(g, x), matrix => matrix.solve(x.flat_mut()))
    }
}

#[cfg(test)]
mod tests;
