//! Conditions of piecewise expressions.

use super::Expr;

/// How two values are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Relation {
    /// left < right
    Less,
    /// left ≤ right
    LessOrEqual,
    /// left = right
    Equal,
}

/// A condition on values of expressions. Conditions that are joined, and sides that are compared for equality, stand in a
/// fixed order, so that it does not matter in which they were given.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Condition {
    /// A comparison of two expressions.
    Compare(Relation, Expr, Expr),
    /// The opposite.
    Not(Box<Condition>),
    /// Both.
    And(Box<Condition>, Box<Condition>),
    /// At least one.
    Or(Box<Condition>, Box<Condition>),
}

impl Condition {
    /// left < right
    pub fn less(left: Expr, right: Expr) -> Self {
        Self::Compare(Relation::Less, left, right)
    }

    /// left ≤ right
    pub fn less_or_equal(left: Expr, right: Expr) -> Self {
        Self::Compare(Relation::LessOrEqual, left, right)
    }

    /// left = right
    pub fn equal(left: Expr, right: Expr) -> Self {
        Self::Compare(Relation::Equal, left.min(right), left.max(right))
    }

    /// Both conditions.
    pub fn and(self, other: Self) -> Self {
        let (one, two) = (self.clone().min(other.clone()), self.max(other));
        Self::And(Box::new(one), Box::new(two))
    }

    /// At least one of the conditions.
    pub fn or(self, other: Self) -> Self {
        let (one, two) = (self.clone().min(other.clone()), self.max(other));
        Self::Or(Box::new(one), Box::new(two))
    }

    /// The opposite condition.
    pub fn negated(self) -> Self {
        match self {
            Self::Not(inner) => *inner,
            other => Self::Not(Box::new(other)),
        }
    }

    /// The expressions compared.
    pub fn operands(&self) -> Vec<Expr> {
        match self {
            Self::Compare(_, left, right) => vec![*left, *right],
            Self::Not(inner) => inner.operands(),
            Self::And(one, two) | Self::Or(one, two) => {
                let mut operands = one.operands();
                operands.extend(two.operands());
                operands
            }
        }
    }

    /// The same condition on other expressions.
    pub fn map(&self, f: &mut impl FnMut(Expr) -> Expr) -> Self {
        match self {
            Self::Compare(Relation::Equal, left, right) => Self::equal(f(*left), f(*right)),
            Self::Compare(relation, left, right) => Self::Compare(*relation, f(*left), f(*right)),
            Self::Not(inner) => Self::Not(Box::new(inner.map(f))),
            Self::And(one, two) => one.map(f).and(two.map(f)),
            Self::Or(one, two) => one.map(f).or(two.map(f)),
        }
    }

    /// Whether it holds, given the values of the expressions.
    pub fn holds(&self, value: &impl Fn(Expr) -> f64) -> bool {
        match self {
            Self::Compare(Relation::Less, left, right) => value(*left) < value(*right),
            Self::Compare(Relation::LessOrEqual, left, right) => value(*left) <= value(*right),
            Self::Compare(Relation::Equal, left, right) => value(*left) == value(*right),
            Self::Not(inner) => !inner.holds(value),
            Self::And(one, two) => one.holds(value) && two.holds(value),
            Self::Or(one, two) => one.holds(value) || two.holds(value),
        }
    }
}
