//! Replacing symbols by expressions.

use crate::hash::Map;

use super::{Expr, Graph, Node, Symbol};

/// A replacement of symbols, remembered for every expression it has been applied to.
#[derive(Clone, Debug, Default)]
pub struct Substitution {
    done: Map<Expr, Expr>,
}

impl Substitution {
    /// Replaces each symbol by the expression beside it, all at once.
    pub fn new(graph: &mut Graph, pairs: impl IntoIterator<Item = (Symbol, Expr)>) -> Self {
        let done = pairs.into_iter().map(|(symbol, e)| (graph.symbol(symbol), e)).collect();
        Self { done }
    }

    /// Replaces whole expressions, not only symbols.
    pub fn of_expressions(pairs: impl IntoIterator<Item = (Expr, Expr)>) -> Self {
        Self { done: pairs.into_iter().collect() }
    }

    /// Replaces this expression too, unless it is replaced already.
    pub(crate) fn remember(&mut self, e: Expr, image: Expr) {
        self.done.entry(e).or_insert(image);
    }

    /// The expression after the replacement, in normal form.
    pub fn apply(&mut self, graph: &mut Graph, e: Expr) -> Expr {
        let mut missing = vec![e];
        while let Some(&top) = missing.last() {
            if self.done.contains_key(&top) {
                missing.pop();
                continue;
            }
            let known = missing.len();
            graph.each_child(top, |c| {
                if !self.done.contains_key(&c) {
                    missing.push(c);
                }
            });
            if missing.len() == known {
                let image = self.rebuild(graph, top);
                self.done.insert(top, image);
                missing.pop();
            } else {
                missing[known..].reverse();
            }
        }
        self.done[&e]
    }

    fn rebuild(&self, graph: &mut Graph, e: Expr) -> Expr {
        match graph.node(e).clone() {
            Node::Number(_) | Node::Symbol(_) => e,
            Node::Sum { constant, terms } => {
                let constant = graph.number(constant.value());
                let mut summands: Vec<_> = terms.iter().map(|&(c, t)| (c, self.done[&t])).collect();
                summands.push((super::Number::ONE, constant));
                graph.linear_combination(&summands)
            }
            Node::Product { coefficient, factors } => {
                let factors = factors.iter().map(|&(f, n)| (self.done[&f], n)).collect();
                graph.product_of(coefficient, factors)
            }
            Node::Unary(f, u) => graph.unary(f, self.done[&u]),
            Node::Binary(f, u, w) => graph.binary(f, self.done[&u], self.done[&w]),
            Node::Select(condition, yes, no) => {
                let condition = condition.map(&mut |c| self.done[&c]);
                graph.select(condition, self.done[&yes], self.done[&no])
            }
        }
    }
}
