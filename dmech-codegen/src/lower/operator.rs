//! Operators with two sides.

use syn::BinOp;

/// The operators of arithmetic.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Operator {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
}

impl Operator {
    pub(super) fn of(op: &BinOp) -> Option<Self> {
        match op {
            BinOp::Add(_) => Some(Self::Add),
            BinOp::Sub(_) => Some(Self::Sub),
            BinOp::Mul(_) => Some(Self::Mul),
            BinOp::Div(_) => Some(Self::Div),
            BinOp::Rem(_) => Some(Self::Rem),
            _ => None,
        }
    }

    /// The operator behind `+=`.
    pub(super) fn of_assignment(op: &BinOp) -> Option<Self> {
        match op {
            BinOp::AddAssign(_) => Some(Self::Add),
            BinOp::SubAssign(_) => Some(Self::Sub),
            BinOp::MulAssign(_) => Some(Self::Mul),
            BinOp::DivAssign(_) => Some(Self::Div),
            BinOp::RemAssign(_) => Some(Self::Rem),
            _ => None,
        }
    }

    pub(super) fn sign(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Sub => "-",
            Self::Mul => "*",
            Self::Div => "/",
            Self::Rem => "%",
        }
    }
}

/// How two values are compared.
#[derive(Clone, Copy)]
pub(super) enum Comparison {
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Equal,
    NotEqual,
}

impl Comparison {
    pub(super) fn of(op: &BinOp) -> Option<Self> {
        match op {
            BinOp::Lt(_) => Some(Self::Less),
            BinOp::Le(_) => Some(Self::LessOrEqual),
            BinOp::Gt(_) => Some(Self::Greater),
            BinOp::Ge(_) => Some(Self::GreaterOrEqual),
            BinOp::Eq(_) => Some(Self::Equal),
            BinOp::Ne(_) => Some(Self::NotEqual),
            _ => None,
        }
    }

    pub(super) fn holds<T: PartialOrd>(self, left: T, right: T) -> bool {
        match self {
            Self::Less => left < right,
            Self::LessOrEqual => left <= right,
            Self::Greater => left > right,
            Self::GreaterOrEqual => left >= right,
            Self::Equal => left == right,
            Self::NotEqual => left != right,
        }
    }
}
