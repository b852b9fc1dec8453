//! The kick of a force that is linear in the velocity, taken at the mean velocity of the kick.
//!
//! ```text
//! v′ = v − c (∇Φ − F(q, (v + v′)/2)),   F = f + S v
//! ```
//!
//! is linear in v′. With A = c S/2 it is half a kick by f − ∇Φ, the Cayley map (1 − A)⁻¹(1 + A), and the other half. Where
//! S is antisymmetric that map is a rotation.

use crate::calculus;
use crate::expression::{Expr, Graph, Node, Substitution, Symbol};
use crate::linear::{self, Corrections};
use crate::program::Program;

use super::newton::dot;
use super::vanishes::vanishes;
use super::variables::Variables;

/// The kick by a force at its mean velocity.
#[derive(Clone, Debug)]
pub enum KickByMean {
    /// v′ in closed form.
    Solved(Program),
    /// S is antisymmetric in two or three coordinates. Outputs: the entries of A above its diagonal, row by row; after them
    /// c (f − ∇Φ)/2, if that does not vanish.
    Rotation(Program),
}

/// A force f(q) + S(q) v.
pub(super) struct LinearForce {
    /// f.
    at_rest: Vec<Expr>,
    /// S.
    by_velocity: Vec<Vec<Expr>>,
}

impl LinearForce {
    /// None where ∂²F/∂v∂v is not seen to vanish, or the velocity makes a choice.
    pub(super) fn of(graph: &mut Graph, force: &[Expr], force_dv: &[Vec<Expr>], v: &[Symbol]) -> Option<Self> {
        if !is_polynomial(graph, force, v) {
            return None;
        }
        for &entry in force_dv.iter().flatten() {
            if graph.depends_on(entry, v) {
                let second = calculus::tangent(graph, entry, v);
                if !second.into_iter().all(|second| vanishes(graph, second)) {
                    return None;
                }
            }
        }
        let zero = graph.number(0.0);
        let mut rest = Substitution::new(graph, v.iter().map(|&v| (v, zero)));
        let at_rest = force.iter().map(|&f| rest.apply(graph, f)).collect();
        let by_velocity = force_dv.iter().map(|row| row.iter().map(|&e| rest.apply(graph, e)).collect()).collect();
        Some(LinearForce { at_rest, by_velocity })
    }

    /// v′ from v.
    pub(super) fn kick(&self, graph: &mut Graph, gradient: &[Expr], variables: &Variables) -> KickByMean {
        let c = graph.symbol(variables.c);
        let half = graph.scale(0.5, c);
        let v = graph.symbols(&variables.v);
        let a: Vec<Vec<_>> =
            self.by_velocity.iter().map(|row| row.iter().map(|&s| graph.mul(&[half, s])).collect()).collect();
        let push: Vec<_> = self.at_rest.iter().zip(gradient).map(|(&f, &g)| graph.sub(f, g)).collect();
        if (2..=3).contains(&v.len()) && self.is_antisymmetric(graph) {
            let mut outputs = (0..a.len()).flat_map(|i| a[i][i + 1..].iter().copied()).collect::<Vec<_>>();
            if push.iter().any(|&p| !graph.is_zero(p)) {
                outputs.extend(push.iter().map(|&p| graph.mul(&[half, p])));
            }
            return KickByMean::Rotation(Program::schedule(graph, &outputs));
        }
        let change: Vec<_> = a
            .iter()
            .zip(&push)
            .map(|(row, &push)| {
                let (push, turn) = (graph.mul(&[c, push]), dot(graph, row, &v));
                let turn = graph.scale(2.0, turn);
                graph.add(&[push, turn])
            })
            .collect();
        let matrix = one_less(graph, &a);
        let change = linear::solve(graph, &matrix, &change, Corrections::Unasked).x;
        let kicked: Vec<_> = v.iter().zip(&change).map(|(&v, &change)| graph.add(&[v, change])).collect();
        KickByMean::Solved(Program::schedule(graph, &kicked))
    }

    fn is_antisymmetric(&self, graph: &mut Graph) -> bool {
        let s = &self.by_velocity;
        (0..s.len()).all(|i| {
            (0..=i).all(|j| {
                let sum = graph.add(&[s[i][j], s[j][i]]);
                vanishes(graph, sum)
            })
        })
    }
}

/// Whether the velocity stands in sums and products alone, so that formulas have their value at rest; where they stand it may be left
/// to a choice, which the velocity does not make.
fn is_polynomial(graph: &mut Graph, force: &[Expr], v: &[Symbol]) -> bool {
    let moves = graph.dependence(v);
    graph.reachable(force).into_iter().filter(|e| moves[e.index()]).all(|e| match graph.node(e) {
        Node::Symbol(_) | Node::Sum { .. } => true,
        Node::Select(condition, ..) => !condition.operands().iter().any(|e| moves[e.index()]),
        Node::Product { factors, .. } => factors.iter().all(|&(f, n)| n > 0 || !moves[f.index()]),
        _ => false,
    })
}

/// 1 − A.
fn one_less(graph: &mut Graph, a: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
    let entry = |graph: &mut Graph, i: usize, j: usize| {
        let unit = graph.number(f64::from(u8::from(i == j)));
        graph.sub(unit, a[i][j])
    };
    (0..a.len()).map(|i| (0..a.len()).map(|j| entry(graph, i, j)).collect()).collect()
}
