//! About laws between two bodies.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::Error;

use crate::model::Model;

use super::{at, text};

const PAIR: &str = "`r` (distance) or `d` (separation q_a − q_b), `ma`, `mb` (masses), `a: &P`, `b: &P` (data of the \
                    bodies), `t` (time)";
const PAIR_FORCE: &str = "`d` (separation q_a − q_b), `va`, `vb` (velocities), `ma`, `mb` (masses), `a: &P`, `b: &P` \
                          (data of the bodies), `t` (time)";

fn expected(force: bool) -> &'static str {
    if force { PAIR_FORCE } else { PAIR }
}

fn role(force: bool) -> &'static str {
    if force { "`#[pair_force]`" } else { "`#[pair]`" }
}

pub(crate) fn unknown_argument(pattern: &impl ToTokens, force: bool) -> Error {
    at(
        pattern,
        format!(
            "`{}` is not an argument a {} can have; expected one of: {}. Parameters are fields of the law: `self.k`",
            text(pattern),
            role(force),
            expected(force)
        ),
    )
}

pub(crate) fn argument_of_one_body(pattern: &impl ToTokens, name: &str, force: bool) -> Error {
    let instead = match (name, force) {
        ("q", false) => "the distance `r: f64`, or the separation `d: [f64; D]`, which is q_a − q_b",
        ("q", true) => "the separation `d: [f64; D]`, which is q_a − q_b",
        ("v", true) => "`va` and `vb`",
        ("v", false) => "no velocity in a potential; state a force of `va` and `vb` with `#[pair_force]`",
        _ => "`ma` and `mb`",
    };
    at(pattern, format!("`{name}` belongs to a law of one body, and here there are two: write {instead}"))
}

pub(crate) fn in_pieces(pattern: &impl ToTokens) -> Error {
    at(
        pattern,
        format!("the separation is one argument, `d`; take it to pieces in the body: `let {} = d;`", text(pattern)),
    )
}

pub(crate) fn distance_of_a_force(pattern: &impl ToTokens) -> Error {
    at(
        pattern,
        "a force between two bodies has a direction: take the separation `d: [f64; D]`, whose length is the distance, \
         `let r = (d[0] * d[0] + d[1] * d[1]).sqrt();`",
    )
}

pub(crate) fn velocity_of_a_potential(pattern: &impl ToTokens) -> Error {
    at(
        pattern,
        format!(
            "a potential energy does not depend on the velocity `{}`; state a force with `#[pair_force]`, alone or beside \
             the `#[pair]`",
            text(pattern)
        ),
    )
}

pub(crate) fn data_by_value(pattern: &impl ToTokens, whole: &impl ToTokens, ty: &impl ToTokens) -> Error {
    at(whole, format!("the data of a body is only read; take it by reference: `{}: &{}`", text(pattern), text(ty)))
}

pub(crate) fn two_data_types(ty: &impl ToTokens, other: &impl ToTokens) -> Error {
    at(
        ty,
        format!(
            "all bodies of a scene carry data of one type, and this law has named `&{}` before; collect what different \
             bodies carry in one struct",
            text(other)
        ),
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
    at(
        &at_code.to_token_stream(),
        format!(
            "`{name}` is all the data of a body, and here a number is needed: name one of its fields of type `f64`, \
             `{name}.q`"
        ),
    )
}

pub(crate) fn method_of_data(name: &Ident) -> Error {
    at(
        name,
        format!(
            "`{name}` is a method of the data, which the macro cannot see; read the fields themselves (`a.q`), or write a \
             helper in this block that takes the numbers"
        ),
    )
}

pub(crate) fn one_body_beside(name: &Ident) -> Error {
    at(
        name,
        format!(
            "`{name}` acts on one body and another method of this block on two; put them on two types, one law each, and give \
             the scene both: `.field(one).pairs(other)`"
        ),
    )
}

pub(crate) fn not_of_one_body(model: &Model) -> Error {
    at(&model.self_ty, "this is a law between two bodies")
}

pub(crate) fn of_one_body(model: &Model) -> Error {
    at(&model.self_ty, "this is a law of one body, not between two")
}

/// A name that the body of a law between two bodies reads without declaring it.
pub(crate) fn undeclared(model: &Model, name: &Ident) -> Option<Error> {
    model.pair.as_ref()?;
    let text = name.to_string();
    let declare = |what: &str, declaration: &str| {
        format!("the {what} `{text}` is read here and not declared; add it to the arguments: `{declaration}`")
    };
    let message = match text.as_str() {
        "r" => declare("distance", "r: f64"),
        "d" => declare("separation", "d: [f64; D]"),
        "ma" | "mb" => declare("mass", &format!("{text}: f64")),
        "a" | "b" => declare("data", &format!("{text}: &P")),
        "va" | "vb" => {
            format!("{}; only a `#[pair_force]` can have it", declare("velocity", &format!("{text}: [f64; D]")))
        }
        "t" => declare("time", "t: f64"),
        "q" => "there are two positions; a law between bodies sees their difference, `d`, or its length, `r`".into(),
        "v" => "there are two velocities, `va` and `vb`; a `#[pair_force]` can take them".into(),
        "m" => "there are two masses, `ma` and `mb`; add them to the arguments".into(),
        _ => return None,
    };
    Some(at(name, message))
}
