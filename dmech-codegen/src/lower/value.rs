//! What an expression of the body can stand for.

use dmech_symbolic::expression::{Condition, Expr};
use proc_macro2::TokenStream;
use quote::ToTokens;

use crate::model::Body;

/// A value while the body is read.
#[derive(Clone)]
pub(super) enum Value {
    /// A number that the law computes.
    Number(Expr),
    /// A whole number known now: a literal, a loop index.
    Integer(i128),
    /// The outcome of a comparison.
    Truth(Truth),
    /// `[a, b]`
    Array(Vec<Value>),
    /// nalgebra's column vector.
    Vector(Vec<Expr>),
    /// `(a, b)`; `()` is the empty one.
    Tuple(Vec<Value>),
    /// A range or an iterator, all of it.
    Items(Vec<Value>),
    /// `self.k`, whose type is not known yet: a number, an array, a vector or a struct.
    Field(Field),
    /// `self`
    Law,
    /// `let x;` before anything is assigned.
    Unset,
    /// What an error leaves behind.
    Unknown,
}

/// The outcome of a comparison.
#[derive(Clone)]
pub(super) enum Truth {
    /// Known now: a comparison of loop indices.
    Known(bool),
    /// Known when the law is evaluated.
    When(Condition),
}

/// A path that starts at the law, `self.a.k[2]`, `Self::G`, or at the data of a body, `a.q`.
#[derive(Clone)]
pub(super) struct Field {
    /// Where the path starts.
    pub(super) of: Owner,
    /// The code that reads it.
    pub(super) tokens: TokenStream,
    /// The same as text, to know it again.
    pub(super) key: String,
    /// Its name in formulas: `a_k_2`.
    pub(super) name: String,
}

/// Where a path starts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    /// The law.
    Law,
    /// The data of a body.
    Body(Body),
}

/// An argument of a call, with the code to point at.
#[derive(Clone)]
pub(super) struct Given<'m> {
    pub(super) value: Value,
    pub(super) at: &'m syn::Expr,
}

/// The code that a value comes from, to point at.
#[derive(Clone, Copy)]
pub(super) enum At<'a> {
    /// An expression, whose parts can be pointed at.
    Code(&'a syn::Expr),
    /// Anything else.
    Other(&'a dyn ToTokens),
}

impl<'a> At<'a> {
    /// The code of one element, where the value is written out.
    pub(super) fn part(self, i: usize) -> Self {
        let elements = match self {
            Self::Code(syn::Expr::Array(array)) => &array.elems,
            Self::Code(syn::Expr::Tuple(tuple)) => &tuple.elems,
            Self::Code(syn::Expr::Paren(inner)) => return Self::Code(&inner.expr).part(i),
            Self::Code(syn::Expr::Reference(inner)) => return Self::Code(&inner.expr).part(i),
            other => return other,
        };
        elements.get(i).map_or(self, Self::Code)
    }
}

impl ToTokens for At<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Self::Code(e) => e.to_tokens(tokens),
            Self::Other(other) => other.to_tokens(tokens),
        }
    }
}

impl Value {
    pub(super) const UNIT: Self = Self::Tuple(vec![]);

    pub(super) fn known(truth: bool) -> Self {
        Self::Truth(Truth::Known(truth))
    }

    pub(super) fn is_unknown(&self) -> bool {
        matches!(self, Self::Unknown)
    }

    /// What a message calls it.
    pub(super) fn kind(&self) -> String {
        let counted = |what: &str, n: usize| format!("{what} of {n}");
        match self {
            Self::Number(_) => "a number".into(),
            Self::Integer(_) => "an integer".into(),
            Self::Truth(_) => "a condition".into(),
            Self::Array(elements) => counted("an array", elements.len()),
            Self::Vector(components) if components.len() == 1 => "a vector with 1 component".into(),
            Self::Vector(components) => format!("a vector with {} components", components.len()),
            Self::Tuple(parts) if parts.is_empty() => "nothing, `()`".into(),
            Self::Tuple(parts) => counted("a tuple", parts.len()),
            Self::Items(_) => "a range or an iterator".into(),
            Self::Field(Field { of: Owner::Body(_), .. }) => "data of a body".into(),
            Self::Field(_) => "a field of the law".into(),
            Self::Law => "the law itself".into(),
            Self::Unset => "a variable without a value".into(),
            Self::Unknown => "unknown".into(),
        }
    }
}
