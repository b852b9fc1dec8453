//! Whether a sparse matrix is positive definite.

use std::sync::Arc;

use faer::Par;
use faer::dyn_stack::MemStack;
use faer::sparse::linalg::cholesky::{SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};

use super::sparse::Workspace;
use super::{felt, in_no_pivot, opposite};

/// Whether each diagonal entry is larger than all beside it in its row together, as with springs that pull.
///
/// `room` is for a number of each row.
pub(super) fn leads(pattern: SymbolicSparseColMatRef<'_, usize>, values: &[f64], room: &mut [f64]) -> bool {
    room.fill(0.0);
    for (column, row, entry) in entries(pattern) {
        room[row] += if row == column { values[entry] } else { -values[entry].abs() };
    }
    room.iter().all(|&excess| excess > 0.0)
}

/// Cholesky's factors, and where they are made. Their pattern is found when they are first asked for, which is rare: a hill in a
/// scene of bonds, and steps that do not resolve the motion.
#[derive(Clone, Debug)]
pub(super) struct Root {
    symbolic: Arc<SymbolicCholesky<usize>>,
    /// Where the entry is that is opposite to each.
    opposite: Vec<usize>,
    symmetric: Vec<f64>,
    factor: Vec<f64>,
    workspace: Workspace,
}

impl Root {
    /// `None` if there is no memory for it.
    pub(super) fn new(pattern: SymbolicSparseColMatRef<'_, usize>) -> Option<Self> {
        let (columns, rows) = (pattern.col_ptr(), pattern.row_idx());
        let ordering = SymmetricOrdering::Amd;
        let symbolic = factorize_symbolic_cholesky(pattern, faer::Side::Lower, ordering, Default::default()).ok()?;
        let opposite = entries(pattern).map(|(column, row, entry)| {
            let first = columns[row];
            // The pattern is symmetric.
            rows[first..columns[row + 1]].binary_search(&column).map_or(entry, |place| first + place)
        });
        Some(Root {
            opposite: opposite.collect(),
            symmetric: vec![0.0; rows.len()],
            factor: vec![0.0; symbolic.len_val()],
            workspace: Workspace::new(symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default())),
            symbolic: Arc::new(symbolic),
        })
    }

    /// Whether the symmetric part of 1 + √g J √g is positive definite: then the determinant of 1 + g J is positive, and if J is
    /// symmetric this is what decides. Of a link to a body that nobody feels, which is in no pivot, nothing is left.
    pub(super) fn exists(
        &mut self,
        bodies: usize,
        pattern: SymbolicSparseColMatRef<'_, usize>,
        jacobian: &[f64],
        g: &[f64],
    ) -> bool {
        let felt = felt_by_others(bodies, pattern, jacobian);
        for (column, row, entry) in entries(pattern) {
            let [x, y] = [jacobian[entry], jacobian[self.opposite[entry]]];
            let mean = if in_no_pivot([row, column], [x, y], &felt) { 0.0 } else { 0.5 * (x + y) };
            let scaled = g[row].sqrt() * g[column].sqrt() * mean;
            self.symmetric[entry] = if row == column { 1.0 + scaled } else { scaled };
        }
        let matrix = SparseColMatRef::new(pattern, &self.symmetric[..]);
        let (lower, stack) = (faer::Side::Lower, MemStack::new(&mut self.workspace.buffer));
        let made = self.symbolic.factorize_numeric_llt(
            &mut self.factor,
            matrix,
            lower,
            Default::default(),
            Par::Seq,
            stack,
            Default::default(),
        );
        made.is_ok()
    }

    /// Whether J of so many bodies is symmetric, to rounding.
    pub(super) fn of_symmetric(
        &self,
        bodies: usize,
        pattern: SymbolicSparseColMatRef<'_, usize>,
        jacobian: &[f64],
    ) -> bool {
        let felt = felt_by_others(bodies, pattern, jacobian);
        let mut diagonal = vec![0.0; pattern.ncols()];
        for (column, row, entry) in entries(pattern) {
            if column == row {
                diagonal[row] = jacobian[entry];
            }
        }
        entries(pattern).all(|(column, row, entry)| {
            let pair = [jacobian[entry], jacobian[self.opposite[entry]]];
            opposite(pair, [diagonal[row], diagonal[column]]) || in_no_pivot([row, column], pair, &felt)
        })
    }
}

fn felt_by_others(bodies: usize, pattern: SymbolicSparseColMatRef<'_, usize>, jacobian: &[f64]) -> Vec<bool> {
    felt(bodies, entries(pattern).map(|(column, row, entry)| (row, column, jacobian[entry])))
}

/// Column, row and place of every entry.
pub(super) fn entries(pattern: SymbolicSparseColMatRef<'_, usize>) -> impl Iterator<Item = (usize, usize, usize)> {
    let (columns, rows) = (pattern.col_ptr(), pattern.row_idx());
    columns
        .windows(2)
        .enumerate()
        .flat_map(move |(column, bounds)| (bounds[0]..bounds[1]).map(move |entry| (column, rows[entry], entry)))
}
