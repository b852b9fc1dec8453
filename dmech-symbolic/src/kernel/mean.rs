//! The kick of a force that is linear in the velocity, taken at the mean velocity of the kick.
//!
//! ```text
//! v′ = v − c (∇Φ − F(q, (v + v′)/2)),   F = f + S v
//! ```
//!
//! is linear in v′. With A = c S/2 it is half a kick by f − ∇Φ, the Cayley map (1 − A)⁻¹(1 + A), and the other half. Where
//! S is antisymmetric that map is a rotation, for which J. P. Boris has two cross products (Proc. Fourth Conf. Num. Sim.
//! Plasmas, Naval Research Laboratory, 1970, p. 3).

use crate::calculus;
use crate::expression::{Expr, Graph, Substitution, Symbol};
use crate::linear;
use crate::program::Program;

use super::forced::expand;
use super::newton::dot;
use super::variables::Variables;

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
        if force.iter().any(|&f| !graph.choices(f, v).is_empty()) {
            return None;
        }
        for &entry in force_dv.iter().flatten() {
            if graph.depends_on(entry, v) {
                for second in calculus::tangent(graph, entry, v) {
                    let second = expand(graph, second);
                    if !graph.is_zero(second) {
                        return None;
                    }
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
    pub(super) fn kick(&self, graph: &mut Graph, gradient: &[Expr], variables: &Variables) -> Program {
        let c = graph.symbol(variables.c);
        let half = graph.scale(0.5, c);
        let v = graph.symbols(&variables.v);
        let a: Vec<Vec<_>> =
            self.by_velocity.iter().map(|row| row.iter().map(|&s| graph.mul(&[half, s])).collect()).collect();
        let push: Vec<_> = self.at_rest.iter().zip(gradient).map(|(&f, &g)| graph.sub(f, g)).collect();
        let kicked = if v.len() <= 3 && self.is_antisymmetric(graph) {
            let push: Vec<_> = push.iter().map(|&p| graph.mul(&[half, p])).collect();
            let before = add(graph, &v, &push);
            let turned = rotate(graph, &a, &before);
            add(graph, &turned, &push)
        } else {
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
            let change = linear::solve(graph, &matrix, &change, false);
            add(graph, &v, &change)
        };
        Program::schedule(graph, &kicked)
    }

    fn is_antisymmetric(&self, graph: &mut Graph) -> bool {
        let s = &self.by_velocity;
        (0..s.len()).all(|i| {
            (0..=i).all(|j| {
                let sum = graph.add(&[s[i][j], s[j][i]]);
                let sum = expand(graph, sum);
                graph.is_zero(sum)
            })
        })
    }
}

/// (1 − A)⁻¹(1 + A) v = v + 2 A (v + A v)/(1 + |a|²) of an antisymmetric A in up to three coordinates, |a|² being the sum of
/// the squares above its diagonal.
fn rotate(graph: &mut Graph, a: &[Vec<Expr>], v: &[Expr]) -> Vec<Expr> {
    let n = v.len();
    let squares: Vec<_> =
        (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))).map(|(i, j)| graph.square(a[i][j])).collect();
    let one = graph.one();
    let squared = graph.add(&squares);
    let denominator = graph.add(&[one, squared]);
    let two = graph.number(2.0);
    let factor = graph.div(two, denominator);
    let turn = |graph: &mut Graph, v: &[Expr]| -> Vec<Expr> { a.iter().map(|row| dot(graph, row, v)).collect() };
    let turned = turn(graph, v);
    let halfway = add(graph, v, &turned);
    let turned = turn(graph, &halfway);
    let turned: Vec<_> = turned.iter().map(|&e| graph.mul(&[factor, e])).collect();
    add(graph, v, &turned)
}

/// x + y.
fn add(graph: &mut Graph, x: &[Expr], y: &[Expr]) -> Vec<Expr> {
    x.iter().zip(y).map(|(&x, &y)| graph.add(&[x, y])).collect()
}

/// 1 − A.
fn one_less(graph: &mut Graph, a: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
    let entry = |graph: &mut Graph, i: usize, j: usize| {
        let unit = graph.number(f64::from(u8::from(i == j)));
        graph.sub(unit, a[i][j])
    };
    (0..a.len()).map(|i| (0..a.len()).map(|j| entry(graph, i, j)).collect()).collect()
}
