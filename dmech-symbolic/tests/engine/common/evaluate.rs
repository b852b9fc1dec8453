//! The evaluation of expressions over any kind of number: independent of the engine's interpreter, and lazy, so that of a
//! choice only the branch taken is evaluated.

use std::collections::HashMap;

use dmech_symbolic::expression::{Condition, Expr, Graph, Node, Relation, Symbol};

use super::algebra::Algebra;

/// The values of expressions.
pub(crate) fn evaluate<T: Algebra>(graph: &Graph, roots: &[Expr], symbol: &dyn Fn(Symbol) -> T) -> Vec<T> {
    let mut evaluation = Evaluation { graph, symbol, known: HashMap::new() };
    roots.iter().map(|&e| evaluation.value(e)).collect()
}

struct Evaluation<'a, T> {
    graph: &'a Graph,
    symbol: &'a dyn Fn(Symbol) -> T,
    known: HashMap<Expr, T>,
}

impl<T: Algebra> Evaluation<'_, T> {
    fn value(&mut self, e: Expr) -> T {
        if let Some(known) = self.known.get(&e) {
            return known.clone();
        }
        let value = match self.graph.node(e) {
            Node::Number(n) => T::number(n.value()),
            Node::Symbol(s) => (self.symbol)(*s),
            Node::Sum { constant, terms } => terms.iter().fold(T::number(constant.value()), |sum, &(c, t)| {
                sum.plus(&T::number(c.value()).times(&self.value(t)))
            }),
            Node::Product { coefficient, factors } => factors
                .iter()
                .fold(T::number(coefficient.value()), |product, &(f, n)| product.times(&self.value(f).power(n))),
            Node::Unary(f, u) => self.value(*u).unary(*f),
            Node::Binary(f, u, w) => {
                let (u, w) = (self.value(*u), self.value(*w));
                u.binary(*f, &w)
            }
            Node::Select(condition, yes, no) => {
                if self.holds(condition) {
                    self.value(*yes)
                } else {
                    self.value(*no)
                }
            }
        };
        self.known.insert(e, value.clone());
        value
    }

    fn holds(&mut self, condition: &Condition) -> bool {
        match condition {
            Condition::Compare(relation, left, right) => {
                let (left, right) = (self.value(*left), self.value(*right));
                match relation {
                    Relation::Less => left.less(&right),
                    Relation::LessOrEqual => !right.less(&left),
                    Relation::Equal => !left.less(&right) && !right.less(&left),
                }
            }
            Condition::Not(inner) => !self.holds(inner),
            Condition::And(one, two) => self.holds(one) && self.holds(two),
            Condition::Or(one, two) => self.holds(one) || self.holds(two),
        }
    }
}
