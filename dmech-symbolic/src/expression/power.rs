//! Reading a product as a power.

use crate::hash::Map;

use super::{Expr, Graph, Node, Number, Unary};

impl Graph {
    /// Splits a product into its coefficient and its factors; anything else is its own only factor.
    pub(crate) fn factors(&self, e: Expr) -> (Number, Vec<(Expr, i32)>) {
        match self.node(e) {
            Node::Product { coefficient, factors } => (*coefficient, factors.to_vec()),
            _ => (Number::ONE, vec![(e, 1)]),
        }
    }

    /// The expression as a root: square roots of square roots are fourth ones.
    pub(crate) fn root(&self, f: Expr) -> Option<Root> {
        match *self.node(f) {
            Node::Unary(Unary::Cbrt, below) => Some(Root { degree: 3, below }),
            Node::Unary(Unary::Sqrt, u) => match self.root(u) {
                Some(Root { degree, below }) if degree != 3 => Some(Root { degree: 2 * degree, below }),
                _ => Some(Root { degree: 2, below: u }),
            },
            _ => None,
        }
    }

    /// Whether a root in an expression, or in a branch of it, is none in its nth power. For an even n beside no other factor: the
    /// choice is still made by the root, and the two would no longer be functions of one variable.
    pub(crate) fn undoes_root(&self, e: Expr, n: i32) -> bool {
        match self.node(e) {
            Node::Unary(Unary::Sqrt, _) => n % 2 == 0,
            Node::Unary(Unary::Cbrt, _) => n % 3 == 0,
            Node::Product { factors, .. } if n % 2 == 0 && factors.len() > 1 => false,
            Node::Product { factors, .. } => factors.iter().any(|&(f, m)| self.undoes_root(f, m.wrapping_mul(n))),
            _ => self.choice(e).is_some_and(|choice| {
                let mut branches = [choice.yes, choice.no].into_iter();
                branches.any(|branch| self.undoes_root(branch, n))
            }),
        }
    }

    /// cos u and cosh u of a u with a root √s in it, which are smooth in s where √s is not: with sinc and sinhc the derivative by u²
    /// is ∓sinc(u)/2.
    pub(crate) fn even_of_root(&self, e: Expr) -> Option<EvenOfRoot> {
        let Node::Unary(f, argument) = *self.node(e) else { return None };
        let (cardinal, half) = match f {
            Unary::Cos => (Unary::Sinc, -0.5),
            Unary::Cosh => (Unary::Sinhc, 0.5),
            _ => return None,
        };
        Some(EvenOfRoot { cardinal, half, argument, square: self.square_without_root(argument)? })
    }

    /// Whether e is f times something.
    pub(crate) fn has_factor(&self, e: Expr, f: Expr) -> bool {
        e == f || matches!(self.node(e), Node::Product { factors, .. } if factors.iter().any(|&(g, n)| g == f && n > 0))
    }

    /// u², if there is a root among the factors of u that is none among its own.
    pub(crate) fn square_without_root(&self, u: Expr) -> Option<Square> {
        let (coefficient, factors) = self.factors(u);
        let below = |f: Expr| match *self.node(f) {
            Node::Unary(Unary::Sqrt, below) => Some(below),
            _ => None,
        };
        if !factors.iter().any(|&(f, n)| n > 0 && below(f).is_some()) {
            return None;
        }
        let square = |&(f, n): &(Expr, i32)| match below(f) {
            Some(below) => Some((below, n)),
            None => Some((f, n.checked_mul(2)?)),
        };
        Some(Square { coefficient, factors: factors.iter().map(square).collect::<Option<_>>()? })
    }

    /// c e, within the branches if e is a choice: where a branch is 0, c may be infinite.
    pub(crate) fn mul_within(&mut self, c: Expr, e: Expr) -> Expr {
        if c == self.one() { e } else { self.mul_within_known(c, e, &mut Map::default()) }
    }

    /// The branches of one choice may be those of many others.
    fn mul_within_known(&mut self, c: Expr, e: Expr, known: &mut Map<Expr, Expr>) -> Expr {
        if let Some(&product) = known.get(&e) {
            return product;
        }
        let product = match self.node(e).clone() {
            Node::Select(condition, yes, no) => {
                let (yes, no) = (self.mul_within_known(c, yes, known), self.mul_within_known(c, no, known));
                self.select(condition, yes, no)
            }
            _ => self.mul(&[c, e]),
        };
        known.insert(e, product);
        product
    }
}

/// cos u or cosh u with a root in u: the cardinal function of its derivative by u² with the factor, u, and u².
#[derive(Clone, Debug)]
pub(crate) struct EvenOfRoot {
    pub(crate) cardinal: Unary,
    pub(crate) half: f64,
    pub(crate) argument: Expr,
    pub(crate) square: Square,
}

/// c² Π fᵢ^nᵢ
#[derive(Clone, Debug)]
pub(crate) struct Square {
    pub(crate) coefficient: Number,
    pub(crate) factors: Vec<(Expr, i32)>,
}

/// A root: its degree, and what is below it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Root {
    pub(crate) degree: i32,
    pub(crate) below: Expr,
}
