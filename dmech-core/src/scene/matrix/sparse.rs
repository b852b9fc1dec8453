//! Listed bonds: sparse, through faer.

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::sparse::linalg::lu::{LuRef, NumericLu, SymbolicLu, factorize_symbolic_lu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{Conj, MatMut, Par};

use super::Kind;
use super::definite::{Root, leads};
use super::orientation::is_negative;
use super::series::{SMALL, Series};
use crate::scene::vectors::Vectors;

/// J in compressed columns (coordinates in the order of [`Vectors`]), and the LU factors of 1 + g J.
///
/// The pattern never changes: which columns are eliminated first, so that few zeros fill up, is found once (COLAMD, by
/// faer), and the room for the factors is kept; it grows where an exchange of rows fills up more. Rows are exchanged by
/// size in each factorisation, so it is as stable as the dense one. Where g J is small its power series is summed, without
/// factors. Everything runs in one thread, in one order: results do not depend on the number of cores.
#[derive(Clone, Debug)]
pub struct SparseMatrix<const D: usize> {
    /// The bodies linked to body b, b itself among them, ascending: `linked[first[b]..first[b + 1]]`.
    first: Vec<usize>,
    linked: Vec<usize>,
    pattern: SymbolicSparseColMat<usize>,
    jacobian: Vec<f64>,
    /// 1 + g J, or −g J if that is small.
    values: Vec<f64>,
    small: bool,
    series: Series,
    symbolic: SymbolicLu<usize>,
    factors: NumericLu<usize, f64>,
    /// Whether `factors` holds any: faer has no empty ones of the right size.
    factorised: bool,
    root: Option<Box<Root>>,
    probe: Vec<f64>,
    workspace: Workspace,
}

impl<const D: usize> SparseMatrix<D> {
    /// `None` if there is no memory for the symbolic factorisation.
    pub(super) fn new(bodies: usize, links: impl Iterator<Item = (usize, usize)>) -> Option<Self> {
        let mut pairs: Vec<_> = (0..bodies).map(|i| (i, i)).collect();
        pairs.extend(links.flat_map(|(a, b)| [(a, b), (b, a)]));
        pairs.sort_unstable();
        pairs.dedup();
        let first: Vec<usize> = (0..=bodies).map(|b| pairs.partition_point(|&(i, _)| i < b)).collect();
        let linked: Vec<usize> = pairs.into_iter().map(|(_, a)| a).collect();

        let (n, entries) = (D * bodies, D * D * linked.len());
        let (mut columns, mut rows) = (Vec::with_capacity(n + 1), Vec::with_capacity(entries));
        columns.push(0);
        for _ in 0..D {
            for b in 0..bodies {
                for k in 0..D {
                    rows.extend(linked[first[b]..first[b + 1]].iter().map(|a| k * bodies + a));
                }
                columns.push(rows.len());
            }
        }
        let pattern = SymbolicSparseColMat::new_checked(n, n, columns, None, rows);
        let symbolic = factorize_symbolic_lu(pattern.as_ref(), Default::default()).ok()?;
        let factorise = symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Default::default());
        let solve = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        Some(SparseMatrix {
            first,
            linked,
            pattern,
            jacobian: vec![0.0; entries],
            values: vec![0.0; entries],
            small: false,
            series: Series::new(n),
            symbolic,
            factors: NumericLu::new(),
            factorised: false,
            root: None,
            probe: vec![0.0; n],
            workspace: Workspace::new(StackReq::any_of(&[factorise, solve])),
        })
    }

    fn bodies(&self) -> usize {
        self.first.len() - 1
    }

    pub(super) fn clear(&mut self) {
        self.jacobian.fill(0.0);
    }

    #[inline]
    pub(super) fn add_block(&mut self, a: usize, b: usize, block: [[f64; D]; D]) {
        let linked = &self.linked[self.first[b]..self.first[b + 1]];
        // Every link of a term is in the topology that it stated.
        let Ok(rank) = linked.binary_search(&a) else { return };
        let (columns, degree) = (self.pattern.col_ptr(), linked.len());
        for l in 0..D {
            let column = columns[l * self.bodies() + b];
            for k in 0..D {
                self.jacobian[column + k * degree + rank] += block[k][l];
            }
        }
    }

    pub(super) fn multiply_add(&self, x: &[f64], y: &mut [f64]) {
        multiply_add(&self.pattern, &self.jacobian, x, y);
    }

    pub(super) fn add_row_sums(&self, sums: &mut [f64]) {
        add_row_sums(self.pattern.row_idx(), &self.jacobian, sums);
    }

    pub(super) fn factorise(&mut self, g: &Vectors<D>, must_be: Kind) -> bool {
        let (columns, rows) = (self.pattern.col_ptr(), self.pattern.row_idx());
        self.small = self.series.ends(g, SMALL, |sums| add_row_sums(rows, &self.jacobian, sums));
        let sign = if self.small { -1.0 } else { 1.0 };
        for ((value, j), &row) in self.values.iter_mut().zip(&self.jacobian).zip(rows) {
            *value = sign * g.flat()[row] * j;
        }
        if self.small {
            return true;
        }
        for (column, bounds) in columns.windows(2).enumerate() {
            for entry in bounds[0]..bounds[1] {
                if rows[entry] == column {
                    self.values[entry] += 1.0;
                }
            }
        }
        if must_be == Kind::Definite && !self.has_root(g) {
            return false;
        }
        let matrix = SparseColMatRef::new(self.pattern.as_ref(), &self.values[..]);
        let stack = MemStack::new(&mut self.workspace.buffer);
        let made = self.symbolic.factorize_numeric_lu(&mut self.factors, matrix, Par::Seq, stack, Default::default());
        self.factorised = made.is_ok();
        // faer divides by a zero pivot as by any other, and any right-hand side shows it.
        self.probe.fill(1.0);
        self.factorised && {
            solve(&self.symbolic, &self.factors, &mut self.probe, &mut self.workspace);
            self.probe.iter().all(|x| x.is_finite())
        }
    }

    /// Whether the symmetric part of 1 + g J, rows of a symmetric J not scaled by g, is positive definite.
    fn has_root(&mut self, g: &Vectors<D>) -> bool {
        let pattern = self.pattern.as_ref();
        if leads(pattern, &self.values, &mut self.probe) {
            return true;
        }
        if self.root.is_none() {
            self.root = Root::new(pattern).map(Box::new);
        }
        self.root.as_mut().is_some_and(|root| root.exists(self.first.len() - 1, pattern, &self.jacobian, g.flat()))
    }

    pub(super) fn is_positive(&self) -> bool {
        self.small
    }

    /// As [`Matrix::continues`](super::Matrix::continues).
    pub(super) fn continues(&mut self, g: &Vectors<D>) -> bool {
        if self.small || self.has_root(g) {
            return true;
        }
        let pattern = self.pattern.as_ref();
        let symmetric =
            self.root.as_ref().is_none_or(|root| root.of_symmetric(self.first.len() - 1, pattern, &self.jacobian));
        !symmetric && !is_negative(SparseColMatRef::new(pattern, &self.values[..]), self.symbolic.col_perm())
    }

    pub(super) fn solve(&mut self, x: &mut [f64]) {
        if self.small {
            self.series.solve(x, |x, y| multiply_add(&self.pattern, &self.values, x, y));
        } else if self.factorised {
            solve(&self.symbolic, &self.factors, x, &mut self.workspace);
        }
    }
}

/// Σ |M| over each row, added to `sums`.
fn add_row_sums(rows: &[usize], values: &[f64], sums: &mut [f64]) {
    rows.iter().zip(values).for_each(|(&row, m)| sums[row] += m.abs());
}

/// y += M x.
fn multiply_add(pattern: &SymbolicSparseColMat<usize>, values: &[f64], x: &[f64], y: &mut [f64]) {
    let (columns, rows) = (pattern.col_ptr(), pattern.row_idx());
    for (&x, column) in x.iter().zip(columns.windows(2)) {
        let range = column[0]..column[1];
        for (&row, m) in rows[range.clone()].iter().zip(&values[range]) {
            y[row] += m * x;
        }
    }
}

fn solve(symbolic: &SymbolicLu<usize>, factors: &NumericLu<usize, f64>, x: &mut [f64], workspace: &mut Workspace) {
    let rows = x.len();
    let side = MatMut::from_column_major_slice_mut(x, rows, 1);
    let stack = MemStack::new(&mut workspace.buffer);
    LuRef::new_unchecked(symbolic, factors).solve_in_place_with_conj(Conj::No, side, Par::Seq, stack);
}

/// Where faer computes; what is in it has no meaning between two calls.
pub(super) struct Workspace {
    size: StackReq,
    pub(super) buffer: MemBuffer,
}

impl Workspace {
    pub(super) fn new(size: StackReq) -> Self {
        Workspace { size, buffer: MemBuffer::new(size) }
    }
}

impl Clone for Workspace {
    fn clone(&self) -> Self {
        Workspace::new(self.size)
    }
}

impl core::fmt::Debug for Workspace {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_tuple("Workspace").field(&self.size).finish()
    }
}
