//! What a potential takes and returns.

use std::collections::BTreeMap;

use quote::ToTokens;
use syn::{Expr, FnArg, ImplItemConst, ImplItemFn, Lit, Pat, PatType, ReceiverKind, ReturnType, Safety, Type};

use crate::diagnostics::law;

use super::types::Length;
use super::{Argument, ArgumentRole, Known, Shape, Sibling, known_type};

/// A symbolic Hessian of more coordinates than this is no help to anyone.
const MAX_DIMENSION: usize = 64;

/// The arguments, and the number of coordinates; 0 where the position is refused.
pub(super) struct Arguments {
    pub(super) list: Vec<Argument>,
    pub(super) dimension: usize,
}

impl Arguments {
    pub(super) fn names(&self, role: ArgumentRole) -> bool {
        self.list.iter().any(|argument| argument.role == role)
    }
}

/// Checks that a method can be a potential.
pub(super) fn check(
    method: &ImplItemFn,
    constants: &BTreeMap<String, Sibling<ImplItemConst>>,
    errors: &mut Vec<syn::Error>,
) -> Arguments {
    let signature = &method.sig;
    if let Some(asyncness) = &signature.asyncness {
        errors.push(law::keyword(asyncness, "async"));
    }
    if let Safety::Unsafe(unsafety) = &signature.safety {
        errors.push(law::keyword(unsafety, "unsafe"));
    }
    if let Some(abi) = &signature.abi {
        errors.push(law::keyword(abi, "extern"));
    }
    if !signature.generics.params.is_empty() {
        errors.push(law::own_generics(&signature.generics));
    }
    if let Some(clause) = &signature.generics.where_clause {
        errors.push(law::own_generics(clause));
    }
    match signature.receiver() {
        None => errors.push(law::no_receiver(&signature.ident)),
        Some(receiver) => match &receiver.kind {
            ReceiverKind::Reference(_, _, None) => {}
            ReceiverKind::Reference(_, _, Some(_)) => errors.push(law::mutable_receiver(receiver)),
            _ => errors.push(law::other_receiver(receiver)),
        },
    }
    let typed = signature.inputs.iter().filter_map(|input| match input {
        FnArg::Typed(typed) => Some(typed),
        FnArg::Receiver(_) => None,
    });
    let arguments = arguments(typed, constants, errors);
    if arguments.dimension == 0 && !arguments.list.iter().any(|argument| argument.role == ArgumentRole::Refused) {
        errors.push(law::no_position(&signature.ident));
    }
    returns_number(&signature.output, &signature.ident, errors);
    arguments
}

/// Checks a return type; a closure need not state it.
pub(super) fn returns_number(output: &ReturnType, whole: &impl ToTokens, errors: &mut Vec<syn::Error>) {
    match output {
        ReturnType::Default => errors.push(law::returns_nothing(whole)),
        ReturnType::Type(_, ty) if matches!(&**ty, Type::Reference(_)) => errors.push(law::wrong_return(ty)),
        ReturnType::Type(_, ty) => match known_type(ty) {
            Known::Float => {}
            Known::Single => errors.push(law::single_precision(ty)),
            _ => errors.push(law::wrong_return(ty)),
        },
    }
}

/// Reads `q: [f64; 2], m: f64, t: f64`.
pub(super) fn arguments<'a>(
    typed: impl Iterator<Item = &'a PatType>,
    constants: &BTreeMap<String, Sibling<ImplItemConst>>,
    errors: &mut Vec<syn::Error>,
) -> Arguments {
    let mut arguments = Arguments { list: vec![], dimension: 0 };
    for PatType { pat, ty, .. } in typed {
        let role = match argument(pat, ty, constants, &mut arguments.dimension) {
            Ok(role) => role,
            Err(error) => {
                errors.push(error);
                ArgumentRole::Refused
            }
        };
        if role != ArgumentRole::Refused && arguments.names(role) {
            errors.push(law::named_twice(pat));
        }
        arguments.list.push(Argument { role, pattern: (**pat).clone() });
    }
    arguments
}

fn argument(
    pat: &Pat,
    ty: &Type,
    constants: &BTreeMap<String, Sibling<ImplItemConst>>,
    dimension: &mut usize,
) -> Result<ArgumentRole, syn::Error> {
    let name = match pat {
        Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() => name.ident.to_string(),
        Pat::Slice(_) | Pat::Tuple(_) | Pat::Reference(_) => return Err(law::position_in_pieces(pat)),
        _ => return Err(law::unknown_argument(pat)),
    };
    match name.as_str() {
        "q" => {
            let (shape, count) = position(ty, constants)?;
            *dimension = count;
            Ok(ArgumentRole::Position(shape))
        }
        "m" => number(ty, "mass", &name).map(|()| ArgumentRole::Mass),
        "t" => number(ty, "time", &name).map(|()| ArgumentRole::Time),
        "v" => Err(law::velocity_argument(pat)),
        _ => Err(law::unknown_argument(pat)),
    }
}

fn number(ty: &Type, quantity: &str, name: &str) -> Result<(), syn::Error> {
    match known_type(ty) {
        Known::Float if !matches!(ty, Type::Reference(_)) => Ok(()),
        _ => Err(law::not_a_number(ty, quantity, name)),
    }
}

fn position(
    ty: &Type,
    constants: &BTreeMap<String, Sibling<ImplItemConst>>,
) -> Result<(Shape, usize), syn::Error> {
    if matches!(ty, Type::Reference(_)) {
        return Err(law::position_by_reference(ty));
    }
    let (shape, length) = match known_type(ty) {
        Known::Float => return Ok((Shape::Number, 1)),
        Known::Array(of, length) if *of == Known::Float => (Shape::Array, length),
        Known::Vector(length) => (Shape::Vector, length),
        Known::Single => return Err(law::single_precision(ty)),
        Known::Array(of, _) if *of == Known::Single => return Err(law::single_precision(ty)),
        _ => return Err(law::wrong_position(ty)),
    };
    let count = match length {
        Some(Length::Literal(count)) => Some(count),
        Some(Length::Constant(name)) => constants.get(&name).and_then(literal_constant),
        None => None,
    };
    match count {
        None => Err(law::unknown_dimension(ty)),
        Some(0) => Err(law::no_coordinates(ty)),
        Some(count) if count > MAX_DIMENSION => Err(law::too_many_coordinates(ty, count, MAX_DIMENSION)),
        Some(count) => Ok((shape, count)),
    }
}

/// `const D: usize = 2;`
fn literal_constant(constant: &Sibling<ImplItemConst>) -> Option<usize> {
    match constant {
        Sibling::One(constant) => match &constant.expr {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Int(n) => n.base10_parse().ok(),
                _ => None,
            },
            _ => None,
        },
        Sibling::Conditional => None,
    }
}
