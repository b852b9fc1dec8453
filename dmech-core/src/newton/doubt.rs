//! Whether a root continues that of a shorter step, by the matrix 1 + g J there.
//!
//! It grows from the unit matrix with the step, and on the way is not singular: its determinant is positive, and where J is symmetric, its
//! rows divided by masses or not, it is positive definite.

use dmech_scalar::{Mask, Real};

use super::elimination::{self, Elimination};
use super::settled::Settled;

/// x with A x = b, whether A may be that at a root which continues that of a shorter step, and whether that is without doubt. Of several
/// side by side only what is plain is said; the others are left to each alone.
///
/// As long as steps resolve the motion no rows are exchanged and all pivots are positive. Then there is no doubt.
#[inline(always)]
pub(super) fn solve<const D: usize, R: Real>(a: [[R; D]; D], b: [R; D]) -> ([R; D], [R::Mask; 2]) {
    let Elimination { solution, pivots, exchanges } = elimination::eliminate::<true, D, R>(a, b);
    let sure = exchanges == 0 && pivots.iter().all(|&pivot| R::ZERO.less(pivot).all());
    (solution, [Mask::of(sure || may_continue(a)), Mask::of(sure)])
}

#[cold]
#[inline(never)]
fn may_continue<const D: usize, R: Real>(a: [[R; D]; D]) -> bool {
    // Without an exchange of rows: then leading determinants are positive, all of A among them.
    let (_, pivots) = elimination::solve_definite(a, [R::ZERO; D]);
    if pivots.iter().all(|&pivot| R::ZERO.less(pivot).all()) {
        return true;
    }
    let a = a.map(|row| row.map(R::to_f64));
    !Settled::<D, R>::MANY && !has_symmetric_form(&a) && elimination::orientation(a) > 0.0
}

/// Whether rows can be multiplied by positive numbers, as by masses, so that A is symmetric, to the rounding of what is on its
/// diagonal. An entry opposite to which there is none is in no pivot, unless a way along others leads back.
fn has_symmetric_form<const D: usize>(a: &[[f64; D]; D]) -> bool {
    const ROUNDING: f64 = 1e-11;
    let mut leads = a.map(|row| row.map(|x| x != 0.0));
    for k in 0..D {
        for i in 0..D {
            for j in 0..D {
                leads[i][j] |= leads[i][k] && leads[k][j];
            }
        }
    }
    let mut factors = [0.0; D];
    for first in 0..D {
        if factors[first] == 0.0 {
            factors[first] = 1.0;
        }
        // From row to row along entries, as far as they lead.
        for _ in 0..D {
            for i in 0..D {
                for j in 0..D {
                    let factor = factors[i] * (a[i][j] / a[j][i]);
                    if factors[j] == 0.0 && factor > 0.0 && factor.is_finite() {
                        factors[j] = factor;
                    }
                }
            }
        }
    }
    (0..D).all(|i| {
        (0..i).all(|j| {
            let [x, y] = [factors[i] * a[i][j], factors[j] * a[j][i]];
            let sizes = x.abs() + y.abs() + factors[i] * a[i][i].abs() + factors[j] * a[j][j].abs();
            let one_way = |from: usize, to: usize| a[from][to] == 0.0 && !leads[from][to];
            one_way(i, j) || one_way(j, i) || (x - y).abs() <= ROUNDING * sizes
        })
    })
}
