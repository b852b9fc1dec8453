//! Sums: products fused with additions, long sums in parts, each term with its image.

use crate::expression::{Expr, Number};

use super::product::is_negative;
use super::scheduling::{Scheduling, What};
use super::{Operation, Value, latency};

/// Sums longer than this are added in parts, so that their additions do not all wait for one another.
const LONGEST_SUM: usize = 8;

/// One summand on its way into a sum.
struct Summand {
    negative: bool,
    ready: u32,
    key: u32,
    what: What,
}

impl Scheduling<'_> {
    /// constant + Σ cᵢ tᵢ, the summands as they become ready.
    pub(super) fn sum(&mut self, constant: Number, terms: &[(Number, Expr)]) -> Value {
        let mut summands = self.summands(terms);
        if constant != Number::ZERO {
            let value = self.number(constant.value().abs());
            summands.push(Summand { negative: constant.value() < 0.0, ready: 0, key: 0, what: What::Value(value) });
        }
        summands.sort_by_key(|s| (s.ready, s.key));
        // A positive summand first, so that no negation is needed where one can be had.
        if let Some(first) = summands.iter().position(|s| !s.negative) {
            let first = summands.remove(first);
            summands.insert(0, first);
        }
        if summands.len() <= LONGEST_SUM {
            let (negative, value) = self.add_up(summands);
            return if negative { self.push(Operation::Neg(value)) } else { value };
        }
        let mut parts: Vec<(bool, Value)> = vec![];
        while !summands.is_empty() {
            let rest = summands.split_off(summands.len().min(LONGEST_SUM));
            parts.push(self.add_up(std::mem::replace(&mut summands, rest)));
        }
        let parts = parts.into_iter().enumerate().map(|(i, (negative, value))| Summand {
            negative,
            ready: 0,
            key: i as u32,
            what: What::Value(value),
        });
        let (negative, value) = self.add_up(parts.collect());
        if negative { self.push(Operation::Neg(value)) } else { value }
    }

    /// The terms, each added to its image first.
    fn summands(&mut self, terms: &[(Number, Expr)]) -> Vec<Summand> {
        let mut rest = terms.to_vec();
        rest.reverse();
        let mut summands = vec![];
        while let Some((c, t)) = rest.pop() {
            let image = self.mirror.of_expr(t);
            let key = t.0.min(image.0);
            let (negative, magnitude) = (is_negative(self.graph, c, t), c);
            let twin = (image != t)
                .then(|| rest.iter().position(|&(d, other)| other == image && d.value().abs() == c.value().abs()))
                .flatten();
            if let Some(i) = twin {
                let (d, other) = rest.remove(i);
                let (value, twin) = (self.product(magnitude, t), self.product(d, other));
                let same_sign = negative == is_negative(self.graph, d, other);
                let (operation, negative) = match (same_sign, negative) {
                    (true, sign) => (Operation::Add(value.min(twin), value.max(twin)), sign),
                    (false, false) => (Operation::Sub(value, twin), false),
                    (false, true) => (Operation::Sub(twin, value), false),
                };
                let value = self.push(operation);
                let ready = self.ready[t.index()] + latency::ADD;
                summands.push(Summand { negative, ready, key, what: What::Value(value) });
                continue;
            }
            let what = self.summand(magnitude, t);
            summands.push(Summand { negative, ready: self.ready[t.index()], key, what });
        }
        summands
    }

    /// A product that is needed nowhere else is left to be fused with the addition.
    fn summand(&mut self, c: Number, t: Expr) -> What {
        match self.products.of_term(c, t) {
            Some(product) if self.products.stands_once(product) && self.of_expr[t.index()].is_none() => {
                self.last_factors(product)
            }
            Some(_) => What::Value(self.product(c, t)),
            None => What::Value(self.value(t)),
        }
    }

    /// Adds the summands one after the other; the sign is that of the first.
    fn add_up(&mut self, summands: Vec<Summand>) -> (bool, Value) {
        let mut summands = summands.into_iter();
        let first = summands.next().expect("a sum has summands");
        let sign = first.negative;
        let mut total = match first.what {
            What::Value(value) => value,
            What::Product(one, two) => self.mul(one, two),
        };
        for summand in summands {
            let same = summand.negative == sign;
            total = self.push(match summand.what {
                What::Value(value) if same => Operation::Add(total, value),
                What::Value(value) => Operation::Sub(total, value),
                What::Product(one, two) if same => Operation::MulAdd(one, two, total),
                What::Product(one, two) => Operation::NegMulAdd(one, two, total),
            });
        }
        (sign, total)
    }
}
