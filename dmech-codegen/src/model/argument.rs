//! The arguments of a method with a role: what they stand for, and how they are written.

use syn::{Pat, Type};

/// An argument of the potential.
pub(crate) struct Argument {
    /// What it stands for.
    pub(crate) quantity: Quantity,
    /// Its name in the body.
    pub(crate) pattern: Pat,
}

/// What an argument stands for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantity {
    /// The position, `q`.
    Position(Shape),
    /// The velocity, `v`.
    Velocity(Shape),
    /// The mass, `m`.
    Mass,
    /// The time, `t`.
    Time,
    /// An argument of a law between two bodies.
    Pair(PairArgument),
    /// Refused; its value silences further errors.
    Refused,
}

/// How a position, a velocity or a force is written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    /// `f64`
    Number,
    /// `[f64; D]`
    Array,
    /// nalgebra's `SVector<f64, D>`
    Vector,
}

/// Which of the two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// The one that the separation points to.
    A,
    /// The other.
    B,
}

/// What an argument of a law between two bodies stands for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum PairArgument {
    /// The distance, `r`.
    Distance,
    /// The separation, `d`.
    Separation(Shape),
    /// `va`, `vb`
    Velocity(Body, Shape),
    /// `ma`, `mb`
    Mass(Body),
    /// `a`, `b`
    Data(Body),
}

impl Body {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::A => "a",
            Self::B => "b",
        }
    }
}

/// The arguments, and the number of coordinates; 0 where the position is refused.
pub(super) struct Arguments {
    pub(super) list: Vec<Argument>,
    pub(super) dimension: usize,
    /// How the value is written.
    pub(super) result: Shape,
    /// The type of the data of two bodies.
    pub(super) data: Option<Type>,
}

impl Arguments {
    pub(super) fn names(&self, quantity: Quantity) -> bool {
        self.list.iter().any(|argument| argument.quantity == quantity)
    }
}
