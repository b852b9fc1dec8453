//! Symbolic solution of A x = r: closed forms for up to three unknowns, elimination without pivoting above.
//!
//! The matrices are 1 + g H of implicit steps, near the unit matrix when the step resolves the motion. Zeros cost
//! nothing: products with 0 vanish as they are built.

use crate::expression::{Expr, Graph};

/// x with A x = r. `symmetric` says that A is, so that LDLᵀ serves; else LU.
pub fn solve(graph: &mut Graph, a: &[Vec<Expr>], r: &[Expr], symmetric: bool) -> Vec<Expr> {
    let n = r.len();
    let diagonal = (0..n).all(|i| (0..n).all(|j| i == j || graph.is_zero(a[i][j])));
    match n {
        _ if diagonal => (0..n).map(|i| graph.div(r[i], a[i][i])).collect(),
        2 | 3 => cramer(graph, a, r),
        _ => eliminate(graph, a, r, symmetric),
    }
}

/// Cramer's rule, by cofactors.
fn cramer(g: &mut Graph, a: &[Vec<Expr>], r: &[Expr]) -> Vec<Expr> {
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
    (0..n)
        .map(|j| {
            let column: Vec<_> = (0..n).map(|i| g.mul(&[cofactors[i][j], r[i]])).collect();
            let sum = g.add(&column);
            g.div(sum, determinant)
        })
        .collect()
}

/// Gaussian elimination: A = L D Lᵀ where A is symmetric, A = L U otherwise.
fn eliminate(g: &mut Graph, a: &[Vec<Expr>], r: &[Expr], symmetric: bool) -> Vec<Expr> {
    let n = r.len();
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
    x
}
