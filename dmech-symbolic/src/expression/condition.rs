//! Conditions of piecewise expressions.

use dmech_scalar::{Mask, Real};

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

/// A condition on expressions, or on the values of a program. Conditions that are joined, and sides that are compared for
/// equality, stand in a fixed order, so that it does not matter in which they were given.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Condition<T = Expr> {
    /// A comparison of two of them.
    Compare(Relation, T, T),
    /// The opposite.
    Not(Box<Self>),
    /// Both.
    And(Box<Self>, Box<Self>),
    /// At least one.
    Or(Box<Self>, Box<Self>),
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
}

impl<T: Copy> Condition<T> {
    /// What is compared.
    pub fn operands(&self) -> Vec<T> {
        match self {
            Self::Compare(_, left, right) => vec![*left, *right],
            Self::Not(inner) => inner.operands(),
            Self::And(one, two) | Self::Or(one, two) => [one.operands(), two.operands()].concat(),
        }
    }

    /// The same condition on what stands for the operands, in the same order.
    pub(crate) fn with<U>(&self, f: &mut impl FnMut(T) -> U) -> Condition<U> {
        match self {
            Self::Compare(relation, left, right) => Condition::Compare(*relation, f(*left), f(*right)),
            Self::Not(inner) => Condition::Not(Box::new(inner.with(f))),
            Self::And(one, two) => Condition::And(Box::new(one.with(f)), Box::new(two.with(f))),
            Self::Or(one, two) => Condition::Or(Box::new(one.with(f)), Box::new(two.with(f))),
        }
    }

    /// Where it holds, given the values of the operands.
    pub(crate) fn mask<R: Real>(&self, value: &impl Fn(T) -> R) -> R::Mask {
        match self {
            Self::Compare(Relation::Less, left, right) => value(*left).less(value(*right)),
            Self::Compare(Relation::LessOrEqual, left, right) => value(*left).less_or_equal(value(*right)),
            Self::Compare(Relation::Equal, left, right) => value(*left).equal(value(*right)),
            Self::Not(inner) => inner.mask(value).not(),
            Self::And(one, two) => one.mask(value).and(two.mask(value)),
            Self::Or(one, two) => one.mask(value).or(two.mask(value)),
        }
    }
}
