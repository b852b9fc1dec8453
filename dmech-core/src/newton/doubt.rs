//! Whether a root continues that of a shorter step, by the matrix 1 + g J there.
//!
//! It grows from the unit matrix with the step, and on the way is not singular: its determinant is positive, and where J is symmetric, its
//! rows divided by masses or not, it is positive definite.

use core::cell::Cell;

use dmech_scalar::{Mask, Real};

use super::elimination::{self, Elimination};
use super::settled::Settled;
use super::{Correction, Equation};

/// What is asked of a root that was found.
pub(super) trait Ask: Copy {
    /// The factors of the last correction show at once that the root is a continued one.
    fn sure(&self) -> bool;
    /// The matrix of the next correction is wanted.
    fn open(&self);
    /// Whether it may be that at a root which continues that of a shorter step. Of several side by side only what is plain is said;
    /// the others are left to each alone.
    fn continues(&self) -> bool;
}

/// Nothing is asked.
impl Ask for () {
    #[inline(always)]
    fn sure(&self) -> bool {
        true
    }
    #[inline(always)]
    fn open(&self) {}
    #[inline(always)]
    fn continues(&self) -> bool {
        true
    }
}

/// As long as steps resolve the motion no rows are exchanged, all pivots are positive, and there is no doubt. Where there is, the
/// matrix at the root tells.
pub(super) struct Doubt<const D: usize, R: Real> {
    sure: Cell<bool>,
    wanted: Cell<bool>,
    matrix: Cell<[[R; D]; D]>,
}

impl<const D: usize, R: Real> Doubt<D, R> {
    #[inline(always)]
    pub(super) fn none() -> Self {
        Doubt { sure: Cell::new(true), wanted: Cell::new(false), matrix: Cell::new([[R::ZERO; D]; D]) }
    }

    /// A x = b, and whether there is a doubt about A.
    #[inline(always)]
    pub(super) fn solve(&self, a: [[R; D]; D], b: [R; D]) -> [R; D] {
        if self.wanted.take() {
            self.matrix.set(a);
        }
        let Elimination { solution, pivots, exchanges } = elimination::eliminate::<true, D, R>(a, b);
        self.sure.set(exchanges == 0 && pivots.iter().all(|&pivot| R::ZERO.less(pivot).all()));
        solution
    }
}

impl<const D: usize, R: Real> Ask for &Doubt<D, R> {
    #[inline(always)]
    fn sure(&self) -> bool {
        self.sure.get()
    }
    fn open(&self) {
        self.wanted.set(true);
    }
    fn continues(&self) -> bool {
        may_continue(self.matrix.get())
    }
}

/// Whether the root Δ is a continued one, as far as the matrix tells.
#[inline(always)]
pub(super) fn is_continued<const D: usize, R: Real>(
    equation: &Equation<D, R>,
    delta: [R; D],
    correct: &mut impl FnMut(&Equation<D, R>, [R; D], [R; D]) -> Correction<D, R>,
    ask: impl Ask,
) -> bool {
    ask.sure() || {
        ask.open();
        correct(equation, delta, equation.end(delta));
        ask.continues()
    }
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
