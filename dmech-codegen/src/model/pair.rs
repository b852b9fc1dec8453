//! What a law between two bodies takes.

use quote::ToTokens;
use syn::{Pat, Type};

use crate::diagnostics::pair;
use crate::role::Role;

use super::argument::{Arguments, Body, PairArgument, Quantity};

/// A law between two bodies, beside its formulas.
pub struct PairSignature {
    /// The type of the data that the law reads, `Charge` of `a: &Charge`.
    pub data: Option<Type>,
}

/// Reads `a: &Charge`.
pub(super) fn data_argument(pat: &Pat, ty: &Type, of: Body, arguments: &mut Arguments) -> Result<Quantity, syn::Error> {
    let data = data(pat, ty)?;
    match &arguments.data {
        Some(other) if !same(other, data) => return Err(pair::two_data_types(ty, other)),
        _ => arguments.data = Some(data.clone()),
    }
    Ok(Quantity::Pair(PairArgument::Data(of)))
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
    if arguments.names(Quantity::Refused) {
        return;
    }
    let is = |wanted: fn(PairArgument) -> bool| {
        arguments.list.iter().find(|argument| matches!(argument.quantity, Quantity::Pair(of_two) if wanted(of_two)))
    };
    let distance = is(|of_two| of_two == PairArgument::Distance);
    let separation = is(|of_two| matches!(of_two, PairArgument::Separation(_)));
    match (of, distance, separation) {
        (Role::Pair, None, None) => errors.push(pair::no_separation(whole)),
        (Role::Pair, Some(distance), Some(_)) => errors.push(pair::distance_and_separation(&distance.pattern)),
        (Role::PairForce, ..) if arguments.dimension == 0 => errors.push(pair::no_vector(whole)),
        _ => {}
    }
}
