//! What a potential takes and returns.

use std::collections::BTreeMap;

use quote::ToTokens;
use syn::{
    Expr, FnArg, ImplItemConst, ImplItemFn, Lit, Pat, PatType, ReceiverKind, ReturnType, Safety, Signature, Type,
};

use crate::diagnostics::law;

use super::roles::Role;
use super::types::Length;
use super::{Argument, ArgumentRole, Known, Shape, Sibling, known_type, pair};

/// A symbolic Hessian of more coordinates than this is no help to anyone.
const MAX_DIMENSION: usize = 64;

/// The arguments, and the number of coordinates; 0 where the position is refused.
pub(super) struct Arguments {
    pub(super) list: Vec<Argument>,
    pub(super) dimension: usize,
    /// How the value is written.
    pub(super) result: Shape,
    /// The type of the data of two bodies.
    pub(super) data: Option<Type>,
}

impl Arguments {
    pub(super) fn names(&self, role: ArgumentRole) -> bool {
        self.list.iter().any(|argument| argument.role == role)
    }
}

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
    let mut arguments = arguments(typed, role, constants, errors);
    if matches!(role, Role::Pair | Role::PairForce) {
        pair::check(&arguments, &signature.ident, role, errors);
    } else if arguments.dimension == 0 && !arguments.list.iter().any(|argument| argument.role == ArgumentRole::Refused)
    {
        let missing = if role == Role::Force { law::no_position_or_velocity } else { law::no_position };
        errors.push(missing(&signature.ident));
    }
    match role {
        Role::Force | Role::PairForce => {
            arguments.result = returns_force(signature, arguments.dimension, constants, errors)
        }
        _ => returns_number(&signature.output, &signature.ident, errors),
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
            Known::Single => errors.push(law::single_precision(ty)),
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
    for PatType { pat, ty, .. } in typed {
        let read = match role {
            Role::Pair | Role::PairForce => pair::argument(pat, ty, role, constants, &mut arguments),
            _ => argument(pat, ty, role, constants, &mut arguments.dimension),
        };
        let role = match read {
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
    of: Role,
    constants: &BTreeMap<String, Sibling<ImplItemConst>>,
    dimension: &mut usize,
) -> Result<ArgumentRole, syn::Error> {
    let name = match pat {
        Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() => name.ident.to_string(),
        Pat::Slice(_) | Pat::Tuple(_) | Pat::Reference(_) => return Err(law::position_in_pieces(pat)),
        _ => return Err(law::unknown_argument(pat)),
    };
    match name.as_str() {
        "v" if of != Role::Force => Err(law::velocity_argument(pat)),
        "q" | "v" => {
            let (shape, count) = position(ty, constants)?;
            if *dimension != 0 && *dimension != count {
                return Err(law::force_of_other_dimension(ty, count, *dimension));
            }
            *dimension = count;
            Ok(if name == "q" { ArgumentRole::Position(shape) } else { ArgumentRole::Velocity(shape) })
        }
        "m" => number(ty, "mass", &name).map(|()| ArgumentRole::Mass),
        "t" => number(ty, "time", &name).map(|()| ArgumentRole::Time),
        _ if of == Role::Force => Err(law::unknown_force_argument(pat)),
        _ => Err(law::unknown_argument(pat)),
    }
}

pub(super) fn number(ty: &Type, quantity: &str, name: &str) -> Result<(), syn::Error> {
    match known_type(ty) {
        Known::Float if !matches!(ty, Type::Reference(_)) => Ok(()),
        _ => Err(law::not_a_number(ty, quantity, name)),
    }
}

pub(super) fn position(
    ty: &Type,
    constants: &BTreeMap<String, Sibling<ImplItemConst>>,
) -> Result<(Shape, usize), syn::Error> {
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
