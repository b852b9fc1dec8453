//! What a law between two bodies takes.

use std::collections::BTreeMap;

use quote::ToTokens;
use syn::{ImplItemConst, Pat, Type};

use crate::diagnostics::{law, pair};

use super::roles::Role;
use super::signature::{self, Arguments};
use super::{ArgumentRole, Shape, Sibling};

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

/// Reads one argument of a `#[pair]` or a `#[pair_force]`.
pub(super) fn argument(
    pat: &Pat,
    ty: &Type,
    of: Role,
    constants: &BTreeMap<String, Sibling<ImplItemConst>>,
    arguments: &mut Arguments,
) -> Result<ArgumentRole, syn::Error> {
    let name = match pat {
        Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() => name.ident.to_string(),
        Pat::Slice(_) | Pat::Tuple(_) | Pat::Reference(_) => return Err(pair::in_pieces(pat)),
        _ => return Err(pair::unknown_argument(pat, of == Role::PairForce)),
    };
    let vector = |arguments: &mut Arguments| {
        let (shape, count) = signature::position(ty, constants)?;
        if arguments.dimension != 0 && arguments.dimension != count {
            return Err(law::force_of_other_dimension(ty, count, arguments.dimension));
        }
        arguments.dimension = count;
        Ok(shape)
    };
    let role = match (name.as_str(), of) {
        ("r", Role::Pair) => {
            signature::number(ty, "distance", &name)?;
            PairArgument::Distance
        }
        ("r", _) => return Err(pair::distance_of_a_force(pat)),
        ("d", _) => PairArgument::Separation(vector(arguments)?),
        ("va" | "vb", Role::Pair) => return Err(pair::velocity_of_a_potential(pat)),
        ("va", _) => PairArgument::Velocity(Body::A, vector(arguments)?),
        ("vb", _) => PairArgument::Velocity(Body::B, vector(arguments)?),
        ("ma" | "mb", _) => {
            signature::number(ty, "mass", &name)?;
            PairArgument::Mass(if name == "ma" { Body::A } else { Body::B })
        }
        ("a" | "b", _) => {
            let data = data(pat, ty)?;
            match &arguments.data {
                Some(other) if !same(other, data) => return Err(pair::two_data_types(ty, other)),
                _ => arguments.data = Some(data.clone()),
            }
            PairArgument::Data(if name == "a" { Body::A } else { Body::B })
        }
        ("t", _) => return signature::number(ty, "time", &name).map(|()| ArgumentRole::Time),
        ("q" | "v" | "m", _) => return Err(pair::argument_of_one_body(pat, &name, of == Role::PairForce)),
        _ => return Err(pair::unknown_argument(pat, of == Role::PairForce)),
    };
    Ok(ArgumentRole::Pair(role))
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
