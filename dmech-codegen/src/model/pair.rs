//! What a law between two bodies takes.

use quote::ToTokens;
use syn::{Pat, Type};

use crate::diagnostics::pair;

use super::roles::Role;
use super::signature::Arguments;
use super::{ArgumentRole, Shape};

/// A law between two bodies, beside its formulas.
pub struct PairSignature {
    /// The type of the data that the law reads, `Charge` of `a: &Charge`.
    pub data: Option<Type>,
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

/// Reads `a: &Charge`.
pub(super) fn data_argument(
    pat: &Pat,
    ty: &Type,
    of: Body,
    arguments: &mut Arguments,
) -> Result<ArgumentRole, syn::Error> {
    let data = data(pat, ty)?;
    match &arguments.data {
        Some(other) if !same(other, data) => return Err(pair::two_data_types(ty, other)),
        _ => arguments.data = Some(data.clone()),
    }
    Ok(ArgumentRole::Pair(PairArgument::Data(of)))
}

/// `Charge` of `&Charge`.
fn data<'a>(pat: &Pat, ty: &'a Type) -> Result<&'a Type, syn::Error> {
    match ty {
        Type::Reference(reference) if reference.mutability.is_none() => Ok(&reference.elem),
        Type::Reference(reference) => Err(pair::data_by_value(pat, ty, &reference.elem)),
        Type::Group(group) => data(pat, &group.elem),
        Type::Paren(paren) => data(pat, &paren.elem),
        _ => Err(pair::data_by_value(pat, ty, ty)),
    }
}

/// Whether both are written alike.
pub(super) fn same(one: &Type, other: &Type) -> bool {
    one.to_token_stream().to_string() == other.to_token_stream().to_string()
}

/// Checks what only all arguments together can show.
pub(super) fn check(arguments: &Arguments, whole: &impl ToTokens, of: Role, errors: &mut Vec<syn::Error>) {
    if arguments.names(ArgumentRole::Refused) {
        return;
    }
    let is = |wanted: fn(PairArgument) -> bool| {
        arguments.list.iter().find(|argument| matches!(argument.role, ArgumentRole::Pair(role) if wanted(role)))
    };
    let distance = is(|role| role == PairArgument::Distance);
    let separation = is(|role| matches!(role, PairArgument::Separation(_)));
    match (of, distance, separation) {
        (Role::Pair, None, None) => errors.push(pair::no_separation(whole)),
        (Role::Pair, Some(distance), Some(_)) => errors.push(pair::distance_and_separation(&distance.pattern)),
        (Role::PairForce, ..) if arguments.dimension == 0 => errors.push(pair::no_vector(whole)),
        _ => {}
    }
}
