//! Expressions and their variables, as indices.

/// An expression: an index into its [`Graph`](super::Graph).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Expr(pub(crate) u32);

/// A variable: an index into the table of names of its [`Graph`](super::Graph).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(pub(crate) u32);

impl Expr {
    /// Its position in the store; children come before parents.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What a symbol stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variable {
    /// Something that moves: a component of a position, an increment.
    Coordinate,
    /// The square of a distance, which vanishes as the coordinates do that it is made of.
    SquaredDistance,
    /// Something that does not change along a step: a parameter of the law, a mass, a step size.
    Parameter,
}
