//! The sign of the determinant of a sparse matrix.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::PermRef;
use faer::sparse::SparseColMatRef;
use faer::sparse::linalg::lu::simplicial::{
    SimplicialLu, factorize_simplicial_numeric_lu, factorize_simplicial_numeric_lu_scratch,
};

/// Whether the determinant is negative, by factors of its own: those that solve do not show their pivots, and it is rare that
/// nothing else tells.
pub(super) fn is_negative(matrix: SparseColMatRef<'_, usize, f64>, columns: PermRef<'_, usize>) -> bool {
    let n = matrix.ncols();
    let (mut rows, mut inverse, mut factors) = (vec![0; n], vec![0; n], SimplicialLu::new());
    let mut buffer = MemBuffer::new(factorize_simplicial_numeric_lu_scratch::<usize, f64>(n, n));
    let stack = MemStack::new(&mut buffer);
    if factorize_simplicial_numeric_lu(&mut rows, &mut inverse, &mut factors, matrix, columns, stack).is_err() {
        return false;
    }
    let upper = factors.u_factor_unsorted();
    let pivot =
        |column: usize| upper.row_idx_of_col(column).zip(upper.val_of_col(column)).find(|(row, _)| *row == column);
    let below = (0..n).filter(|&column| pivot(column).is_some_and(|(_, pivot)| *pivot < 0.0)).count();
    (below + exchanges(&rows) + exchanges(columns.arrays().0)) % 2 == 1
}

/// How many exchanges make a permutation.
fn exchanges(permutation: &[usize]) -> usize {
    let mut seen = vec![false; permutation.len()];
    let mut cycles = 0;
    for start in 0..permutation.len() {
        cycles += usize::from(!seen[start]);
        let mut at = start;
        while !seen[at] {
            seen[at] = true;
            at = permutation[at];
        }
    }
    permutation.len() - cycles
}
