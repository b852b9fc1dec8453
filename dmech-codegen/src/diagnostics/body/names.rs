//! Variables, constants, fields, patterns, places.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Error, Type};

use crate::diagnostics::{at, counted, nearest, text};
use crate::role::{Kind, KnownArgument};

pub(crate) fn unknown_name(name: &Ident, place: Option<&str>, near: Option<&str>) -> Error {
    if let Some(near) = near {
        return at!(name, "`{name}` is not known here; did you mean `{near}`?");
    }
    let declared = place.map_or_else(String::new, |place| format!("; declared coordinates: `{place}`"));
    let hint = if looks_constant(name) {
        format!("A constant belongs in this block, `const {name}: f64 = …;`, and is called `Self::{name}`")
    } else {
        format!("A parameter is a field of the law: `self.{name}`")
    };
    at!(name, "`{name}` is neither a coordinate nor a parameter{declared}. {hint}")
}

pub(crate) fn unknown_in_helper(name: &Ident, near: Option<&str>) -> Error {
    if let Some(near) = near {
        return at!(name, "`{name}` is not known in this helper; did you mean `{near}`?");
    }
    let hint = if looks_constant(name) {
        format!("A constant belongs in this block, `const {name}: f64 = …;`, and is called `Self::{name}`")
    } else {
        format!("Give it to the helper as an argument, or read a field of the law: `self.{name}`")
    };
    at!(name, "`{name}` is not known in this helper. {hint}")
}

fn looks_constant(name: &Ident) -> bool {
    name.to_string().chars().all(|c| c.is_uppercase() || c.is_ascii_digit() || c == '_')
}

/// With the number of coordinates and the type of a body's data, where they are known.
pub(crate) fn undeclared_argument(
    name: &Ident,
    known: &KnownArgument,
    of: &Ident,
    dimension: usize,
    data: Option<&Type>,
) -> Error {
    let ty = match known.kind {
        Kind::Vector if dimension == 0 => "[f64; D]".into(),
        Kind::Vector if dimension > 1 => format!("[f64; {dimension}]"),
        Kind::Data => match data {
            Some(data) => format!("&{}", text(data)),
            None => "&P".into(),
        },
        Kind::Vector | Kind::Number => "f64".into(),
    };
    at!(
        name,
        "`{name}` is not declared; for the {}, add `{name}: {ty}` to the arguments of `{of}`, for a parameter of the \
         law write `self.{name}`",
        known.meaning
    )
}

pub(crate) fn const_parameter(name: &Ident) -> Error {
    at!(
        name,
        "the value of the const parameter `{name}` is not known when the macro runs; state the law for one value, with \
         a constant of the block: `const {name}: usize = 3;` and `Self::{name}`"
    )
}

pub(crate) fn imported_constant(name: &Ident) -> Error {
    at!(name, "what `{name}` was imported as cannot be seen here; write `std::f64::consts::{name}`")
}

pub(crate) fn foreign_constant(e: &impl ToTokens, path: &str) -> Error {
    let name = path.rsplit("::").next().unwrap_or(path);
    at!(
        e,
        "the value of `{path}` cannot be seen here; take it into this block, `const {name}: f64 = {path};`, and write \
         `Self::{name}`"
    )
}

pub(crate) fn function_as_value(e: &impl ToTokens, function: &str) -> Error {
    at!(
        e,
        "`{function}` is a function, and variables of a law are numbers; call it where its value is wanted: `x.{function}(…)`"
    )
}

pub(crate) fn foreign_integer(e: &impl ToTokens, path: &str) -> Error {
    at!(e, "the value of `{path}` cannot be seen here; write the number itself")
}

pub(crate) fn unknown_constant(name: &Ident, law: &str, near: Option<&str>) -> Error {
    if let Some(near) = near {
        return at!(name, "`{name}` is not a constant of this block; did you mean `Self::{near}`?");
    }
    at!(
        name,
        "`{name}` is not a constant of this block; declare it beside the potential: `impl {law} {{ const {name}: f64 = …; }}`"
    )
}

pub(crate) fn unset_variable(name: &Ident) -> Error {
    at!(name, "`{name}` has no value yet, at least not in every branch before this; give it one where it is declared")
}

pub(crate) fn unknown_field(member: &impl ToTokens, declared: &[&str]) -> Error {
    let name = text(member);
    let hint = match nearest(&name, declared.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None if declared.is_empty() => "it has none".into(),
        None => format!("declared: `{}`", declared.join("`, `")),
    };
    at!(member, "`{name}` is not a parameter of this law; {hint}")
}

pub(crate) fn no_field(member: &impl ToTokens, base: &impl ToTokens, found: &str) -> Error {
    let hint =
        if found.starts_with("an array") { format!("; write an index, `{}[0]`", text(base)) } else { String::new() };
    at!(member, "{found} has no part `{}`{hint}", text(member))
}

pub(crate) fn field_of_unknown_type(e: &impl ToTokens) -> Error {
    at(
        e,
        "whether this is an array cannot be seen from the impl block; state its type where it is bound: `let mut k: [f64; 3] \
         = self.k;`",
    )
}

pub(crate) fn pattern(pattern: &impl ToTokens) -> Error {
    at(
        pattern,
        "this pattern cannot be read; bind names, arrays and tuples of names: `let [x, y] = q;`, `let (s, c) = x.sin_cos();`",
    )
}

pub(crate) fn pattern_mismatch(pattern: &impl ToTokens, found: &str, is_vector: bool) -> Error {
    let hint = if is_vector { "; take its components: `let (x, y) = (q.x, q.y);`" } else { "" };
    at!(pattern, "this pattern does not fit {found}{hint}")
}

pub(crate) fn wrong_count(pattern: &impl ToTokens, names: usize, values: usize) -> Error {
    at!(pattern, "this pattern has {} and the value has {values}", counted(names, "part"))
}

pub(crate) fn not_a_place(e: &impl ToTokens) -> Error {
    at(e, "only a variable declared with `let mut`, or an element of one, can be assigned to")
}

pub(crate) fn assignment_mismatch(e: &impl ToTokens, found: &str) -> Error {
    at!(e, "this cannot be assigned from {found}")
}
