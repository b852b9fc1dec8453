//! Symbolic solution of A x = r by elimination without exchange of rows.
//!
//! The matrices are 1 + g H of implicit steps, near the unit matrix when the step resolves the motion. Zeros cost
//! nothing: products with 0 vanish as they are built. Cramer's rule loses the digits that a stiff and a soft direction have in
//! common; it is for what has no symmetry and one chance only.

use crate::expression::{Expr, Graph};

/// The solution of A x = r, and where A has it from.
#[derive(Clone, Debug)]
pub struct Solution {
    /// x.
    pub x: Vec<Expr>,
    /// What is positive where A has grown from the unit matrix without having been singular on the way: the pivots of a symmetric
    /// A, all of which are positive only if A is positive definite; of any other A its determinant, which an even number of
    /// changes of sign would leave positive too.
    pub positive: Vec<Expr>,
    /// What these numbers are.
    pub asked: Asked,
}

/// Of which numbers it is asked whether they are positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    /// Of all pivots, or of the determinant alone.
    Positive,
    /// Of the determinant, and then of the pivots: where they are positive as well there is no doubt.
    Oriented,
}

/// How often a correction is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corrections {
    /// One leads to the root: a pivot near 0 must not spoil it.
    One,
    /// The same, and nobody asks what is positive.
    Unasked,
    /// Each puts the last one right.
    Several,
}

impl Corrections {
    /// Of an equation that is linear, or not.
    pub(crate) fn of(linear: bool) -> Self {
        if linear { Self::One } else { Self::Several }
    }
}

/// x with A x = r: A = L D Lᵀ where A is symmetric, A = L U where it is not; Cramer's rule for two or three unknowns of one correction
/// that no pivots are asked of.
pub fn solve(g: &mut Graph, a: &[Vec<Expr>], r: &[Expr], corrections: Corrections) -> Solution {
    let n = r.len();
    // The last two unknowns without a quotient between them, times the pivot, are one division less to wait for; but what rounding does
    // then is not for the only correction.
    let several = corrections == Corrections::Several;
    let symmetric = is_symmetric(a);
    let diagonal = (0..n).all(|i| (0..n).all(|j| i == j || g.is_zero(a[i][j])));
    if n <= 3 && !diagonal && (corrections == Corrections::Unasked || !symmetric && !several) {
        return cramer(g, a, r);
    }
    let (mut a, mut r) = (a.to_vec(), r.to_vec());
    for k in 0..n {
        let last = k + 2 == n && several;
        for i in k + 1..n {
            if g.is_zero(a[i][k]) {
                continue;
            }
            let [multiplier, scale] = if last { [a[i][k], a[k][k]] } else { [g.div(a[i][k], a[k][k]), g.one()] };
            let less = |g: &mut Graph, x: Expr, y: Expr| {
                let [x, y] = [g.mul(&[scale, x]), g.mul(&[multiplier, y])];
                g.sub(x, y)
            };
            // Below the diagonal of a symmetric remainder stands what is above it.
            let columns = if symmetric { i..n } else { k + 1..n };
            for j in columns {
                a[i][j] = less(g, a[i][j], a[k][j]);
                if symmetric {
                    a[j][i] = a[i][j];
                }
            }
            r[i] = less(g, r[i], r[k]);
        }
    }
    let mut x = r.clone();
    for i in (0..n).rev() {
        // The quotients of all but the last two are there from the elimination, where A is symmetric.
        let early = i + 2 < n && several;
        let mut sum = if early { g.div(r[i], a[i][i]) } else { r[i] };
        for j in i + 1..n {
            let multiplier = if early { g.div(a[i][j], a[i][i]) } else { a[i][j] };
            let product = g.mul(&[multiplier, x[j]]);
            sum = g.sub(sum, product);
        }
        x[i] = if early { sum } else { g.div(sum, a[i][i]) };
    }
    // The last pivot times the one before it is positive where both are.
    let pivots: Vec<_> = (0..n).map(|i| a[i][i]).collect();
    if !symmetric {
        let doubled = several && !g.is_zero(a[n - 1][n - 2]);
        let factors: Vec<_> = (0..n).filter(|i| !doubled || i + 2 != n).map(|i| pivots[i]).collect();
        let determinant = g.mul(&factors);
        return match several {
            true => Solution { x, positive: [vec![determinant], pivots].concat(), asked: Asked::Oriented },
            false => Solution { x, positive: vec![determinant], asked: Asked::Positive },
        };
    }
    // Each once, and not what is 1 whatever the step is.
    let mut seen = vec![g.one()];
    let positive = pivots.into_iter().filter(|pivot| {
        let new = !seen.contains(pivot);
        seen.push(*pivot);
        new
    });
    Solution { x, positive: positive.collect(), asked: Asked::Positive }
}

/// Whether it is so as it is written: equal expressions are one expression.
pub fn is_symmetric(a: &[Vec<Expr>]) -> bool {
    (0..a.len()).all(|i| (0..i).all(|j| a[i][j] == a[j][i]))
}

/// Cramer's rule, by cofactors.
fn cramer(g: &mut Graph, a: &[Vec<Expr>], r: &[Expr]) -> Solution {
    let n = r.len();
    let mut minor = |i: usize, j: usize| -> Expr {
        let rows: Vec<_> = (0..n).filter(|&k| k != i).collect();
        let columns: Vec<_> = (0..n).filter(|&k| k != j).collect();
        let determinant = if n == 2 {
            a[rows[0]][columns[0]]
        } else {
            let one = g.mul(&[a[rows[0]][columns[0]], a[rows[1]][columns[1]]]);
            let other = g.mul(&[a[rows[0]][columns[1]], a[rows[1]][columns[0]]]);
            g.sub(one, other)
        };
        if (i + j).is_multiple_of(2) { determinant } else { g.neg(determinant) }
    };
    let cofactors: Vec<Vec<Expr>> = (0..n).map(|i| (0..n).map(|j| minor(i, j)).collect()).collect();
    let expansion: Vec<_> = (0..n).map(|j| g.mul(&[a[0][j], cofactors[0][j]])).collect();
    let determinant = g.add(&expansion);
    let x = (0..n)
        .map(|j| {
            let column: Vec<_> = (0..n).map(|i| g.mul(&[cofactors[i][j], r[i]])).collect();
            let sum = g.add(&column);
            g.div(sum, determinant)
        })
        .collect();
    Solution { x, positive: vec![determinant], asked: Asked::Positive }
}
