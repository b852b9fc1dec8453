//! Small linear systems over any [`Real`].

use dmech_scalar::{Mask, Real};

/// Solves A x = b by elimination with row pivoting; a singular A gives numbers that are not finite.
///
/// Rows are exchanged lane by lane with selections, so that several systems side by side each get their own pivots.
pub(crate) fn solve<const D: usize, R: Real>(a: [[R; D]; D], b: [R; D]) -> [R; D] {
    eliminate::<true, D, R>(a, b).solution
}

/// As [`solve`], without an exchange of rows, which a positive definite A does not need; beside x the pivots, all of which are
/// positive only if A is that, its rows scaled or not.
pub(crate) fn solve_definite<const D: usize, R: Real>(a: [[R; D]; D], b: [R; D]) -> ([R; D], [R; D]) {
    let Elimination { solution, pivots, .. } = eliminate::<false, D, R>(a, b);
    (solution, pivots)
}

/// −1, 0 or 1: the sign of det A.
pub(crate) fn orientation<const D: usize>(a: [[f64; D]; D]) -> f64 {
    let Elimination { pivots, exchanges, .. } = eliminate::<true, D, f64>(a, [0.0; D]);
    let sign = |x: f64| if x == 0.0 { 0.0 } else { x.signum() };
    pivots.into_iter().fold(if exchanges % 2 == 0 { 1.0 } else { -1.0 }, |all, pivot| all * sign(pivot))
}

/// What an elimination finds.
pub(super) struct Elimination<const D: usize, R> {
    pub(super) solution: [R; D],
    pub(super) pivots: [R; D],
    /// How often rows were exchanged, in any lane.
    pub(super) exchanges: u32,
}

pub(super) fn eliminate<const EXCHANGE: bool, const D: usize, R: Real>(
    mut a: [[R; D]; D],
    mut b: [R; D],
) -> Elimination<D, R> {
    let mut exchanges = 0;
    for k in 0..D {
        for i in if EXCHANGE { k + 1..D } else { 0..0 } {
            let larger = a[k][k].abs().less(a[i][k].abs());
            if larger.any() {
                exchanges += 1;
                for j in k..D {
                    (a[k][j], a[i][j]) = swapped(larger, a[k][j], a[i][j]);
                }
                (b[k], b[i]) = swapped(larger, b[k], b[i]);
            }
        }
        let inverse = a[k][k].recip();
        for i in k + 1..D {
            let factor = a[i][k] * inverse;
            for j in k + 1..D {
                a[i][j] = (-factor).mul_add(a[k][j], a[i][j]);
            }
            b[i] = (-factor).mul_add(b[k], b[i]);
        }
    }
    for k in (0..D).rev() {
        let mut sum = b[k];
        for j in k + 1..D {
            sum = (-a[k][j]).mul_add(b[j], sum);
        }
        b[k] = sum / a[k][k];
    }
    Elimination { solution: b, pivots: core::array::from_fn(|k| a[k][k]), exchanges }
}

fn swapped<R: Real>(swap: R::Mask, x: R, y: R) -> (R, R) {
    (R::select(swap, || y, || x), R::select(swap, || x, || y))
}

#[cfg(test)]
mod tests {
    use super::solve;

    /// Residual of every solution, on matrices that need a pivot: a zero or tiny leading entry.
    #[test]
    fn a_solution_satisfies_its_system_also_where_the_first_pivot_vanishes() {
        let systems = [
            [[0.0, 2.0, -1.0], [3.0, 0.5, 4.0], [1.0, -7.0, 0.25]],
            [[1e-18, 2.0, 1.0], [1.0, 1.0, 1.0], [2.0, -1.0, 3.0]],
            [[4.0, 1.0, 0.5], [8.0, 2.0, -3.0], [1.0, 6.0, 2.0]],
        ];
        let b = [1.3, -0.7, 2.9];
        for a in systems {
            let x = solve(a, b);
            for i in 0..3 {
                let ax: f64 = (0..3).map(|j| a[i][j] * x[j]).sum();
                assert!((ax - b[i]).abs() < 1e-14, "row {i} of {a:?}: {ax}");
            }
        }
    }
}
