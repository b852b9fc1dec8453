//! What a potential takes and returns.

use std::collections::BTreeMap;

use quote::ToTokens;
use syn::{
    Expr, FnArg, ImplItemConst, ImplItemFn, Lit, Pat, PatType, ReceiverKind, ReturnType, Safety, Signature, Type,
};

use crate::diagnostics::law;
use crate::role::Role;

use super::argument::{Argument, Arguments, Body, PairArgument, Quantity, Shape};
use super::types::Length;
use super::{Known, Sibling, known_type, pair};

/// A symbolic Hessian of more coordinates than this is no help to anyone.
const MAX_DIMENSION: usize = 64;

/// Checks that a method can be a potential, or a force.
pub(super) fn check(
    method: &ImplItemFn,
    role: Role,
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
        errors.push(law::own_generics(&signature.generics, role));
    }
    if let Some(clause) = &signature.generics.where_clause {
        errors.push(law::own_generics(clause, role));
    }
    match signature.receiver() {
        None => errors.push(law::no_receiver(signature, role)),
        Some(receiver) => match &receiver.kind {
            ReceiverKind::Reference(_, _, None) => {}
            ReceiverKind::Reference(_, _, Some(_)) => errors.push(law::mutable_receiver(receiver, role)),
            _ => errors.push(law::other_receiver(receiver, role)),
        },
    }
    let typed = signature.inputs.iter().filter_map(|input| match input {
        FnArg::Typed(typed) => Some(typed),
        FnArg::Receiver(_) => None,
    });
    let mut arguments = arguments(typed, role, constants, errors);
    if role.is_of_two() {
        pair::check(&arguments, &signature.ident, role, errors);
    } else if arguments.dimension == 0 && !arguments.names(Quantity::Refused) {
        let missing = match role {
            Role::Force => law::no_position_or_velocity,
            Role::Invariant => law::no_argument_of_invariant,
            _ => law::no_position,
        };
        errors.push(missing(&signature.ident));
    }
    if role.is_force() {
        arguments.result = returns_force(signature, arguments.dimension, constants, errors);
    } else if role == Role::Invariant {
        match &signature.output {
            ReturnType::Type(_, ty) if known_type(ty) == Known::Float && !matches!(&**ty, Type::Reference(_)) => {}
            ReturnType::Type(_, ty) => errors.push(law::wrong_invariant(ty)),
            ReturnType::Default => errors.push(law::wrong_invariant(&signature.ident)),
        }
    } else {
        returns_number(&signature.output, &signature.ident, errors);
    }
    arguments
}

/// Checks a return type; a closure need not state it.
pub(super) fn returns_number(output: &ReturnType, whole: &impl ToTokens, errors: &mut Vec<syn::Error>) {
    match output {
        ReturnType::Default => errors.push(law::returns_nothing(whole)),
        ReturnType::Type(_, ty) if matches!(&**ty, Type::Reference(_)) => errors.push(law::wrong_return(ty)),
        ReturnType::Type(_, ty) => match known_type(ty) {
            Known::Float => {}
            Known::Single => say_once(law::single_precision(ty), errors),
            _ => errors.push(law::wrong_return(ty)),
        },
    }
}

/// Checks that a force is returned in a form that a position can have, with as many components.
fn returns_force(
    signature: &Signature,
    dimension: usize,
    constants: &BTreeMap<String, Sibling<ImplItemConst>>,
    errors: &mut Vec<syn::Error>,
) -> Shape {
    let ReturnType::Type(_, ty) = &signature.output else {
        errors.push(law::no_force_returned(&signature.ident));
        return Shape::Array;
    };
    match position(ty, constants) {
        Ok((shape, count)) if dimension == 0 || count == dimension => shape,
        Ok((shape, count)) => {
            errors.push(law::force_of_other_dimension(ty, count, dimension));
            shape
        }
        Err(_) => {
            errors.push(law::wrong_force(ty));
            Shape::Array
        }
    }
}

/// Reads `q: [f64; 2], m: f64, t: f64`, and of a force `v: [f64; 2]` too.
pub(super) fn arguments<'a>(
    typed: impl Iterator<Item = &'a PatType>,
    role: Role,
    constants: &BTreeMap<String, Sibling<ImplItemConst>>,
    errors: &mut Vec<syn::Error>,
) -> Arguments {
    let mut arguments = Arguments { list: vec![], dimension: 0, result: Shape::Number, data: None };
    let typed: Vec<_> = typed.collect();
    let apart = coordinates_apart(&typed, role);
    if !apart.is_empty() {
        errors.push(law::coordinates_apart(&apart, role));
    }
    for PatType { pat, ty, .. } in typed {
        if apart.iter().any(|&coordinate| std::ptr::eq(coordinate, &**pat)) {
            arguments.list.push(Argument { quantity: Quantity::Refused, pattern: (**pat).clone() });
            continue;
        }
        let quantity = match argument(pat, ty, role, constants, &mut arguments) {
            Ok(quantity) => quantity,
            Err(error) => {
                say_once(error, errors);
                Quantity::Refused
            }
        };
        if quantity != Quantity::Refused && arguments.names(quantity) {
            errors.push(law::named_twice(pat));
        }
        arguments.list.push(Argument { quantity, pattern: (**pat).clone() });
    }
    arguments
}

/// `x: f64, y: f64` where `q: [f64; 2]` is meant, or `d: [f64; 2]`.
fn coordinates_apart<'a>(typed: &[&'a PatType], of: Role) -> Vec<&'a Pat> {
    let is_coordinate = |typed: &&&PatType| match &*typed.pat {
        Pat::Ident(name) => {
            let name = used_name(&name.ident);
            let free = ![of, Role::Force].iter().any(|role| role.knows(&name));
            free && name.len() == 1 && known_type(&typed.ty) == Known::Float
        }
        _ => false,
    };
    let coordinates: Vec<_> = typed.iter().filter(is_coordinate).map(|typed| &*typed.pat).collect();
    let says_where = |name: &syn::Ident| {
        let name = used_name(name);
        name == of.place().name || (of == Role::Pair && name == "r")
    };
    let has_position = typed.iter().any(|typed| matches!(&*typed.pat, Pat::Ident(name) if says_where(&name.ident)));
    if coordinates.len() > 1 && !has_position { coordinates } else { vec![] }
}

/// `q` of `_q` as well, which is how Rust writes an argument that is not used.
fn used_name(name: &syn::Ident) -> String {
    let name = name.to_string();
    name.strip_prefix('_').map_or_else(|| name.clone(), str::to_owned)
}

/// A law in `f32` is one mistake, however many types show it.
fn say_once(error: syn::Error, errors: &mut Vec<syn::Error>) {
    let sentence = error.to_string();
    if !errors.iter().any(|said| said.to_string() == sentence) {
        errors.push(error);
    }
}

fn argument(
    pat: &Pat,
    ty: &Type,
    of: Role,
    constants: &BTreeMap<String, Sibling<ImplItemConst>>,
    arguments: &mut Arguments,
) -> Result<Quantity, syn::Error> {
    let name = match pat {
        Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() => &name.ident,
        Pat::Slice(_) | Pat::Tuple(_) | Pat::Reference(_) => return Err(law::place_in_pieces(pat, of)),
        _ => return Err(law::unknown_argument(pat, of)),
    };
    let text = used_name(name);
    if !of.knows(&text) {
        return Err(law::argument_of_another_role(name, of).unwrap_or_else(|| law::unknown_argument(name, of)));
    }
    let mut vector = || {
        let (shape, count) = position(ty, constants)?;
        if arguments.dimension != 0 && arguments.dimension != count {
            return Err(law::force_of_other_dimension(ty, count, arguments.dimension));
        }
        arguments.dimension = count;
        Ok(shape)
    };
    Ok(match text.as_str() {
        "q" => Quantity::Position(vector()?),
        "v" => Quantity::Velocity(vector()?),
        "m" => number(ty, "mass", &text).map(|()| Quantity::Mass)?,
        "t" => number(ty, "time", &text).map(|()| Quantity::Time)?,
        "r" => number(ty, "distance", &text).map(|()| Quantity::Pair(PairArgument::Distance))?,
        "d" => Quantity::Pair(PairArgument::Separation(vector()?)),
        "va" => Quantity::Pair(PairArgument::Velocity(Body::A, vector()?)),
        "vb" => Quantity::Pair(PairArgument::Velocity(Body::B, vector()?)),
        "ma" => number(ty, "mass", &text).map(|()| Quantity::Pair(PairArgument::Mass(Body::A)))?,
        "mb" => number(ty, "mass", &text).map(|()| Quantity::Pair(PairArgument::Mass(Body::B)))?,
        "a" => pair::data_argument(pat, ty, Body::A, arguments)?,
        "b" => pair::data_argument(pat, ty, Body::B, arguments)?,
        _ => return Err(law::unknown_argument(pat, of)),
    })
}

fn number(ty: &Type, quantity: &str, name: &str) -> Result<(), syn::Error> {
    match known_type(ty) {
        Known::Float if !matches!(ty, Type::Reference(_)) => Ok(()),
        _ => Err(law::not_a_number(ty, quantity, name)),
    }
}

fn position(ty: &Type, constants: &BTreeMap<String, Sibling<ImplItemConst>>) -> Result<(Shape, usize), syn::Error> {
    if let Type::Reference(reference) = ty {
        let by_value = known_type(&reference.elem) != Known::Other;
        return Err(if by_value { law::position_by_reference(ty) } else { law::wrong_position(ty) });
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
