//! Laws as Rust writes them: what a failure shows, and what is compiled.

use std::fmt::{self, Display, Formatter};

use dmech_symbolic::expression::{Binary, Unary};

use super::tree::{Test, Tree};

/// The names of the coordinates.
pub const COORDINATES: [&str; 4] = ["x", "y", "z", "w"];

/// The fields of the law that hold its parameters.
pub const FIELDS: [&str; 3] = ["self.k", "self.l", "self.n"];

impl Display for Tree {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coordinate(i) => f.write_str(COORDINATES[*i]),
            Self::Parameter(i) => f.write_str(FIELDS[*i]),
            Self::Number(x) if *x < 0.0 => write!(f, "({x:?})"),
            Self::Number(x) => write!(f, "{x:?}"),
            Self::Add(u, w) => write!(f, "({u} + {w})"),
            Self::Sub(u, w) => write!(f, "({u} - {w})"),
            Self::Mul(u, w) => write!(f, "({u} * {w})"),
            Self::Div(u, w) => write!(f, "({u} / {w})"),
            Self::Powi(u, n) => write!(f, "{}.powi({n})", Receiver(u)),
            Self::Unary(function, u) => write!(f, "{}.{}()", Receiver(u), method(*function)),
            Self::Binary(Binary::Powf, u, w) => write!(f, "{}.powf({w})", Receiver(u)),
            Self::Binary(function, u, w) => write!(f, "{}.{}({w})", Receiver(u), function.method()),
            Self::Hypot(u, w) => write!(f, "{}.hypot({w})", Receiver(u)),
            Self::Clamp(u, low, high) => write!(f, "{}.clamp({low:?}, {high:?})", Receiver(u)),
            Self::Select(test, yes, no) => write!(f, "(if {test} {{ {yes} }} else {{ {no} }})"),
        }
    }
}

fn method(f: Unary) -> &'static str {
    f.method()
}

/// What a method is called on; the type of a bare literal would be ambiguous.
struct Receiver<'a>(&'a Tree);

impl Display for Receiver<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.0 {
            Tree::Number(x) if *x < 0.0 => write!(f, "({x:?}_f64)"),
            Tree::Number(x) => write!(f, "{x:?}_f64"),
            other => write!(f, "{other}"),
        }
    }
}

impl Display for Test {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Compare(comparison, left, right) => write!(f, "{left} {} {right}", comparison.sign()),
            Self::Not(inner) => write!(f, "!({inner})"),
            Self::And(one, two) => write!(f, "({one}) && ({two})"),
            Self::Or(one, two) => write!(f, "({one}) || ({two})"),
        }
    }
}
