//! Whether a sparse matrix is positive definite.

use faer::Par;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::cholesky::{SymmetricOrdering, factorize_symbolic_cholesky};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};

/// Whether A = 1 + g J is positive definite, J symmetric with links that one end may not feel, and rows scaled by g.
///
/// S = √g A √g⁻¹ has the pivots of A and is symmetric: its entries are the roots of AᵢⱼAⱼᵢ, and nothing is left of a link that
/// one end does not feel, which is in no pivot. Where each row of A has more on its diagonal than beside it, as with springs that
/// pull, that is enough; else Cholesky's factors tell, which are made anew each time: a hill in a scene of bonds is rare.
///
/// `room` is for a number of each row.
pub(super) fn is_definite(pattern: SymbolicSparseColMatRef<'_, usize>, values: &[f64], room: &mut [f64]) -> bool {
    leads(pattern, values, room) || has_root(pattern, values)
}

/// Whether each diagonal entry is larger than all beside it in its row together.
fn leads(pattern: SymbolicSparseColMatRef<'_, usize>, values: &[f64], excess: &mut [f64]) -> bool {
    excess.fill(0.0);
    for (column, row, entry) in entries(pattern) {
        excess[row] += if row == column { values[entry] } else { -values[entry].abs() };
    }
    excess.iter().all(|&excess| excess > 0.0)
}

/// Whether S has a Cholesky factor.
fn has_root(pattern: SymbolicSparseColMatRef<'_, usize>, values: &[f64]) -> bool {
    let (columns, rows) = (pattern.col_ptr(), pattern.row_idx());
    let mut roots = vec![0.0; values.len()];
    for (column, row, entry) in entries(pattern) {
        let first = columns[row];
        let mirrored = rows[first..columns[row + 1]].binary_search(&column);
        let opposite = mirrored.map_or(0.0, |place| values[first + place]);
        roots[entry] = match row == column {
            true => values[entry],
            false => (values[entry].abs().sqrt() * opposite.abs().sqrt()).copysign(values[entry]),
        };
    }
    let Ok(symbolic) =
        factorize_symbolic_cholesky(pattern, faer::Side::Lower, SymmetricOrdering::Amd, Default::default())
    else {
        return false;
    };
    let mut factor = vec![0.0; symbolic.len_val()];
    let room = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
    let mut buffer = MemBuffer::new(room);
    let matrix = SparseColMatRef::new(pattern, &roots[..]);
    let (lower, stack) = (faer::Side::Lower, MemStack::new(&mut buffer));
    symbolic
        .factorize_numeric_llt(&mut factor, matrix, lower, Default::default(), Par::Seq, stack, Default::default())
        .is_ok()
}

/// Column, row and place of every entry.
fn entries(pattern: SymbolicSparseColMatRef<'_, usize>) -> impl Iterator<Item = (usize, usize, usize)> {
    let (columns, rows) = (pattern.col_ptr(), pattern.row_idx());
    columns
        .windows(2)
        .enumerate()
        .flat_map(move |(column, bounds)| (bounds[0]..bounds[1]).map(move |entry| (column, rows[entry], entry)))
}
