//! One correction of Newton's method.

use crate::expression::{Expr, Graph};
use crate::linear::{self, Corrections, Solution};
use crate::program::Program;

use super::step::{Given, Step};
use super::variables::Variables;

/// 1 + g J.
pub(super) fn newton_matrix(graph: &mut Graph, jacobian: &[Vec<Expr>], variables: &Variables) -> Vec<Vec<Expr>> {
    let n = jacobian.len();
    let g = graph.symbol(variables.g);
    let one = graph.one();
    (0..n)
        .map(|i| {
            (0..n)
                .map(|j| {
                    let scaled = graph.mul(&[g, jacobian[i][j]]);
                    if i == j { graph.add(&[one, scaled]) } else { scaled }
                })
                .collect()
        })
        .collect()
}

/// One Newton correction of  Δ + g G = rhs:  (1 + g J) δ = rhs − g G − Δ, the force after it, and what is positive only where
/// the solution has [grown from a step of no length](linear::Solution::positive).
pub(super) fn correction(
    graph: &mut Graph,
    force: &[Expr],
    jacobian: &[Vec<Expr>],
    corrections: Corrections,
    given: Given,
    variables: &Variables,
) -> Step {
    let n = force.len();
    let g = graph.symbol(variables.g);
    let matrix = newton_matrix(graph, jacobian, variables);
    let residual: Vec<_> = (0..n)
        .map(|i| {
            let (rhs, delta) = (graph.symbol(variables.rhs[i]), graph.symbol(variables.delta[i]));
            let pull = graph.mul(&[g, force[i]]);
            let difference = graph.sub(rhs, pull);
            graph.sub(difference, delta)
        })
        .collect();
    let Solution { x: delta, positive, asked } = linear::solve(graph, &matrix, &residual, corrections);
    let turned: Vec<_> = jacobian.iter().map(|row| dot(graph, row, &delta)).collect();
    let mut outputs = match given {
        Given::InParts => [delta, force.to_vec(), turned].concat(),
        Given::Rounded => {
            let updated = force.iter().zip(&turned).map(|(&force, &turned)| graph.add(&[force, turned])).collect();
            [delta, force.to_vec(), updated].concat()
        }
    };
    outputs.extend(positive);
    Step { way: corrections.into(), given, asked, program: Program::schedule(graph, &outputs) }
}

/// x·y.
pub(super) fn dot(graph: &mut Graph, x: &[Expr], y: &[Expr]) -> Expr {
    let terms: Vec<_> = x.iter().zip(y).map(|(&x, &y)| graph.mul(&[x, y])).collect();
    graph.add(&terms)
}

/// What is above the diagonal on both sides: of a matrix that is symmetric, but not as it is written.
pub(super) fn mirrored(matrix: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
    (0..matrix.len()).map(|i| (0..matrix.len()).map(|j| matrix[i.min(j)][i.max(j)]).collect()).collect()
}
