//! About laws between two bodies.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::Error;

use crate::role::Role;

use super::{at, text};

pub(crate) fn argument_of_one_body(name: &Ident, role: Role) -> Error {
    let text = name.to_string();
    let instead = match (text.as_str(), role.is_force()) {
        ("q", false) => "the distance `r: f64`, or the separation `d: [f64; D]`, which is q_a − q_b",
        ("q", true) => "the separation `d: [f64; D]`, which is q_a − q_b",
        ("v", true) => "`va` and `vb`",
        ("v", false) => "no velocity in a potential; state a force of `va` and `vb` with `#[pair_force]`",
        _ => "`ma` and `mb`",
    };
    at!(name, "`{text}` belongs to a law of one body, and here there are two: write {instead}")
}

pub(crate) fn distance_of_a_force(pattern: &impl ToTokens) -> Error {
    at(
        pattern,
        "a force between two bodies has a direction: take the separation `d: [f64; D]`, whose length is the distance, \
         `let r = (d[0] * d[0] + d[1] * d[1]).sqrt();`",
    )
}

pub(crate) fn data_by_value(pattern: &impl ToTokens, whole: &impl ToTokens, ty: &impl ToTokens) -> Error {
    at!(whole, "the data of a body is only read; take it by reference: `{}: &{}`", text(pattern), text(ty))
}

pub(crate) fn two_data_types(ty: &impl ToTokens, other: &impl ToTokens) -> Error {
    at!(
        ty,
        "all bodies of a scene carry data of one type, and this law has named `&{}` before; collect what different \
         bodies carry in one struct",
        text(other)
    )
}

pub(crate) fn no_separation(whole: &impl ToTokens) -> Error {
    at(
        whole,
        "a potential of two bodies is a function of where they are; give it the distance `r: f64` or the separation \
         `d: [f64; D]`, which is q_a − q_b",
    )
}

pub(crate) fn no_vector(whole: &impl ToTokens) -> Error {
    at(
        whole,
        "a force between two bodies is a function of their separation and velocities; give it `d: [f64; D]`, \
         `va: [f64; D]`, `vb: [f64; D]` or several of them",
    )
}

pub(crate) fn distance_and_separation(pattern: &impl ToTokens) -> Error {
    at(
        pattern,
        "the distance `r` is the length of the separation `d`; name one of the two and compute the other from it",
    )
}

pub(crate) fn whole_data(at_code: &dyn ToTokens) -> Error {
    let name = text(&at_code.to_token_stream());
    at!(
        &at_code.to_token_stream(),
        "`{name}` is all the data of a body, and here a number is needed: name one of its fields of type `f64`, \
         `{name}.q`"
    )
}

pub(crate) fn method_of_data(name: &Ident) -> Error {
    at!(
        name,
        "`{name}` is a method of the data, which the macro cannot see; read the fields themselves (`a.q`), or write a \
         helper in this block that takes the numbers"
    )
}

pub(crate) fn invariant_of_two(name: &Ident) -> Error {
    at!(
        name,
        "`{name}` is an invariant of one body in a law between two; what many bodies keep is computed from the states of the run"
    )
}

pub(crate) fn one_body_beside(name: &Ident) -> Error {
    at!(
        name,
        "`{name}` acts on one body and another method of this block on two; put them on two types, one law each, and \
         give the scene both: `.field(one).pairs(other)`"
    )
}

pub(crate) fn not_of_one_body(self_ty: &impl ToTokens) -> Error {
    at(self_ty, "this is a law between two bodies")
}
