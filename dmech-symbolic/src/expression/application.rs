//! Functions of expressions in normal form.
//!
//! | rule | domain |
//! |---|---|
//! | f(−u) = f(u) for even f, −f(u) for odd f | all |
//! | √(a b²) = \|b\| √a, ∛(a bⁿ) = ∛bⁿ ∛a for n ≠ ±1, \|a b²\| = \|a\| b² | a ≥ 0 below a square root |
//! | exact values: √4 = 2, sin 0 = 0, e⁰ = 1, … | the point |
//! | u^p by integer powers and roots where p is n/2, n/3 or n/4 (for n/3 the nearest number) | u ≥ 0, which u^p demands |
//! | a root or power of a choice is the choice of the roots or powers: that of a contact is 0 where it is open | all |
//! | hypot(x, y) = √(x² + y²) | x² and y² within range |

use super::function::Parity;
use super::{Binary, Choice, Expr, Graph, Node, Number, Unary};

impl Graph {
    /// f(u) in normal form.
    pub fn unary(&mut self, f: Unary, u: Expr) -> Expr {
        if let Some(exact) = self.as_number(u).and_then(|x| f.exact_value(x)) {
            return self.number(exact);
        }
        if self.leads_with_minus(u) {
            match f.parity() {
                Parity::Even => {
                    let turned = self.neg(u);
                    return self.unary(f, turned);
                }
                Parity::Odd => {
                    let turned = self.neg(u);
                    let value = self.unary(f, turned);
                    return self.neg(value);
                }
                Parity::Neither => {}
            }
        }
        if let Some(product) = self.of_powers(f, u) {
            return product;
        }
        if let (Unary::Sqrt | Unary::Cbrt, Some(choice)) = (f, self.choice(u)) {
            let (yes, no) = (self.unary(f, choice.yes), self.unary(f, choice.no));
            return self.select(choice.condition, yes, no);
        }
        self.intern(Node::Unary(f, u))
    }

    /// f(u, w) in normal form.
    pub fn binary(&mut self, f: Binary, u: Expr, w: Expr) -> Expr {
        match f {
            Binary::Powf => return self.powf(u, w),
            _ if f.is_extremum() && u == w => return u,
            Binary::Atan2 if self.leads_with_minus(u) => {
                let turned = self.neg(u);
                let angle = self.binary(f, turned, w);
                return self.neg(angle);
            }
            _ => {}
        }
        if let (true, Some(x), Some(y)) = (f.is_extremum(), self.as_number(u), self.as_number(w)) {
            return self.number(f.apply(x, y));
        }
        self.intern(Node::Binary(f, u, w))
    }

    /// √(x² + y²).
    pub fn hypot(&mut self, x: Expr, y: Expr) -> Expr {
        let squares = [self.square(x), self.square(y)];
        let sum = self.add(&squares);
        self.unary(Unary::Sqrt, sum)
    }

    /// u between low and high; no number where u is none.
    pub fn clamp(&mut self, u: Expr, low: Expr, high: Expr) -> Expr {
        let raised = self.binary(Binary::AtLeast, u, low);
        self.binary(Binary::AtMost, raised, high)
    }

    /// u^p.
    fn powf(&mut self, u: Expr, p: Expr) -> Expr {
        if u == self.one() {
            return u;
        }
        let exponent = self.as_number(p).or_else(|| self.quotient_of_numbers(p));
        for (denominator, root) in [(1, None), (2, Some(Unary::Sqrt)), (3, Some(Unary::Cbrt)), (4, None)] {
            let Some(exponent) = exponent else { break };
            let n = (exponent * f64::from(denominator)).round();
            if n.abs() > 64.0 || n / f64::from(denominator) != exponent {
                continue;
            }
            let base = match (denominator, root) {
                (_, Some(root)) => self.unary(root, u),
                (4, None) => {
                    let root = self.unary(Unary::Sqrt, u);
                    self.unary(Unary::Sqrt, root)
                }
                _ => u,
            };
            return self.powi(base, n as i32);
        }
        if let Some(Choice { condition, yes, no }) = self.choice(u) {
            let (yes, no) = (self.powf(yes, p), self.powf(no, p));
            return self.select(condition, yes, no);
        }
        self.intern(Node::Binary(Binary::Powf, u, p))
    }

    /// The value of 1.0/3.0 and its like, which stand as products because they are not exact.
    fn quotient_of_numbers(&self, e: Expr) -> Option<f64> {
        match self.node(e) {
            Node::Product { coefficient, factors } => factors.iter().try_fold(coefficient.value(), |value, &(f, n)| {
                let number = self.as_number(f)?;
                (n == -1).then(|| value / number)
            }),
            _ => None,
        }
    }

    /// Whether −e looks simpler than e.
    pub(super) fn leads_with_minus(&self, e: Expr) -> bool {
        match self.node(e) {
            Node::Number(n) => n.value() < 0.0,
            Node::Sum { terms, .. } => terms[0].0.value() < 0.0,
            Node::Product { coefficient, .. } => coefficient.value() < 0.0,
            _ => false,
        }
    }

    /// What can be taken out of √, ∛ and | | of a product.
    fn of_powers(&mut self, f: Unary, u: Expr) -> Option<Expr> {
        let Node::Product { coefficient, factors } = self.node(u).clone() else { return None };
        let may = |n: i32| match f {
            Unary::Sqrt | Unary::Abs => n % 2 == 0,
            Unary::Cbrt => n.abs() != 1,
            _ => false,
        };
        let (powers, rest): (Vec<_>, Vec<_>) = factors.iter().copied().partition(|&(_, n)| may(n));
        if powers.is_empty() {
            return None;
        }
        let rest = self.product_of(coefficient, rest);
        let mut product = vec![(self.unary(f, rest), 1)];
        for (base, n) in powers {
            product.push(match f {
                Unary::Sqrt => (self.unary(Unary::Abs, base), n / 2),
                Unary::Cbrt => (self.unary(f, base), n),
                _ => (base, n),
            });
        }
        Some(self.product_of(Number::ONE, product))
    }
}
