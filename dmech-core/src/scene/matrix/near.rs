//! Bodies within reach of each other, which are others from step to step: the blocks as they come, and no factors.

use super::block::{Block, add, least, times};
use super::series::{SMALL, Series};
use super::{Kind, Matrix, leads};
use crate::scene::topology::Topology;
use crate::scene::vectors::Vectors;
use crate::vector::largest;

/// J as a list of blocks, and what solves with 1 + g J by products with it: O(links) numbers, and as much time for a product.
///
/// A small g J is solved by its power series, any other by BiCGSTAB (H. A. van der Vorst, SIAM J. Sci. Stat. Comput. 13
/// (1992) 631), both to rounding. Where that breaks down, as it may where test bodies feel others and these nothing of them, it begins
/// anew from where it is, and at last the blocks are eliminated.
#[derive(Clone, Debug)]
pub struct NearMatrix<const D: usize> {
    bodies: usize,
    /// What acts on each body by itself.
    own: Vec<Block<D>>,
    /// What acts along links: G_a = G_d and G_b = −G_d, with ∂G_d/∂d.
    links: Vec<(usize, usize, Block<D>)>,
    /// Blocks of forces that are not reciprocal.
    others: Vec<(usize, usize, Block<D>)>,
    /// J_aa, for the sums over rows.
    diagonal: Vec<Block<D>>,
    g: Vectors<D>,
    small: bool,
    series: Series,
    room: [Vec<f64>; 7],
}

/// Products with J from one start at most, twice this.
const MOST: usize = 200;
/// How often it begins, and how small a part of the right side may be left where it breaks down or takes too long: Newton's next
/// correction has the rest.
const STARTS: usize = 2;
const CLOSE: f64 = 1e-8;
/// Unknowns of which a dense matrix is made at last, at most: of more it would take longer than anybody waits.
const MOST_DENSE: usize = 2000;

impl<const D: usize> NearMatrix<D> {
    pub(super) fn new(bodies: usize) -> Self {
        let (none, zeros) = (vec![[[0.0; D]; D]; bodies], vec![0.0; D * bodies]);
        NearMatrix {
            bodies,
            own: none.clone(),
            links: Vec::new(),
            others: Vec::new(),
            diagonal: none,
            g: Vectors::zeros(bodies),
            small: false,
            series: Series::new(D * bodies),
            room: core::array::from_fn(|_| zeros.clone()),
        }
    }

    pub(super) fn clear(&mut self) {
        self.own.fill([[0.0; D]; D]);
        self.diagonal.fill([[0.0; D]; D]);
        self.links.clear();
        self.others.clear();
    }

    #[inline]
    pub(super) fn add_block(&mut self, a: usize, b: usize, block: Block<D>) {
        if a == b {
            add(&mut self.own[a], block);
            add(&mut self.diagonal[a], block);
        } else {
            self.others.push((a, b, block));
        }
    }

    #[inline]
    pub(super) fn add_link(&mut self, a: usize, b: usize, block: Block<D>) {
        add(&mut self.diagonal[a], block);
        add(&mut self.diagonal[b], block);
        self.links.push((a, b, block));
    }

    pub(super) fn multiply_add(&self, x: &[f64], y: &mut [f64]) {
        let n = self.bodies;
        let at = |a: usize| core::array::from_fn(|k| x[k * n + a]);
        let mut put = |a: usize, product: [f64; D]| (0..D).for_each(|k| y[k * n + a] += product[k]);
        for (a, block) in self.own.iter().enumerate() {
            put(a, times(block, at(a)));
        }
        for &(a, b, ref block) in &self.links {
            let product = times(block, core::array::from_fn(|k| x[k * n + a] - x[k * n + b]));
            put(a, product);
            put(b, product.map(|x| -x));
        }
        for &(a, b, ref block) in &self.others {
            put(a, times(block, at(b)));
        }
    }

    pub(super) fn add_row_sums(&self, sums: &mut [f64]) {
        let n = self.bodies;
        let mut put = |a: usize, block: &Block<D>| {
            (0..D).for_each(|k| sums[k * n + a] += block[k].iter().map(|x| x.abs()).sum::<f64>());
        };
        for (a, block) in self.diagonal.iter().enumerate() {
            put(a, block);
        }
        for (a, b, block) in &self.links {
            put(*a, block);
            put(*b, block);
        }
        for (a, _, block) in &self.others {
            put(*a, block);
        }
    }

    pub(super) fn factorise(&mut self, g: &Vectors<D>, must_be: Kind) -> bool {
        self.g.clone_from(g);
        let mut series = core::mem::replace(&mut self.series, Series::new(0));
        self.small = series.ends(g, SMALL, |sums| self.add_row_sums(sums));
        self.series = series;
        self.small || must_be == Kind::Regular || self.leads() || self.pulls() || self.eliminated(g, Kind::Definite).1
    }

    pub(super) fn is_positive(&self) -> bool {
        self.small
    }

    /// As [`Matrix::continues`]: where the blocks by themselves do not tell, by elimination.
    pub(super) fn continues(&mut self, g: &Vectors<D>) -> bool {
        self.small || self.leads() || self.pulls() || {
            let (mut matrix, regular) = self.eliminated(g, Kind::Regular);
            !regular || matrix.continues(g)
        }
    }

    /// Whether each diagonal entry of 1 + g J leads its row.
    fn leads(&mut self) -> bool {
        let mut sums = core::mem::take(&mut self.room[0]);
        sums.fill(0.0);
        self.add_row_sums(&mut sums);
        let diagonal = (0..D).flat_map(|k| self.diagonal.iter().map(move |block| block[k][k]));
        let leads = leads(diagonal, &sums, self.g.flat());
        self.room[0] = sums;
        leads
    }

    /// Whether no link and no body takes more from 1 than there is: x·J x ≥ Σ λ |x_a − x_b|² ≥ 2 Σ λ (|x_a|² + |x_b|²) with
    /// the least eigenvalue λ < 0 of each link, of the part of J that is symmetric.
    fn pulls(&mut self) -> bool {
        if !self.others.is_empty() {
            return false;
        }
        let mut lost: Vec<f64> = self.own.iter().map(|block| least(block).min(0.0)).collect();
        for (a, b, block) in &self.links {
            let least = 2.0 * least(block).min(0.0);
            lost[*a] += least;
            lost[*b] += least;
        }
        (0..D).all(|k| lost.iter().zip(&self.g.flat()[k * self.bodies..]).all(|(lost, g)| 1.0 + g * lost > 0.0))
    }

    /// The matrix with factors, and whether it is as it must be: of many bodies sparse ones, where there are such.
    fn eliminated(&self, g: &Vectors<D>, must_be: Kind) -> (Matrix<D>, bool) {
        const FEW: usize = 60;
        let topology = if self.bodies > FEW {
            let ends = |&(a, b, _): &(usize, usize, Block<D>)| (a, b);
            let bonds = self.links.iter().chain(&self.others).map(ends).collect();
            Topology::Sparse { bonds, chain: false }
        } else {
            Topology::Dense
        };
        let mut matrix = Matrix::new(self.bodies, &topology);
        for (a, &block) in self.own.iter().enumerate() {
            matrix.add_block(a, a, block);
        }
        for &(a, b, block) in &self.links {
            matrix.add_link(a, b, block);
        }
        for &(a, b, block) in &self.others {
            matrix.add_block(a, b, block);
        }
        let fits = matrix.factorise(g, must_be);
        (matrix, fits)
    }

    pub(super) fn solve(&mut self, x: &mut [f64]) {
        if self.small {
            let mut series = core::mem::replace(&mut self.series, Series::new(0));
            // The series asks for a product with −g J in place of zeros.
            series.solve(x, |x, y| {
                self.multiply_add(x, y);
                y.iter_mut().zip(self.g.flat()).for_each(|(y, g)| *y *= -g);
            });
            self.series = series;
        } else if !self.iterate(x) {
            let mut all = Vectors::zeros(self.bodies);
            all.flat_mut().copy_from_slice(x);
            self.eliminated(&self.g, Kind::Regular).0.solve(&self.g, &mut all);
            x.copy_from_slice(all.flat());
        }
    }

    /// y ← (1 + g J) x.
    fn multiply(&self, x: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        self.multiply_add(x, y);
        y.iter_mut().zip(self.g.flat()).zip(x).for_each(|((y, g), x)| *y = g * *y + x);
    }

    /// x ← (1 + g J)⁻¹ x by BiCGSTAB, if that comes close.
    fn iterate(&mut self, x: &mut [f64]) -> bool {
        let mut room = core::mem::take(&mut self.room);
        let [residual, sum, ..] = &mut room;
        residual.copy_from_slice(x);
        sum.fill(0.0);
        let size = largest(x);
        let found = (0..STARTS).any(|_| {
            self.go_on(0.25 * f64::EPSILON * size, &mut room) || {
                let [residual, sum, ..] = &mut room;
                self.multiply(sum, residual);
                residual.iter_mut().zip(&*x).for_each(|(r, x)| *r = x - *r);
                largest(residual) <= CLOSE * size
            }
        });
        let found = found || D * self.bodies > MOST_DENSE && !cfg!(feature = "sparse");
        if found {
            // Pinned bodies, of which g is 0, stay to the bit.
            for ((x, found), g) in x.iter_mut().zip(&room[1]).zip(self.g.flat()) {
                if *g != 0.0 {
                    *x = *found;
                }
            }
        }
        self.room = room;
        found
    }

    /// BiCGSTAB from what has been summed and the residual there, in the letters of its author; `false` where it breaks down, or takes
    /// too long.
    fn go_on(&self, enough: f64, [r, sum, shadow, p, v, s, t]: &mut [Vec<f64>; 7]) -> bool {
        shadow.copy_from_slice(r);
        [&mut *p, &mut *v].into_iter().for_each(|x| x.fill(0.0));
        let [mut rho, mut alpha, mut omega] = [1.0; 3];
        for _ in 0..MOST {
            // What is not finite does not get smaller.
            if largest(r) <= enough || !largest(r).is_finite() {
                return true;
            }
            let last = core::mem::replace(&mut rho, product(shadow, r));
            let beta = rho / last * (alpha / omega);
            p.iter_mut().zip(&*v).zip(&*r).for_each(|((p, v), r)| *p = r + beta * (*p - omega * v));
            self.multiply(p, v);
            alpha = rho / product(shadow, v);
            if !beta.is_finite() || !alpha.is_finite() || alpha == 0.0 {
                return false;
            }
            s.iter_mut().zip(&*r).zip(&*v).for_each(|((s, r), v)| *s = r - alpha * v);
            self.multiply(s, t);
            let square = product(t, t);
            omega = if square > 0.0 { product(t, s) / square } else { 0.0 };
            sum.iter_mut().zip(&*p).zip(&*s).for_each(|((x, p), s)| *x += alpha * p + omega * s);
            r.iter_mut().zip(&*s).zip(&*t).for_each(|((r, s), t)| *r = s - omega * t);
        }
        false
    }
}

/// x·y.
fn product(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}
