//! About the law: where the attribute stands, what the potential takes and returns.

use proc_macro2::{Ident, Span};
use quote::ToTokens;
use syn::{Error, Item, Pat, Signature};

use crate::role::Role;

use super::{at, counted, text};

pub(crate) fn unreadable_option(span: Span) -> Error {
    Error::new(span, "this is no option of the macro; the only one is `crate = path::to::dmech`")
}

pub(crate) fn unknown_option(option: &Ident) -> Error {
    at!(option, "`{option}` is no option of the macro; the only one is `crate = path::to::dmech`")
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

/// Beside what the compiler has said of it already, which macros cannot know.
pub(crate) fn syntax(error: &Error) -> Error {
    Error::new(error.span(), format!("a law is not read before its syntax is right: {error}"))
}

pub(crate) fn not_an_impl(item: &Item) -> Error {
    let (what, name): (_, &dyn ToTokens) = match item {
        Item::Struct(item) => {
            return at!(
                &item.ident,
                "`#[dmech::law]` goes on the `impl` block of the law: `impl {} {{ #[potential] fn energy(&self, q: [f64; \
                 2]) -> f64 {{ … }} }}`; on the struct itself write `#[derive(dmech::Law)]` and \
                 `#[potential(|q: [f64; 2]| …)]`",
                item.ident
            );
        }
        Item::Fn(item) => ("function", &item.sig.ident),
        Item::Enum(item) => ("enum", &item.ident),
        Item::Union(item) => ("union", &item.ident),
        Item::Trait(item) => ("trait", &item.ident),
        Item::Mod(item) => ("module", &item.ident),
        other => ("item", other),
    };
    at!(
        &name.to_token_stream(),
        "`#[dmech::law]` cannot stand on this {what}: it goes on an inherent `impl` block, `impl Kepler {{ #[potential] \
         fn energy(&self, q: [f64; 2]) -> f64 {{ … }} }}`"
    )
}

pub(crate) fn not_a_struct(item: &Item) -> Error {
    let (what, name): (_, &dyn ToTokens) = match item {
        Item::Enum(item) => ("an enum", &item.ident),
        Item::Union(item) => ("a union", &item.ident),
        other => ("this item", other),
    };
    at!(
        &name.to_token_stream(),
        "a law is a struct whose fields are its parameters; `dmech::Law` cannot be derived for {what}"
    )
}

pub(crate) fn trait_impl(path: &impl ToTokens, law: &impl ToTokens) -> Error {
    at!(
        path,
        "`#[dmech::law]` goes on an inherent block, `impl {} {{ … }}`, not on the implementation of a trait; the traits \
         of mechanics are implemented by the macro",
        text(law)
    )
}

pub(crate) fn unnamed_type(ty: &impl ToTokens) -> Error {
    at(ty, "a law is stated for a type with a name: `impl Kepler { … }`")
}

pub(crate) fn no_role(ty: &impl ToTokens) -> Error {
    let name = text(ty);
    at!(
        ty,
        "no method of this block says what acts; mark the one that returns the energy of `{name}` with `#[potential]` \
         (of one body) or `#[pair]` (of two), or the one that returns its force with `#[force]` or `#[pair_force]`"
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

pub(crate) fn two_roles(attribute: &impl ToTokens, first: Role, second: Role) -> Error {
    at!(
        attribute,
        "this method is a {} already, and a method has one role; state the {} in a method of its own",
        first.noun(),
        second.noun()
    )
}

pub(crate) fn misspelt_role(attribute: &syn::Attribute, meant: Role) -> Error {
    at!(attribute.path(), "`{}` is no role of a method; write `#[{}]`", text(attribute.path()), meant.name())
}

pub(crate) fn other_dimension(name: &Ident, own: usize, other: usize) -> Error {
    at!(name, "`{name}` has {}, and the potential of this law has {other}", counted(own, "coordinate"))
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
    at!(ty, "`{}` cannot be a force; it is written like the position: `f64`, `[f64; D]` or `SVector<f64, D>`", text(ty))
}

pub(crate) fn force_of_other_dimension(ty: &impl ToTokens, own: usize, other: usize) -> Error {
    at!(
        ty,
        "this has {}, and what is named before it has {other}; position, velocity and force have equally many",
        counted(own, "component")
    )
}

pub(crate) fn second_of_its_role(second: &Ident, first: &Ident, role: Role) -> Error {
    at!(
        second,
        "`{second}` is a second {}, and a law has one; `{first}` is marked already. Add the two in one method, with the \
         other as a helper",
        role.noun()
    )
}

pub(crate) fn too_many_invariants(beyond: &Ident, most: usize) -> Error {
    at!(beyond, "a run watches {most} invariants of a law, and `{beyond}` is one more; leave one away")
}

pub(crate) fn second_closure(attribute: &impl ToTokens) -> Error {
    at(attribute, "a second potential, and a law has one; add the two in one closure")
}

pub(crate) fn no_closure(name: &Ident) -> Error {
    at!(name, "the potential of `{name}` is not stated; write `#[potential(|q: [f64; 2]| …)]` below the derive")
}

pub(crate) fn role_on_a_struct(attribute: &syn::Attribute, name: &Ident, role: Role) -> Error {
    let (role, takes) = (role.name(), role.example());
    at!(
        attribute.path(),
        "the derive knows a `#[potential]` and nothing else; write the methods of the law in a block instead of the \
         derive: `#[dmech::law] impl {name} {{ #[{role}] fn {takes} {{ … }} }}`"
    )
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
    at!(pattern, "the type of `{name}` must be stated: `{name}: {ty}`")
}

pub(crate) fn keyword(tokens: &impl ToTokens, keyword: &str) -> Error {
    at!(tokens, "a law is a plain formula and cannot be `{keyword}`; leave the word away")
}

pub(crate) fn own_generics(generics: &impl ToTokens, role: Role) -> Error {
    let role = role.noun();
    at!(generics, "a {role} has no generics of its own; the generated code is generic over the scalar anyway")
}

pub(crate) fn no_receiver(signature: &Signature, role: Role) -> Error {
    let (name, inputs, output) = (&signature.ident, text(&signature.inputs), text(&signature.output));
    let inputs = if inputs.is_empty() { inputs } else { format!(", {inputs}") };
    let output = if output.is_empty() { output } else { format!(" {output}") };
    at!(name, "a {} takes the law first: `fn {name}(&self{inputs}){output}`", role.noun())
}

pub(crate) fn mutable_receiver(receiver: &impl ToTokens, role: Role) -> Error {
    at!(receiver, "a {} changes nothing; write `&self`", role.noun())
}

pub(crate) fn other_receiver(receiver: &impl ToTokens, role: Role) -> Error {
    at!(receiver, "a {} takes the law by reference; write `&self`", role.noun())
}

pub(crate) fn no_position(whole: &impl ToTokens) -> Error {
    at(
        whole,
        "a potential is a function of the position; give it an argument `q: f64`, `q: [f64; D]` or `q: SVector<f64, D>`",
    )
}

pub(crate) fn no_argument_of_invariant(whole: &impl ToTokens) -> Error {
    at(
        whole,
        "a conserved quantity is a function of position and velocity; give it an argument `q: [f64; D]`, `v: [f64; D]` \
         or both",
    )
}

pub(crate) fn named_twice(pattern: &impl ToTokens) -> Error {
    at!(pattern, "`{}` is named twice", text(pattern))
}

pub(crate) fn unknown_argument(pattern: &impl ToTokens, role: Role) -> Error {
    let name = text(pattern);
    // `mass` is meant to be `m`, or `ma` of `ma` and `mb`.
    let meant = role.arguments().iter().find(|known| known.meaning.split(' ').next() == Some(&name));
    let hint = match meant {
        Some(known) => format!("the {} is called `{}`", known.meaning, known.name),
        None => format!("expected one of: {}. Parameters are fields of the law: `self.k`", arguments(role)),
    };
    at!(pattern, "`{name}` is not an argument a {} can have; {hint}", role.noun())
}

/// `q` (position), `m` (mass)
fn arguments(role: Role) -> String {
    let known: Vec<_> = role.arguments().iter().map(|known| format!("`{}` ({})", known.name, known.meaning)).collect();
    known.join(", ")
}

/// About a name that this role does not know and another one does, if there is more to say than that.
pub(crate) fn argument_of_another_role(name: &Ident, role: Role) -> Option<Error> {
    let is = |names: &[&str]| names.iter().any(|known| name == known);
    if role.is_of_two() && is(&["q", "v", "m"]) {
        Some(super::pair::argument_of_one_body(name, role))
    } else if role == Role::Invariant && is(&["m", "mass"]) {
        Some(mass_of_an_invariant(name))
    } else if role == Role::PairForce && is(&["r"]) {
        Some(super::pair::distance_of_a_force(name))
    } else if role.force().knows(&name.to_string()) && !role.is_force() && role != Role::Invariant {
        Some(velocity_of_a_potential(name, role))
    } else {
        None
    }
}

fn mass_of_an_invariant(name: &Ident) -> Error {
    at!(
        name,
        "`{name}` is not known to a conserved quantity, which is a function of `q`, `v` and `t`; make the mass a field \
         of the law, `self.{name}`, or state the quantity per unit of mass"
    )
}

fn velocity_of_a_potential(name: &Ident, role: Role) -> Error {
    let (noun, force) = (role.noun(), role.force().name());
    at!(name, "a {noun} does not depend on the velocity `{name}`; what depends on it is a `#[{force}]`")
}

pub(crate) fn coordinates_apart(coordinates: &[&Pat], role: Role) -> Error {
    at(&quote::quote!(#(#coordinates),*), one_array(coordinates.iter().map(text).collect(), role))
}

/// What to write in place of so many coordinates.
fn one_array(names: Vec<String>, role: Role) -> String {
    let (place, what, n) = (role.place().name, role.place().meaning, names.len());
    let names = names.join(", ");
    format!(
        "the {what} is one argument, `{place}: [f64; {n}]`; take it to pieces in the body: `let [{names}] = {place};`"
    )
}

pub(crate) fn place_in_pieces(pattern: &Pat, role: Role) -> Error {
    // There are no tuples of coordinates: what is taken to pieces is an array.
    if let Pat::Tuple(tuple) = pattern {
        return at(pattern, one_array(tuple.elems.iter().map(text).collect(), role));
    }
    let (place, what) = (role.place().name, role.place().meaning);
    at!(
        pattern,
        "the {what} is one argument, `{place}`; take it to pieces in the body: `let {} = {place};`",
        text(pattern)
    )
}

pub(crate) fn position_by_reference(ty: &impl ToTokens) -> Error {
    at!(ty, "the position is taken by value; write `q: {}`", text(ty).trim_start_matches('&'))
}

pub(crate) fn not_a_number(ty: &impl ToTokens, quantity: &str, name: &str) -> Error {
    at!(ty, "the {quantity} `{name}` is a number; write `{name}: f64`")
}

pub(crate) fn wrong_position(ty: &impl ToTokens) -> Error {
    at!(
        ty,
        "`{}` cannot be a position; expected `f64` (one coordinate), `[f64; D]`, or nalgebra's `SVector<f64, D>`, \
         `Vector2<f64>`, `Vector3<f64>`",
        text(ty)
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
    at!(
        ty,
        "{count} coordinates are more than can be derived symbolically for one particle (at most {most}); many bodies \
         with a law between them are a scene"
    )
}

pub(crate) fn returns_nothing(whole: &impl ToTokens) -> Error {
    at(whole, "a potential returns the potential energy; add `-> f64`")
}

pub(crate) fn wrong_invariant(at_this: &impl ToTokens) -> Error {
    at(at_this, "a conserved quantity is one number: the method returns `f64`")
}

pub(crate) fn wrong_return(ty: &impl ToTokens) -> Error {
    at!(ty, "a potential returns the potential energy, one `f64`, not `{}`", text(ty))
}
