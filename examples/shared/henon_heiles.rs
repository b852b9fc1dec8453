//! Pairs of neighbours under the potential of Hénon and Heiles, on a grid of starts with one energy.

use dmech::prelude::*;

const ENERGY: f64 = 0.125;
/// Cells of the grid along y and along the velocity of y.
pub(crate) const SIDE: usize = 200;
pub(crate) const Y: [f64; 2] = [-0.46, 0.7];
pub(crate) const V: [f64; 2] = [-0.52, 0.52];
/// How far apart neighbours start.
pub(crate) const APART: f64 = 1e-9;
pub(crate) const END: f64 = 200.0;

/// Column, row and start of the cells in which the energy leaves a velocity along x.
pub(crate) fn cells() -> Vec<(usize, usize, State<2>)> {
    let middle = |[from, to]: [f64; 2], i: usize| from + (to - from) * (i as f64 + 0.5) / SIDE as f64;
    let cell = |i: usize| {
        let (column, row) = (i % SIDE, i / SIDE);
        let (y, vy) = (middle(Y, column), middle(V, row));
        let rest = 2.0 * ENERGY - vy * vy - y * y + 2.0 / 3.0 * y.powi(3);
        (rest > 0.0).then(|| (column, row, State::new([0.0, y], [rest.sqrt(), vy])))
    };
    (0..SIDE * SIDE).filter_map(cell).collect()
}

/// The start of a member: two for each cell.
pub(crate) fn start(cells: &[(usize, usize, State<2>)], k: usize) -> State<2> {
    let mut start = cells[k / 2].2;
    start.q[1] += APART * (k % 2) as f64;
    start
}
