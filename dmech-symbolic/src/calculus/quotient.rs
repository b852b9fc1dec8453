//! Sums of fractions in which numerators cancel.

use crate::expression::{Expr, Graph, Node, Number};

/// Lists of summands that are longer are added as they are: every pair is looked at.
const MOST: usize = 16;

impl Graph {
    /// The sum of what arrives at a node. Two fractions are put over one denominator where terms of their numerators then cancel:
    /// 2u/s − 2u³/s² with s = 1 + u² is 2u/s², and at a large u the difference has lost all digits.
    pub(super) fn add_fractions(&mut self, summands: &[Expr]) -> Expr {
        if !(2..=MOST).contains(&summands.len()) {
            return self.add(summands);
        }
        let mut summands = summands.to_vec();
        while let Some((i, j, sum)) = self.first_that_cancel(&summands) {
            summands[i] = sum;
            summands.remove(j);
        }
        self.add(&summands)
    }

    /// Two summands i < j whose fractions have one with a shorter numerator as their sum.
    fn first_that_cancel(&mut self, summands: &[Expr]) -> Option<(usize, usize, Expr)> {
        let fractions: Vec<_> = summands.iter().map(|&e| self.fraction(e)).collect();
        for (i, one) in fractions.iter().enumerate() {
            for (j, other) in fractions.iter().enumerate().skip(i + 1) {
                if let Some(sum) = self.cancelling_sum(one, other) {
                    return Some((i, j, sum));
                }
            }
        }
        None
    }

    fn cancelling_sum(&mut self, one: &Fraction, other: &Fraction) -> Option<Expr> {
        if !one.below.iter().any(|&(f, _)| exponent(&other.below, f) > 0) {
            return None;
        }
        let below = common_multiple(&one.below, &other.below);
        let [one, other] = [one, other].map(|fraction| {
            let more = below.iter().map(|&(f, n)| (f, n - exponent(&fraction.below, f)));
            let above = self.product_of(fraction.coefficient, fraction.above.iter().copied().chain(more).collect());
            self.factors(above)
        });
        let ratio = other.0.exact_quotient(one.0)?;
        let common: Vec<_> = one.1.iter().map(|&(f, n)| (f, common_power(n, exponent(&other.1, f)))).collect();
        let mut terms = vec![];
        for (c, factors) in [(Number::ONE, one.1), (ratio, other.1)] {
            let rest = factors.iter().map(|&(f, n)| (f, n - exponent(&common, f))).collect();
            terms.extend(self.multiplied_out(c, rest)?);
        }
        let sum = self.linear_combination(&terms);
        // One term less is two that were alike; two less have cancelled.
        if self.count_of_terms(sum) + 2 > terms.len() {
            return None;
        }
        let turned = below.into_iter().map(|(f, n)| (f, -n));
        Some(self.product_of(one.0, common.into_iter().chain(turned).chain([(sum, 1)]).collect()))
    }

    /// c Π fᵢ^nᵢ term by term, where a sum is among the factors.
    fn multiplied_out(&mut self, c: Number, factors: Vec<(Expr, i32)>) -> Option<Vec<(Number, Expr)>> {
        let product = self.product_of(Number::ONE, factors);
        let (coefficient, factors) = self.factors(product);
        let c = c.exact_product(coefficient)?;
        let is_sum = |&(f, n): &(Expr, i32)| n == 1 && matches!(self.node(f), Node::Sum { .. });
        let Some(place) = factors.iter().position(is_sum) else {
            return Some(vec![(c, self.product_of(Number::ONE, factors))]);
        };
        let Node::Sum { constant, terms } = self.node(factors[place].0).clone() else { return None };
        let mut list = terms.to_vec();
        if constant != Number::ZERO {
            list.push((constant, self.one()));
        }
        let multiplied = |(d, term): (Number, Expr)| {
            let mut rest = factors.clone();
            rest[place] = (term, 1);
            Some((c.exact_product(d)?, self.product_of(Number::ONE, rest)))
        };
        list.into_iter().map(multiplied).collect()
    }

    /// c Π fᵢ^nᵢ over the sums that divide it; a factor that is a sum of fractions, as a mean of 1/s is, over one denominator.
    fn fraction(&mut self, e: Expr) -> Fraction {
        let (coefficient, factors) = self.factors(e);
        let (mut above, mut below) = (vec![], vec![]);
        for (f, n) in factors {
            match self.sum_of_fractions(f).filter(|_| n == 1) {
                Some((numerator, denominator)) => {
                    above.push((numerator, 1));
                    below.extend(denominator);
                }
                None if n < 0 && self.divides(f) => below.push((f, -n)),
                None => above.push((f, n)),
            }
        }
        Fraction { coefficient, above, below: gathered(below) }
    }

    /// The numerator and the denominator of a sum of two fractions, as a mean is one.
    fn sum_of_fractions(&mut self, e: Expr) -> Option<(Expr, Vec<(Expr, i32)>)> {
        let Node::Sum { constant: Number::ZERO, terms } = self.node(e).clone() else { return None };
        if terms.len() != 2 {
            return None;
        }
        let mut below = vec![];
        for &(_, term) in &terms {
            let (_, factors) = self.factors(term);
            let own = factors.into_iter().filter(|&(f, n)| n < 0 && self.divides(f));
            let own: Vec<_> = own.map(|(f, n)| (f, -n)).collect();
            if own.is_empty() {
                return None;
            }
            below = common_multiple(&below, &own);
        }
        let above: Vec<_> = terms
            .iter()
            .map(|&(c, term)| (c, self.product_of(Number::ONE, below.iter().copied().chain([(term, 1)]).collect())))
            .collect();
        Some((self.linear_combination(&above), below))
    }

    /// Whether a denominator is a sum, or a root of one: over another one, as ℓ² of (q/ℓ)², nothing cancels.
    fn divides(&self, f: Expr) -> bool {
        let below = self.root(f).map_or(f, |root| root.below);
        matches!(self.node(below), Node::Sum { .. })
    }

    /// How many terms an expression has as a sum.
    fn count_of_terms(&self, e: Expr) -> usize {
        match self.node(e) {
            Node::Sum { constant, terms } => terms.len() + usize::from(*constant != Number::ZERO),
            &Node::Number(Number::ZERO) => 0,
            _ => 1,
        }
    }
}

/// c Π fᵢ^nᵢ / Π gⱼ^mⱼ with sums gⱼ, or roots of such, and positive exponents mⱼ.
struct Fraction {
    coefficient: Number,
    above: Vec<(Expr, i32)>,
    below: Vec<(Expr, i32)>,
}

fn exponent(factors: &[(Expr, i32)], f: Expr) -> i32 {
    factors.iter().find(|factor| factor.0 == f).map_or(0, |factor| factor.1)
}

/// The power of a factor that two of its powers have in common.
fn common_power(n: i32, m: i32) -> i32 {
    if n > 0 && m > 0 {
        n.min(m)
    } else if n < 0 && m < 0 {
        n.max(m)
    } else {
        0
    }
}

fn gathered(factors: Vec<(Expr, i32)>) -> Vec<(Expr, i32)> {
    let mut all: Vec<(Expr, i32)> = vec![];
    for (f, n) in factors {
        match all.iter_mut().find(|factor| factor.0 == f) {
            Some(factor) => factor.1 += n,
            None => all.push((f, n)),
        }
    }
    all
}

fn common_multiple(one: &[(Expr, i32)], other: &[(Expr, i32)]) -> Vec<(Expr, i32)> {
    let mut all = one.to_vec();
    for &(f, n) in other {
        match all.iter_mut().find(|factor| factor.0 == f) {
            Some(factor) => factor.1 = factor.1.max(n),
            None => all.push((f, n)),
        }
    }
    all
}
