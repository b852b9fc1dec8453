//! The types that a law can be written with.

use syn::{Expr, GenericArgument, Lit, Path, PathArguments, Type};

/// A type that the macro knows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Known {
    /// `f64`
    Float,
    /// `f32`, which a law never is: the generated code is generic over the scalar anyway.
    Single,
    /// `usize`, `i32` …
    Integer,
    /// `[T; n]`; the length is not known where it is no literal.
    Array(Box<Known>, Option<Length>),
    /// `(T, U)`
    Tuple(Vec<Known>),
    /// nalgebra's column vectors of `f64`.
    Vector(Option<Length>),
    /// Anything else.
    Other,
}

/// The length in a type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Length {
    /// A literal.
    Literal(usize),
    /// `Self::D`, a constant of the block.
    Constant(String),
}

/// Reads a type; references are looked through.
pub(crate) fn known_type(ty: &Type) -> Known {
    match ty {
        Type::Group(group) => known_type(&group.elem),
        Type::Paren(paren) => known_type(&paren.elem),
        Type::Reference(reference) => known_type(&reference.elem),
        Type::Array(array) => Known::Array(Box::new(known_type(&array.elem)), length(&array.len)),
        Type::Tuple(tuple) => Known::Tuple(tuple.elems.iter().map(known_type).collect()),
        Type::Path(path) if path.qself.is_none() => known_path(&path.path),
        _ => Known::Other,
    }
}

/// Whether a type of that name is one of integers.
pub(crate) fn is_integer(name: &str) -> bool {
    matches!(name, "usize" | "isize" | "u8" | "i8" | "u16" | "i16" | "u32" | "i32" | "u64" | "i64" | "u128" | "i128")
}

fn known_path(path: &Path) -> Known {
    let Some(last) = path.segments.last() else { return Known::Other };
    let name = last.ident.to_string();
    if path.segments.len() == 1 || is_below(path, &["primitive"]) {
        match name.as_str() {
            "f64" => return Known::Float,
            "f32" => return Known::Single,
            name if is_integer(name) => return Known::Integer,
            _ => {}
        }
    }
    if !is_nalgebra_path(path) {
        return Known::Other;
    }
    let arguments = match &last.arguments {
        PathArguments::AngleBracketed(list) => list.args.iter().collect(),
        _ => vec![],
    };
    let of_floats = matches!(arguments.first(), Some(GenericArgument::Type(ty)) if known_type(ty) == Known::Float);
    match (vector_alias(&name), arguments.len()) {
        (Some(VectorAlias::Fixed(n)), 1) if of_floats => Known::Vector(Some(Length::Literal(n))),
        (Some(VectorAlias::Any), 2) if of_floats => Known::Vector(match arguments[1] {
            GenericArgument::Const(e) => length(e),
            GenericArgument::Type(Type::Path(path)) => constant_name(&path.path),
            _ => None,
        }),
        _ => Known::Other,
    }
}

/// nalgebra's names of column vectors.
pub(crate) enum VectorAlias {
    /// `Vector2`, with its length.
    Fixed(usize),
    /// `SVector`.
    Any,
}

/// The vector type of that name.
pub(crate) fn vector_alias(name: &str) -> Option<VectorAlias> {
    if name == "SVector" {
        return Some(VectorAlias::Any);
    }
    let length = ["Vector1", "Vector2", "Vector3", "Vector4", "Vector5", "Vector6"].iter().position(|&n| n == name)?;
    Some(VectorAlias::Fixed(length + 1))
}

/// `Vector2`, `na::Vector2`, `nalgebra::Vector2`, `dmech::nalgebra::Vector2`.
pub(crate) fn is_nalgebra_path(path: &Path) -> bool {
    path.segments.len() == 1 || is_below(path, &["na", "nalgebra", "base"])
}

/// Whether the last but one segment is one of these.
fn is_below(path: &Path, parents: &[&str]) -> bool {
    path.segments.iter().rev().nth(1).is_some_and(|parent| parents.iter().any(|p| parent.ident == p))
}

fn length(e: &Expr) -> Option<Length> {
    match e {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(n) => n.base10_parse().ok().map(Length::Literal),
            _ => None,
        },
        Expr::Group(group) => length(&group.expr),
        Expr::Paren(paren) => length(&paren.expr),
        Expr::Block(block) => match &block.block.stmts[..] {
            [syn::Stmt::Expr(e, None)] => length(e),
            _ => None,
        },
        Expr::Path(path) => constant_name(&path.path),
        _ => None,
    }
}

/// `Self::D` or `Law::D`; that the first name is the law's is checked where the constant is looked up.
fn constant_name(path: &Path) -> Option<Length> {
    let mut segments = path.segments.iter();
    match (segments.next(), segments.next(), segments.next()) {
        (Some(_), Some(name), None) => Some(Length::Constant(name.ident.to_string())),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Known {
        known_type(&syn::parse_str(text).unwrap())
    }

    #[test]
    fn positions() {
        let array = |n| Known::Array(Box::new(Known::Float), Some(n));
        assert_eq!(read("f64"), Known::Float);
        assert_eq!(read("core::primitive::f64"), Known::Float);
        assert_eq!(read("[f64; 2]"), array(Length::Literal(2)));
        assert_eq!(read("[f64; Self::D]"), array(Length::Constant("D".into())));
        assert_eq!(read("[f64; 1 + 1]"), Known::Array(Box::new(Known::Float), None));
        for ty in ["SVector<f64, 3>", "na::SVector<f64, {3}>", "Vector3<f64>", "::nalgebra::Vector3<f64>"] {
            assert_eq!(read(ty), Known::Vector(Some(Length::Literal(3))), "{ty}");
        }
        for ty in ["glam::Vector3<f64>", "Vector3<f32>", "SVector<f64>", "Vec<f64>", "[f64]"] {
            assert_eq!(read(ty), Known::Other, "{ty}");
        }
    }
}
