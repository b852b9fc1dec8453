//! Consecutive bodies: block-tridiagonal.

use super::Kind;
use super::block::{Block, add, definite, invert, is_symmetric, mirrored, product, scaled, subtract, times};
use crate::newton::elimination::orientation;
use crate::scene::vectors::Vectors;
use crate::vector::{self, difference};

/// J with blocks on the diagonal and beside it, and the factors of 1 + g J by block elimination without exchange of rows
/// between bodies; within a block rows are exchanged.
///
/// 1 + g J is near 1 where the step resolves the motion, and for a stiff chain it is the matrix of a string under tension:
/// in both cases the diagonal blocks dominate and elimination in the order of the bodies is stable (N. J. Higham,
/// Accuracy and Stability of Numerical Algorithms, 2nd ed., §13.2).
///
/// A long chain does not fit into the nearest memory and is as slow as that is read and written: what can be had from
/// something else is not stored.
#[derive(Clone, Debug)]
pub struct ChainMatrix<const D: usize> {
    /// J_ii.
    diagonal: Vec<Block<D>>,
    /// J_i,i+1, and J_i+1,i as far as it is the same.
    upper: Vec<Block<D>>,
    /// J_i,i−1 − J_i−1,i: empty unless forces are not reciprocal.
    excess: Vec<Block<D>>,
    /// E_i = D_i⁻¹ and W_i = E_i U_i, with D_i the eliminated diagonal.
    inverse: Vec<Block<D>>,
    following: Vec<Block<D>>,
    /// Each D_i is positive definite, as far as it is symmetric.
    positive: bool,
}

impl<const D: usize> ChainMatrix<D> {
    pub(super) fn new(bodies: usize) -> Self {
        let zeros = vec![[[0.0; D]; D]; bodies];
        ChainMatrix {
            diagonal: zeros.clone(),
            upper: zeros.clone(),
            excess: Vec::new(),
            inverse: zeros.clone(),
            following: zeros,
            positive: true,
        }
    }

    pub(super) fn clear(&mut self) {
        for blocks in [&mut self.diagonal, &mut self.upper, &mut self.excess] {
            blocks.fill([[0.0; D]; D]);
        }
    }

    pub(super) fn add_block(&mut self, a: usize, b: usize, block: Block<D>) {
        if a == b {
            add(&mut self.diagonal[a], block);
            return;
        }
        self.excess.resize(self.diagonal.len(), [[0.0; D]; D]);
        if a < b {
            add(&mut self.upper[a], block);
            subtract(&mut self.excess[b], block);
        } else {
            add(&mut self.excess[a], block);
        }
    }

    /// The four blocks of a link: those beside the diagonal are the same.
    #[inline]
    pub(super) fn add_link(&mut self, a: usize, b: usize, block: Block<D>) {
        add(&mut self.diagonal[a], block);
        add(&mut self.diagonal[b], block);
        subtract(&mut self.upper[a.min(b)], block);
    }

    /// J_i,i−1, for i > 0.
    #[inline(always)]
    fn lower(&self, i: usize) -> Block<D> {
        let mut block = self.upper[i - 1];
        if let Some(&excess) = self.excess.get(i) {
            add(&mut block, excess);
        }
        block
    }

    pub(super) fn add_row_sums(&self, out: &mut Vectors<D>) {
        let sums = |block: Block<D>| block.map(|row| row.iter().map(|x| x.abs()).sum());
        for (i, &diagonal) in self.diagonal.iter().enumerate() {
            out.add(i, sums(diagonal));
            if i > 0 {
                out.add(i, sums(self.lower(i)));
            }
            if i + 1 < self.diagonal.len() {
                out.add(i, sums(self.upper[i]));
            }
        }
    }

    pub(super) fn multiply_add(&self, x: &Vectors<D>, y: &mut Vectors<D>) {
        let n = self.diagonal.len();
        for i in 0..n {
            let mut sum = times(&self.diagonal[i], x.get(i));
            if i > 0 {
                sum = vector::sum(sum, times(&self.lower(i), x.get(i - 1)));
            }
            if i + 1 < n {
                sum = vector::sum(sum, times(&self.upper[i], x.get(i + 1)));
            }
            y.add(i, sum);
        }
    }

    pub(super) fn factorise(&mut self, g: &Vectors<D>, must_be: Kind) -> bool {
        let (mut regular, mut positive) = (true, true);
        let mut before = [[0.0; D]; D];
        for i in 0..self.diagonal.len() {
            let g = g.get(i);
            let mut pivot = scaled(g, &self.diagonal[i]);
            for k in 0..D {
                pivot[k][k] += 1.0;
            }
            if i > 0 {
                subtract(&mut pivot, product(&scaled(g, &self.lower(i)), &before));
            }
            let inverse = invert(&pivot);
            regular &= inverse.iter().flatten().all(|x| x.is_finite());
            positive &= definite(&pivot);
            before = product(&inverse, &scaled(g, &self.upper[i]));
            (self.inverse[i], self.following[i]) = (inverse, before);
        }
        self.positive = positive;
        regular && (positive || must_be == Kind::Regular)
    }

    pub(super) fn is_positive(&self) -> bool {
        self.positive
    }

    /// As [`Matrix::continues`](super::Matrix::continues): the determinant is the product of those of the D_i.
    pub(super) fn continues(&self) -> bool {
        let negative = || self.inverse.iter().filter(|&&block| orientation(block) < 0.0).count() % 2 == 1;
        self.positive || !(self.is_symmetric() || negative())
    }

    fn is_symmetric(&self) -> bool {
        let n = self.diagonal.len();
        // A link that one end does not feel is in no pivot.
        let alike = |i: usize| {
            let (upper, lower) = (&self.upper[i - 1], &self.lower(i));
            let one_way = [upper, lower].iter().any(|block| block.iter().flatten().all(|&x| x == 0.0));
            one_way || mirrored(upper, lower, [&self.diagonal[i - 1], &self.diagonal[i]])
        };
        self.diagonal.iter().all(is_symmetric) && (1..n).all(alike)
    }

    pub(super) fn solve(&mut self, g: &Vectors<D>, x: &mut Vectors<D>) {
        let n = self.diagonal.len();
        let mut before = [0.0; D];
        for i in 0..n {
            let mut own = x.get(i);
            if i > 0 {
                let (g, known) = (g.get(i), times(&self.lower(i), before));
                for k in 0..D {
                    own[k] -= g[k] * known[k];
                }
            }
            before = times(&self.inverse[i], own);
            x.set(i, before);
        }
        let mut after = [0.0; D];
        for i in (0..n).rev() {
            let (own, known) = (x.get(i), times(&self.following[i], after));
            after = difference(own, known);
            x.set(i, after);
        }
    }
}
