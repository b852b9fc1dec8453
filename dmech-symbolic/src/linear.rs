//! Symbolic solution of A x = r by elimination without exchange of rows.
//!
//! The matrices are 1 + g H of implicit steps, near the unit matrix when the step resolves the motion. Zeros cost
//! nothing: products with 0 vanish as they are built. No determinants of Cramer's rule: they lose the digits that a stiff and a soft
//! direction have in common, and in small units leave the range of the numbers.

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
}

/// x with A x = r: A = L D Lᵀ where A is symmetric, A = L U otherwise.
pub fn solve(g: &mut Graph, a: &[Vec<Expr>], r: &[Expr]) -> Solution {
    let n = r.len();
    // Equal expressions are one expression.
    let symmetric = (0..n).all(|i| (0..i).all(|j| a[i][j] == a[j][i]));
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
        // Quotients that do not wait for x, and that elimination has formed where A is symmetric.
        x[i] = g.div(r[i], a[i][i]);
        for j in i + 1..n {
            let multiplier = g.div(a[i][j], a[i][i]);
            let product = g.mul(&[multiplier, x[j]]);
            x[i] = g.sub(x[i], product);
        }
    }
    let pivots: Vec<_> = (0..n).map(|i| a[i][i]).collect();
    let mut positive = if symmetric { pivots } else { vec![g.mul(&pivots)] };
    // Each once, and not what is 1 whatever the step is.
    let mut seen = vec![g.one()];
    positive.retain(|x| {
        !seen.contains(x) && {
            seen.push(*x);
            true
        }
    });
    Solution { x, positive }
}
