//! Products in normal form.
//!
//! | rule | domain |
//! |---|---|
//! | (a b) c = a b c, sorted; a^m a^n = a^(m+n) | a ≠ 0 where m or n is negative |
//! | (a b)^n = a^n b^n; {a if c, else b}^n = {a^n if c, else b^n} | all, n integer |
//! | min(√a, b)² = {a if √a ≤ b, else b²}, min(∛a, b)³ = min(a, b³), likewise max: no root is left with a slope that is infinite | all |
//! | (√s)^2 = s, s^k √s^n = √s^(2k+n) | s ≥ 0, which √s demands; s > 0 where an exponent is negative |
//! | (∛u)³ = u, u^k ∛uⁿ = ∛u^(3k+n) | all; u ≠ 0 where an exponent is negative; u may be a product, as below a square root |
//! | \|u\|² = u², u^2k √\|u\|ⁿ = √\|u\|^(4k+n), u signum u = \|u\| | all; u ≠ 0 where an exponent is negative |
//! | (−a − b)^n = (−1)^n (a + b)^n, so that b − a and a − b share a node | all |
//! | (c/d) a = e a where e = c/d is exact | all |
//! | 0·a = 0 | a finite |

use super::number::combined;
use super::{Choice, Expr, Graph, Node, Number, Unary};

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
        let mut product = Gathering { numbers: vec![coefficient], factors: vec![] };
        for (f, n) in factors {
            product.take(self, f, n);
        }
        product.normal_form(self)
    }
}

/// Powers of numbers up to this one are folded number by number where the whole is not exact.
const LONGEST_POWER: i32 = 16;

/// A product on its way to normal form.
struct Gathering {
    numbers: Vec<Number>,
    factors: Vec<(Expr, i32)>,
}

impl Gathering {
    /// Multiplies by fⁿ.
    fn take(&mut self, graph: &mut Graph, f: Expr, n: i32) {
        if n == 0 {
            return;
        }
        // Most factors, and large ones, are taken as they are.
        match graph.node(f) {
            Node::Symbol(_) => return self.raise(f, n),
            Node::Sum { terms, .. } if terms[0].0.value() >= 0.0 => return self.raise(f, n),
            _ => {}
        }
        match graph.node(f).clone() {
            Node::Number(c) => match c.exact_power(n) {
                Some(power) => self.numbers.push(power),
                None if (2..=LONGEST_POWER).contains(&n) => self.numbers.extend((0..n).map(|_| c)),
                None => self.raise(f, n),
            },
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
                    self.numbers.push(Number::ONE.negated());
                }
                self.raise(turned, n);
            }
            Node::Binary(extremum, u, w)
                if extremum.is_extremum() && n > 0 && n % 2 != 0 && graph.undoes_root(f, n) =>
            {
                let (u, w) = (graph.powi(u, n), graph.powi(w, n));
                let power = graph.binary(extremum, u, w);
                self.take(graph, power, 1);
            }
            node if n != 1 && node.is_choice() && (matches!(node, Node::Select(..)) || graph.undoes_root(f, n)) => {
                let Choice { condition, yes, no } = graph.choice(f).expect("the factor is a choice");
                let (yes, no) = (graph.powi(yes, n), graph.powi(no, n));
                let power = graph.select(condition, yes, no);
                self.take(graph, power, 1);
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
        self.merge_roots(graph);
        let coefficient = self.fold_numbers(graph);
        if coefficient == Number::ZERO {
            return graph.zero();
        }
        self.factors.retain(|&(_, n)| n != 0);
        self.factors.sort_unstable();
        match (&self.factors[..], coefficient) {
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

    /// The product of the numbers where it is exact. Where it is not, they become factors, all but powers of two, so that a
    /// product built in another order is the same.
    fn fold_numbers(&mut self, graph: &mut Graph) -> Number {
        let mut numbers = std::mem::take(&mut self.numbers);
        if numbers.contains(&Number::ZERO) {
            return Number::ZERO;
        }
        let negative = numbers.iter().filter(|c| c.value() < 0.0).count() % 2 == 1;
        numbers.iter_mut().filter(|c| c.value() < 0.0).for_each(|c| *c = c.negated());
        numbers.sort_unstable();
        self.divide_by_numbers(graph, &mut numbers);
        let (powers, others): (Vec<_>, Vec<_>) = numbers.into_iter().partition(|c| c.is_power_of_two());
        let mut coefficient = Number::ONE;
        let mut apart = combined(others, Number::exact_product);
        if let [only] = apart[..] {
            coefficient = only;
            apart.clear();
        }
        for power in powers {
            match coefficient.exact_product(power) {
                Some(product) => coefficient = product,
                None => apart.push(power), // Out of range.
            }
        }
        if apart.is_empty() {
            let mut whole = [coefficient];
            self.divide_by_numbers(graph, &mut whole);
            coefficient = whole[0];
        }
        for c in apart {
            let number = graph.intern(Node::Number(c));
            self.raise(number, 1);
        }
        if negative {
            coefficient = coefficient.negated();
        }
        coefficient
    }

    /// 3 x/3 = x, where the quotient of the numbers is exact.
    fn divide_by_numbers(&mut self, graph: &Graph, numbers: &mut [Number]) {
        for (f, n) in &mut self.factors {
            let Node::Number(divisor) = graph.node(*f) else { continue };
            while *n < 0
                && let Some((quotient, c)) = numbers.iter_mut().find_map(|c| Some((c.exact_quotient(*divisor)?, c)))
            {
                *c = quotient;
                *n += 1;
            }
        }
    }

    /// Leaves either s or √s, never both, and √s only to odd powers; likewise ∛u, |u|.
    fn merge_roots(&mut self, graph: &mut Graph) {
        while let Some((i, base, n, left)) = self.next_merger(graph) {
            self.factors[i].1 = left;
            self.take(graph, base, n);
        }
    }

    /// A factor that changes: its place, what it becomes, and the exponent that is left of itself. The factors that it
    /// takes up are gone.
    fn next_merger(&mut self, graph: &mut Graph) -> Option<(usize, Expr, i32, i32)> {
        for i in 0..self.factors.len() {
            let (f, n) = self.factors[i];
            if n == 0 {
                continue;
            }
            match *graph.node(f) {
                Node::Unary(Unary::Sqrt, s) => {
                    if n % 2 == 0 {
                        return Some((i, s, n / 2, 0));
                    }
                    if let Some(m) = self.give_up(s, |_| true).or_else(|| self.give_up_product(graph, s)) {
                        return Some((i, f, n + 2 * m, 0));
                    }
                    if let Node::Unary(Unary::Abs, u) = *graph.node(s)
                        && let Some(m) = self.give_up(u, |m| m % 2 == 0)
                    {
                        return Some((i, f, n + 2 * m, 0));
                    }
                }
                Node::Unary(Unary::Cbrt, u) => {
                    if n % 3 == 0 {
                        return Some((i, u, n / 3, 0));
                    }
                    if let Some(m) = self.give_up(u, |_| true).or_else(|| self.give_up_product(graph, u)) {
                        return Some((i, f, n + 3 * m, 0));
                    }
                }
                Node::Unary(Unary::Abs, u) if n % 2 == 0 => return Some((i, u, n, 0)),
                Node::Unary(Unary::Signum, u) if n > 0 => {
                    if let Some(partner) = self.factors.iter_mut().find(|(other, m)| *other == u && *m > 0) {
                        partner.1 -= 1;
                        return Some((i, graph.unary(Unary::Abs, u), 1, n - 1));
                    }
                }
                _ => {}
            }
        }
        None
    }

    /// The exponent of a factor, if it stands in the product and may be given up; it is then gone.
    fn give_up(&mut self, base: Expr, may: impl Fn(i32) -> bool) -> Option<i32> {
        let factor = self.factors.iter_mut().find(|(f, m)| *f == base && *m != 0 && may(*m))?;
        Some(std::mem::take(&mut factor.1))
    }

    /// The same of a base that is a product, whose factors stand by themselves: the highest power that all of them hold.
    fn give_up_product(&mut self, graph: &Graph, base: Expr) -> Option<i32> {
        let Node::Product { coefficient: Number::ONE, factors } = graph.node(base) else { return None };
        let held = |&(f, n): &(Expr, i32)| self.factors.iter().find(|own| own.0 == f).map_or(0, |own| own.1 / n);
        let powers: Vec<i32> = factors.iter().map(held).collect();
        let (least, most) = (*powers.iter().min()?, *powers.iter().max()?);
        let power = if least > 0 { least } else { most.min(0) };
        if power == 0 {
            return None;
        }
        for own in &mut self.factors {
            if let Some(&(_, n)) = factors.iter().find(|(f, _)| *f == own.0) {
                own.1 -= power * n;
            }
        }
        Some(power)
    }
}
