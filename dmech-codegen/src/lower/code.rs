//! What a piece of code says before anything in it has a value.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Block, Expr, Stmt, Token, Type};

/// The expression that gives a block its value, where it has one.
pub(super) fn result_of(block: &Block) -> Option<&Expr> {
    match block.stmts.last()? {
        Stmt::Expr(Expr::Return(leave), _) => leave.expr.as_deref(),
        Stmt::Expr(Expr::Block(inner), None) => result_of(&inner.block),
        Stmt::Expr(e, None) => Some(e),
        _ => None,
    }
}

/// The `;` behind the last expression of a block, which throws its value away.
pub(super) fn thrown_away(block: &Block) -> Option<&Token![;]> {
    match block.stmts.last()? {
        Stmt::Expr(Expr::Assign(_) | Expr::ForLoop(_) | Expr::While(_) | Expr::Return(_), _) => None,
        Stmt::Expr(_, semicolon) => semicolon.as_ref(),
        _ => None,
    }
}

/// The innermost expression of brackets and references.
pub(super) fn bare(e: &Expr) -> &Expr {
    match e {
        Expr::Paren(inner) => bare(&inner.expr),
        Expr::Group(inner) => bare(&inner.expr),
        Expr::Reference(inner) => bare(&inner.expr),
        e => e,
    }
}

/// `self.n as f64` as tokens.
pub(super) fn cast_tokens(inner: &TokenStream, ty: &Type) -> TokenStream {
    quote!((#inner as #ty))
}

/// The place of `x`, `y`, `z`, `w`, `a`, `b`.
pub(super) fn component(name: &str) -> Option<usize> {
    ["x", "y", "z", "w", "a", "b"].iter().position(|&c| c == name)
}

/// Methods that only a vector has.
pub(super) fn is_vector_method(name: &str) -> bool {
    let own =
        ["norm", "norm_squared", "magnitude", "magnitude_squared", "dot", "cross", "normalize", "metric_distance"];
    own.contains(&name) || ["component_mul", "component_div"].contains(&name)
}

/// Methods that need the length of an array.
pub(super) fn is_sequence_method(name: &str) -> bool {
    ["iter", "into_iter", "map", "len", "windows", "fold", "zip", "sum", "product"].contains(&name)
}
