//! About the law: where the attribute stands, what the potential takes and returns.

use proc_macro2::{Ident, Span};
use quote::ToTokens;
use syn::{Error, Item};

use super::{at, text};

pub(crate) fn unreadable_option(span: Span) -> Error {
    Error::new(span, "this is no option of the macro; the only one is `crate = path::to::dmech`")
}

pub(crate) fn unknown_option(option: &Ident) -> Error {
    at(option, format!("`{option}` is no option of the macro; the only one is `crate = path::to::dmech`"))
}

pub(crate) fn bare_option(attribute: &impl ToTokens) -> Error {
    at(attribute, "write `#[dmech(crate = path::to::dmech)]`")
}

pub(crate) fn too_deep(span: Span) -> Error {
    Error::new(span, "this is nested too deeply to be read; bind an inner part to a name with `let`")
}

pub(crate) fn too_long(span: Span) -> Error {
    Error::new(span, "this expression is too long to be read; bind parts of it to names with `let`, or write a sum")
}

pub(crate) fn not_an_impl(item: &Item) -> Error {
    let (what, name): (_, &dyn ToTokens) = match item {
        Item::Struct(item) => {
            let message = format!(
                "`#[dmech::law]` goes on the `impl` block of the law: `impl {} {{ #[potential] fn energy(&self, q: [f64; \
                 2]) -> f64 {{ … }} }}`; on the struct itself write `#[derive(dmech::Law)]` and \
                 `#[potential(|q: [f64; 2]| …)]`",
                item.ident
            );
            return at(&item.ident, message);
        }
        Item::Fn(item) => ("function", &item.sig.ident),
        Item::Enum(item) => ("enum", &item.ident),
        Item::Union(item) => ("union", &item.ident),
        Item::Trait(item) => ("trait", &item.ident),
        Item::Mod(item) => ("module", &item.ident),
        other => ("item", other),
    };
    let message = format!(
        "`#[dmech::law]` cannot stand on this {what}: it goes on an inherent `impl` block, `impl Kepler {{ #[potential] \
         fn energy(&self, q: [f64; 2]) -> f64 {{ … }} }}`"
    );
    at(&name.to_token_stream(), message)
}

pub(crate) fn not_a_struct(item: &Item) -> Error {
    let (what, name): (_, &dyn ToTokens) = match item {
        Item::Enum(item) => ("an enum", &item.ident),
        Item::Union(item) => ("a union", &item.ident),
        other => ("this item", other),
    };
    at(
        &name.to_token_stream(),
        format!("a law is a struct whose fields are its parameters; `dmech::Law` cannot be derived for {what}"),
    )
}

pub(crate) fn trait_impl(path: &impl ToTokens) -> Error {
    at(
        path,
        "`#[dmech::law]` goes on an inherent block, `impl Kepler { … }`, not on the implementation of a trait; the traits \
         of mechanics are implemented by the macro",
    )
}

pub(crate) fn unnamed_type(ty: &impl ToTokens) -> Error {
    at(ty, "a law is stated for a type with a name: `impl Kepler { … }`")
}

pub(crate) fn no_role(ty: &impl ToTokens) -> Error {
    at(
        ty,
        format!(
            "no method of this block has a role; mark the one that returns the potential energy of `{}` with \
             `#[potential]`",
            text(ty)
        ),
    )
}

pub(crate) fn role_arguments(attribute: &impl ToTokens) -> Error {
    at(attribute, "the role of a method takes no arguments; the method says it all")
}

pub(crate) fn conditional_potential(cfg: &impl ToTokens) -> Error {
    at(
        cfg,
        "whether this `#[cfg]` holds is not known when the macro runs; put it on the whole `impl` block, one block for each \
         case",
    )
}

pub(crate) fn two_roles(attribute: &impl ToTokens) -> Error {
    at(attribute, "a method has one role; state the potential and the force in two methods")
}

pub(crate) fn other_dimension(name: &Ident, own: usize, other: usize) -> Error {
    at(name, format!("`{name}` has {own} coordinates and the potential of this law has {other}"))
}

pub(crate) fn no_position_or_velocity(whole: &impl ToTokens) -> Error {
    at(
        whole,
        "a force is a function of position and velocity; give it an argument `q: [f64; D]`, `v: [f64; D]` or both",
    )
}

pub(crate) fn no_force_returned(whole: &impl ToTokens) -> Error {
    at(whole, "a force returns its components in the form of the position; add `-> [f64; D]`")
}

pub(crate) fn wrong_force(ty: &impl ToTokens) -> Error {
    at(
        ty,
        format!(
            "`{}` cannot be a force; it is written like the position: `f64`, `[f64; D]` or `SVector<f64, D>`",
            text(ty)
        ),
    )
}

pub(crate) fn force_of_other_dimension(ty: &impl ToTokens, own: usize, other: usize) -> Error {
    at(
        ty,
        format!("this has {own} components, and {other} are named before; position, velocity and force have as many"),
    )
}

pub(crate) fn unknown_force_argument(pattern: &impl ToTokens) -> Error {
    at(
        pattern,
        format!(
            "`{}` is not an argument a force can have; expected one of: `q` (position), `v` (velocity), `m` (mass), `t` \
             (time). Parameters are fields of the law: `self.k`",
            text(pattern)
        ),
    )
}

pub(crate) fn second_of_its_role(second: &Ident, first: &Ident, what: &str) -> Error {
    at(
        second,
        format!(
            "`{second}` is a second {what}, and a law has one; `{first}` is marked already. Add the two in one method, \
             with the other as a helper"
        ),
    )
}

pub(crate) fn first_of_its_role(first: &Ident, what: &str) -> Error {
    at(first, format!("`{first}` is the first `#[{what}]` of this law"))
}

pub(crate) fn second_closure(attribute: &impl ToTokens) -> Error {
    at(attribute, "a second potential, and a law has one; add the two in one closure")
}

pub(crate) fn no_closure(name: &Ident) -> Error {
    at(name, format!("the potential of `{name}` is not stated; write `#[potential(|q: [f64; 2]| …)]` below the derive"))
}

pub(crate) fn not_a_closure(tokens: &impl ToTokens) -> Error {
    at(
        tokens,
        "the potential is stated as a closure of the position: `#[potential(|q: [f64; 1]| 0.5 * self.k * q[0] * q[0])]`",
    )
}

pub(crate) fn untyped_argument(pattern: &impl ToTokens) -> Error {
    let name = text(pattern);
    let ty = if name == "q" { "[f64; 2]" } else { "f64" };
    at(pattern, format!("the type of `{name}` must be stated: `{name}: {ty}`"))
}

pub(crate) fn keyword(tokens: &impl ToTokens, keyword: &str) -> Error {
    at(tokens, format!("a law is a plain formula and cannot be `{keyword}`; leave the word away"))
}

pub(crate) fn own_generics(generics: &impl ToTokens) -> Error {
    at(generics, "a potential has no generics of its own; the generated code is generic over the scalar anyway")
}

pub(crate) fn no_receiver(name: &Ident) -> Error {
    at(name, format!("a potential takes the law first: `fn {name}(&self, q: …) -> f64`"))
}

pub(crate) fn mutable_receiver(receiver: &impl ToTokens) -> Error {
    at(receiver, "a potential changes nothing; write `&self`")
}

pub(crate) fn other_receiver(receiver: &impl ToTokens) -> Error {
    at(receiver, "a potential takes the law by reference; write `&self`")
}

pub(crate) fn no_position(whole: &impl ToTokens) -> Error {
    at(
        whole,
        "a potential is a function of the position; give it an argument `q: f64`, `q: [f64; D]` or `q: SVector<f64, D>`",
    )
}

pub(crate) fn named_twice(pattern: &impl ToTokens) -> Error {
    at(pattern, format!("`{}` is named twice", text(pattern)))
}

pub(crate) fn unknown_argument(pattern: &impl ToTokens) -> Error {
    at(
        pattern,
        format!(
            "`{}` is not an argument a potential can have; expected one of: `q` (position), `m` (mass), `t` (time). \
             Parameters are fields of the law: `self.k`",
            text(pattern)
        ),
    )
}

pub(crate) fn velocity_argument(pattern: &impl ToTokens) -> Error {
    at(
        pattern,
        "a potential does not depend on the velocity `v`; expected one of: `q` (position), `m` (mass), `t` (time)",
    )
}

pub(crate) fn position_in_pieces(pattern: &impl ToTokens) -> Error {
    at(
        pattern,
        format!("the position is one argument, `q`; take it to pieces in the body: `let {} = q;`", text(pattern)),
    )
}

pub(crate) fn position_by_reference(ty: &impl ToTokens) -> Error {
    at(ty, format!("the position is taken by value; write `q: {}`", text(ty).trim_start_matches('&')))
}

pub(crate) fn not_a_number(ty: &impl ToTokens, quantity: &str, name: &str) -> Error {
    at(ty, format!("the {quantity} `{name}` is a number; write `{name}: f64`"))
}

pub(crate) fn wrong_position(ty: &impl ToTokens) -> Error {
    at(
        ty,
        format!(
            "`{}` cannot be a position; expected `f64` (one coordinate), `[f64; D]`, or nalgebra's `SVector<f64, D>`, \
             `Vector2<f64>`, `Vector3<f64>`",
            text(ty)
        ),
    )
}

pub(crate) fn single_precision(ty: &impl ToTokens) -> Error {
    at(ty, "write the law in `f64`; the generated code runs it in `f32` and other scalars as well")
}

pub(crate) fn unknown_dimension(ty: &impl ToTokens) -> Error {
    at(
        ty,
        "the number of coordinates must be known when the macro runs; write it as a literal, `[f64; 3]`, or as a constant of \
         this block whose value is a literal, `[f64; Self::D]`",
    )
}

pub(crate) fn no_coordinates(ty: &impl ToTokens) -> Error {
    at(ty, "a position has at least one coordinate")
}

pub(crate) fn too_many_coordinates(ty: &impl ToTokens, count: usize, most: usize) -> Error {
    at(
        ty,
        format!(
            "{count} coordinates are more than can be derived symbolically for one particle (at most {most}); many bodies \
             with a law between them are a scene"
        ),
    )
}

pub(crate) fn returns_nothing(whole: &impl ToTokens) -> Error {
    at(whole, "a potential returns the potential energy; add `-> f64`")
}

pub(crate) fn wrong_return(ty: &impl ToTokens) -> Error {
    at(ty, format!("a potential returns the potential energy, one `f64`, not `{}`", text(ty)))
}
