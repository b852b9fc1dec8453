//! Products in normal form.
//!
//! | rule | domain |
//! |---|---|
//! | (a b) c = a b c, sorted; a^m a^n = a^(m+n) | a ≠ 0 where m or n is negative |
//! | (a b)^n = a^n b^n | all, n integer |
//! | (√s)^2 = s, s^k √s^n = √s^(2k+n) | s ≥ 0, which √s demands; s > 0 where an exponent is negative |
//! | (∛u)³ = u | all |
//! | \|u\|² = u² | all |
//! | (−a − b)^n = (−1)^n (a + b)^n, so that b − a and a − b share a node | all |
//! | (c/d) a = e a where e = c/d is exact | all |
//! | 0·a = 0 | a finite |

use super::{Expr, Graph, Node, Number, Unary};

impl Graph {
    /// The product of expressions; 1 if there are none.
    pub fn mul(&mut self, factors: &[Expr]) -> Expr {
        let powers: Vec<_> = factors.iter().map(|&f| (f, 1)).collect();
        self.product_of(Number::ONE, powers)
    }

    /// numerator/denominator.
    pub fn div(&mut self, numerator: Expr, denominator: Expr) -> Expr {
        self.product_of(Number::ONE, vec![(numerator, 1), (denominator, -1)])
    }

    /// c e for a number c.
    pub fn scale(&mut self, c: f64, e: Expr) -> Expr {
        self.product_of(Number::new(c), vec![(e, 1)])
    }

    /// 1/e.
    pub fn recip(&mut self, e: Expr) -> Expr {
        self.powi(e, -1)
    }

    /// e², the spelling that most formulas need.
    pub fn square(&mut self, e: Expr) -> Expr {
        self.powi(e, 2)
    }

    /// eⁿ.
    pub fn powi(&mut self, e: Expr, n: i32) -> Expr {
        self.product_of(Number::ONE, vec![(e, n)])
    }

    /// c Π fᵢ^nᵢ in normal form.
    pub(crate) fn product_of(&mut self, coefficient: Number, factors: Vec<(Expr, i32)>) -> Expr {
        let mut product = Gathering { coefficient, factors: vec![] };
        for (f, n) in factors {
            product.take(self, f, n);
        }
        product.normal_form(self)
    }
}

/// A product on its way to normal form.
struct Gathering {
    coefficient: Number,
    factors: Vec<(Expr, i32)>,
}

impl Gathering {
    /// Multiplies by fⁿ.
    fn take(&mut self, graph: &mut Graph, f: Expr, n: i32) {
        if n == 0 {
            return;
        }
        match graph.node(f).clone() {
            Node::Number(c) => {
                let folded = c.exact_power(n).and_then(|power| self.coefficient.exact_product(power));
                match folded {
                    Some(product) => self.coefficient = product,
                    None => self.raise(f, n),
                }
            }
            Node::Product { coefficient, factors } => {
                if coefficient != Number::ONE {
                    let number = graph.intern(Node::Number(coefficient));
                    self.take(graph, number, n);
                }
                for &(inner, m) in &factors {
                    self.take(graph, inner, m * n);
                }
            }
            Node::Sum { constant, terms } if terms[0].0.value() < 0.0 => {
                let turned = Node::Sum {
                    constant: constant.negated(),
                    terms: terms.iter().map(|&(c, t)| (c.negated(), t)).collect(),
                };
                let turned = graph.intern(turned);
                if n % 2 != 0 {
                    self.coefficient = self.coefficient.negated();
                }
                self.raise(turned, n);
            }
            Node::Unary(Unary::Abs, u) if n % 2 == 0 => self.take(graph, u, n),
            Node::Unary(Unary::Cbrt, u) if n % 3 == 0 => self.take(graph, u, n / 3),
            _ => self.raise(f, n),
        }
    }

    fn raise(&mut self, f: Expr, n: i32) {
        match self.factors.iter_mut().find(|factor| factor.0 == f) {
            Some(factor) => factor.1 += n,
            None => self.factors.push((f, n)),
        }
    }

    fn normal_form(mut self, graph: &mut Graph) -> Expr {
        if self.coefficient == Number::ZERO {
            return graph.zero();
        }
        self.merge_roots(graph);
        self.divide_by_numbers(graph);
        self.factors.retain(|&(_, n)| n != 0);
        self.factors.sort_unstable();
        match (&self.factors[..], self.coefficient) {
            ([], c) => graph.intern(Node::Number(c)),
            (&[(f, 1)], Number::ONE) => f,
            // −(a − b) is stored as the sum b − a, so that a lone difference has one form.
            (&[(f, 1)], c) if c == Number::ONE.negated() && matches!(graph.node(f), Node::Sum { .. }) => {
                let Node::Sum { constant, terms } = graph.node(f).clone() else { unreachable!() };
                graph.intern(Node::Sum {
                    constant: constant.negated(),
                    terms: terms.iter().map(|&(c, t)| (c.negated(), t)).collect(),
                })
            }
            (_, coefficient) => graph.intern(Node::Product { coefficient, factors: self.factors.into() }),
        }
    }

    /// 3 x/3 = x, where the quotient of the numbers is exact.
    fn divide_by_numbers(&mut self, graph: &Graph) {
        for (f, n) in &mut self.factors {
            while *n < 0
                && let Node::Number(divisor) = graph.node(*f)
                && let Some(quotient) = self.coefficient.exact_quotient(*divisor)
            {
                self.coefficient = quotient;
                *n += 1;
            }
        }
    }

    /// Leaves either s or √s, never both, and √s only to odd powers; likewise ∛u, |u|.
    fn merge_roots(&mut self, graph: &mut Graph) {
        loop {
            let mut change = None;
            for (i, &(f, n)) in self.factors.iter().enumerate() {
                match graph.node(f) {
                    Node::Unary(Unary::Sqrt, s) if n != 0 => {
                        let s = *s;
                        if n % 2 == 0 {
                            change = Some((i, s, n / 2, 0));
                            break;
                        }
                        if let Some(j) = self.factors.iter().position(|&(other, m)| other == s && m != 0) {
                            let m = std::mem::take(&mut self.factors[j].1);
                            change = Some((i, f, 0, n + 2 * m));
                            break;
                        }
                    }
                    Node::Unary(Unary::Cbrt, u) if n != 0 && n % 3 == 0 => {
                        change = Some((i, *u, n / 3, 0));
                        break;
                    }
                    Node::Unary(Unary::Abs, u) if n != 0 && n % 2 == 0 => {
                        change = Some((i, *u, n, 0));
                        break;
                    }
                    _ => {}
                }
            }
            let Some((i, base, n, left)) = change else { return };
            self.factors[i].1 = left;
            self.take(graph, base, n);
        }
    }
}
