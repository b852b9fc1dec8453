//! Sums in normal form.
//!
//! | rule | domain |
//! |---|---|
//! | (a + b) + c = a + b + c, sorted | all |
//! | −(a + b) = −a − b inside a sum | all |
//! | c t + d t = (c + d) t where c + d is exact | all |
//! | 0 + a = a; 0·t = 0 | t finite |
//!
//! Numbers that have no exact sum stand among the terms, so that a sum built in another order is the same.

use super::number::combined;
use super::{Expr, Graph, Node, Number};

impl Graph {
    /// The sum of expressions; 0 if there are none.
    pub fn add(&mut self, summands: &[Expr]) -> Expr {
        let weighted: Vec<_> = summands.iter().map(|&e| (Number::ONE, e)).collect();
        self.linear_combination(&weighted)
    }

    /// left − right.
    pub fn sub(&mut self, left: Expr, right: Expr) -> Expr {
        self.linear_combination(&[(Number::ONE, left), (Number::ONE.negated(), right)])
    }

    /// −e.
    pub fn neg(&mut self, e: Expr) -> Expr {
        self.scale(-1.0, e)
    }

    /// (left + right)/2.
    pub fn mean(&mut self, left: Expr, right: Expr) -> Expr {
        let sum = self.add(&[left, right]);
        self.scale(0.5, sum)
    }

    /// Σ cᵢ eᵢ.
    pub(crate) fn linear_combination(&mut self, summands: &[(Number, Expr)]) -> Expr {
        let mut constants: Vec<Number> = vec![];
        let mut terms: Vec<(Number, Expr)> = vec![];
        for &(c, e) in summands {
            self.flatten_into(c, e, &mut constants, &mut terms);
        }
        let constants = combined(constants, Number::exact_sum);
        let (constant, apart) = match constants[..] {
            [] => (Number::ZERO, vec![]),
            [constant] => (constant, vec![]),
            _ => (Number::ZERO, constants),
        };
        terms.sort_by_key(|&(_, t)| t);
        let mut merged: Vec<(Number, Expr)> = vec![];
        for (c, t) in terms {
            // The same term may stand twice where its coefficients have no exact sum.
            let partner = merged.iter_mut().rev().take_while(|m| m.1 == t).find_map(|m| Some((m.0.exact_sum(c)?, m)));
            match partner {
                Some((sum, slot)) => slot.0 = sum,
                None => merged.push((c, t)),
            }
        }
        if !apart.is_empty() {
            for c in apart {
                let sign = if c.value() < 0.0 { Number::ONE.negated() } else { Number::ONE };
                merged.push((sign, self.number(c.value().abs())));
            }
            merged.sort_by_key(|&(_, t)| t);
        }
        merged.retain(|&(c, _)| c != Number::ZERO);
        match (&merged[..], constant) {
            ([], constant) => self.intern(Node::Number(constant)),
            (&[(c, t)], Number::ZERO) => self.scale(c.value(), t),
            _ => self.intern(Node::Sum { constant, terms: merged.into() }),
        }
    }

    fn flatten_into(&mut self, c: Number, e: Expr, constants: &mut Vec<Number>, terms: &mut Vec<(Number, Expr)>) {
        let unit = c == Number::ONE || c == Number::ONE.negated();
        match self.node(e).clone() {
            Node::Number(n) => match c.exact_product(n) {
                Some(product) => constants.push(product),
                None => terms.push((c, e)),
            },
            Node::Sum { constant, terms: inner } if unit => {
                constants.push(if c == Number::ONE { constant } else { constant.negated() });
                for &(d, t) in &inner {
                    let d = if c == Number::ONE { d } else { d.negated() };
                    match self.node(t) {
                        Node::Number(_) => self.flatten_into(d, t, constants, terms),
                        _ => terms.push((d, t)),
                    }
                }
            }
            Node::Product { coefficient, factors } if coefficient != Number::ONE => {
                let (c, bare) = match c.exact_product(coefficient) {
                    Some(product) => (product, self.product_of(Number::ONE, factors.to_vec())),
                    None => {
                        // The numbers become factors, and the coefficient a power of two.
                        let whole = self.product_of(c, vec![(e, 1)]);
                        let (c, factors) = self.factors(whole);
                        (c, self.product_of(Number::ONE, factors))
                    }
                };
                match self.node(bare) {
                    Node::Sum { .. } if c == Number::ONE || c == Number::ONE.negated() => {
                        self.flatten_into(c, bare, constants, terms);
                    }
                    _ => terms.push((c, bare)),
                }
            }
            _ => terms.push((c, e)),
        }
    }
}
