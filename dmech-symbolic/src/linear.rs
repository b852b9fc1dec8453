//! Symbolic solution of A x = r: closed forms for up to three unknowns, elimination without exchange of rows above, and for a
//! matrix that must be positive definite always.
//!
//! The matrices are 1 + g H of implicit steps, near the unit matrix when the step resolves the motion. Zeros cost
//! nothing: products with 0 vanish as they are built.

use crate::expression::{Expr, Graph};

/// The solution of A x = r, and where A has it from.
#[derive(Clone, Debug)]
pub struct Solution {
    /// x.
    pub x: Vec<Expr>,
    /// What is positive where A has grown from the unit matrix without having been singular on the way: pivots or leading
    /// minors of a symmetric A, all of which are positive only if A is positive definite; of any other A its determinant,
    /// which an even number of changes of sign would leave positive too.
    pub positive: Vec<Expr>,
}

/// What is known of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matrix {
    /// Nothing: LU, or Cramer's rule.
    General,
    /// It is symmetric: LDLᵀ, or Cramer's rule.
    Symmetric,
    /// It is symmetric and must be positive definite: LDLᵀ, stable whatever its condition is. The determinants of Cramer's rule lose
    /// the digits that a stiff and a soft direction have in common.
    Definite,
}

/// x with A x = r.
pub fn solve(graph: &mut Graph, a: &[Vec<Expr>], r: &[Expr], known: Matrix) -> Solution {
    let n = r.len();
    let diagonal = (0..n).all(|i| (0..n).all(|j| i == j || graph.is_zero(a[i][j])));
    let mut solution = match n {
        _ if diagonal => Solution {
            x: (0..n).map(|i| graph.div(r[i], a[i][i])).collect(),
            positive: (0..n).map(|i| a[i][i]).collect(),
        },
        2 | 3 if known != Matrix::Definite => cramer(graph, a, r, known),
        _ => eliminate(graph, a, r, known),
    };
    // Each once, and not what is 1 whatever the step is.
    let mut seen = vec![graph.one()];
    solution.positive.retain(|x| {
        !seen.contains(x) && {
            seen.push(*x);
            true
        }
    });
    solution
}

/// Cramer's rule, by cofactors.
fn cramer(g: &mut Graph, a: &[Vec<Expr>], r: &[Expr], known: Matrix) -> Solution {
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
    // The leading minor of two rows of three is the last cofactor.
    let leading = [a[0][0], cofactors[n - 1][n - 1]];
    let minors = if known == Matrix::Symmetric { &leading[..n - 1] } else { &[] };
    let positive = [minors, &[determinant]].concat();
    let x = (0..n)
        .map(|j| {
            let column: Vec<_> = (0..n).map(|i| g.mul(&[cofactors[i][j], r[i]])).collect();
            let sum = g.add(&column);
            g.div(sum, determinant)
        })
        .collect();
    Solution { x, positive }
}

/// Gaussian elimination: A = L D Lᵀ where A is symmetric, A = L U otherwise.
fn eliminate(g: &mut Graph, a: &[Vec<Expr>], r: &[Expr], known: Matrix) -> Solution {
    let (n, symmetric) = (r.len(), known != Matrix::General);
    let (mut a, mut r) = (a.to_vec(), r.to_vec());
    for k in 0..n {
        for i in k + 1..n {
            if g.is_zero(a[i][k]) {
                continue;
            }
            let multiplier = g.div(a[i][k], a[k][k]);
            // Below the diagonal of a symmetric remainder stands what is above it.
            let columns = if symmetric { i..n } else { k + 1..n };
            for j in columns {
                let product = g.mul(&[multiplier, a[k][j]]);
                a[i][j] = g.sub(a[i][j], product);
                if symmetric {
                    a[j][i] = a[i][j];
                }
            }
            let product = g.mul(&[multiplier, r[k]]);
            r[i] = g.sub(r[i], product);
        }
    }
    let mut x = r.clone();
    for i in (0..n).rev() {
        let mut sum = r[i];
        for j in i + 1..n {
            let product = g.mul(&[a[i][j], x[j]]);
            sum = g.sub(sum, product);
        }
        x[i] = g.div(sum, a[i][i]);
    }
    let pivots: Vec<_> = (0..n).map(|i| a[i][i]).collect();
    let positive = if symmetric { pivots } else { vec![g.mul(&pivots)] };
    Solution { x, positive }
}
