//! Helpers of the block, functions from elsewhere, closures.

use quote::ToTokens;
use syn::{Error, ExprPath, Ident};

use crate::diagnostics::{at, text};

pub(crate) fn unknown_helper(name: &Ident, law: &str, near: Option<&str>) -> Error {
    if let Some(near) = near {
        return at!(name, "`{name}` is not a method of this block; did you mean `{near}`?");
    }
    at!(
        name,
        "`{name}` is not a method of this block; a helper must stand beside the potential, in the same `impl {law}`, to \
         be differentiated with it"
    )
}

pub(crate) fn conditional_sibling(name: &Ident) -> Error {
    at!(
        name,
        "which `{name}` is meant is not known when the macro runs: it is declared twice or under `#[cfg]`; declare it once"
    )
}

pub(crate) fn recursion(name: &Ident) -> Error {
    at!(name, "`{name}` calls itself; a formula has no recursion, write a `for` loop over a constant range")
}

pub(crate) fn unfit_helper(name: &Ident) -> Error {
    at!(name, "`{name}` is `async` or `unsafe`; a helper is a plain `fn`")
}

pub(crate) fn changing_helper(name: &Ident) -> Error {
    at!(name, "`{name}` takes `&mut self`; a law changes nothing, let the helper take `&self`")
}

pub(crate) fn helper_receiver(name: &Ident, takes_law: bool) -> Error {
    if takes_law {
        at!(name, "`{name}` takes `&self`; call it as `self.{name}(…)`")
    } else {
        at!(name, "`{name}` takes no `&self`; call it as `Self::{name}(…)`")
    }
}

/// A function that is no helper, called with so many arguments; the arity is that of a method of numbers, by its name.
pub(crate) fn foreign_function(
    path: &ExprPath,
    is_helper: bool,
    given: usize,
    arity: fn(&str) -> Option<usize>,
) -> Error {
    // Without what stands between `::<` and `>`.
    let names: Vec<_> = path.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
    let name = names.join("::");
    let (last, owners) = names.split_last().map_or(("", &[][..]), |(last, owners)| (last.as_str(), owners));
    if is_helper {
        return at!(path, "`{last}` is a helper of this block; call it as `self.{last}(…)` or `Self::{last}(…)`");
    }
    let is_type = |name: &str| name.starts_with(char::is_uppercase);
    let makes =
        is_type(last) || (matches!(last, "new" | "default" | "from") && owners.last().is_some_and(|o| is_type(o)));
    let is_elsewhere = owners.first().is_some_and(|first| !matches!(first.as_str(), "crate" | "self" | "super"));
    let instead = match method(last, arity) {
        Some(method) => format!("functions of numbers are methods: {method}"),
        None if makes => "a law is made of numbers, and this makes something else".to_owned(),
        None if is_elsewhere && given == 0 => {
            "a law is the same each time that it is evaluated; call this before the run, and keep its number in a field \
             of the law"
                .to_owned()
        }
        None if is_elsewhere => {
            "write its formula as a helper in this `impl` block, or, where it has none, the law by hand (see “A law by \
             hand” in the guide)"
                .to_owned()
        }
        None => format!("write it as a helper in this `impl` block and call it as `Self::{last}(…)`"),
    };
    at!(path, "what `{name}` computes cannot be seen here; {instead}")
}

/// What other languages write as a function, as Rust has it.
fn method(name: &str, arity: fn(&str) -> Option<usize>) -> Option<String> {
    let alike = match name {
        "pow" | "power" => return Some("`x.powi(2)`, `x.powf(1.5)`".to_owned()),
        "log" => "ln",
        "fabs" | "absolute" => "abs",
        "sign" => "signum",
        "arcsin" => "asin",
        "arccos" => "acos",
        "arctan" => "atan",
        "arctan2" => "atan2",
        "fmin" | "minimum" => "min",
        "fmax" | "maximum" => "max",
        name => name,
    };
    let lower = alike.to_lowercase();
    let alike = if arity(alike).is_some() { alike } else { lower.as_str() };
    Some(match arity(alike)? {
        0 => format!("`x.{alike}()`"),
        1 => format!("`x.{alike}(y)`"),
        _ => format!("`x.{alike}(y, z)`"),
    })
}

pub(crate) fn no_argument(name: &Ident) -> Error {
    at!(name, "`f64::{name}` is given nothing to work on; write `x.{name}()` or `f64::{name}(x)`")
}

pub(crate) fn not_a_function(e: &impl ToTokens) -> Error {
    at(e, "only helpers of this block and functions of `f64` can be called; write `Self::helper(…)`")
}

pub(crate) fn stray_closure(e: &impl ToTokens) -> Error {
    at(e, "closures can only be handed to `map`, `flat_map` and `fold`; write a helper in this `impl` block")
}

pub(crate) fn not_a_closure(e: &impl ToTokens) -> Error {
    at(e, "a closure is expected here, `|x| …`, or a function by its path: `f64::sqrt`, `Self::helper`")
}

pub(crate) fn closure_arguments(e: &impl ToTokens, takes: usize, given: usize) -> Error {
    at!(e, "this closure takes {takes} arguments and is given {given}")
}

pub(crate) fn no_method(name: &Ident, found: &str) -> Error {
    at!(name, "{found} has no method `{name}` that a law can use")
}

/// A method of a field, whose type the macro does not know: another law, as a rule.
pub(crate) fn method_of_field(name: &Ident, field: &impl ToTokens) -> Error {
    const OF_LAWS: [&str; 5] = ["potential", "energy", "gradient", "force", "acceleration"];
    const OF_OTHERS: [&str; 9] =
        ["unwrap", "unwrap_or", "unwrap_or_default", "unwrap_or_else", "map_or", "is_some", "get", "into", "as_ref"];
    let (called, field) = (name.to_string(), text(field));
    let instead = if OF_LAWS.contains(&called.as_str()) {
        "write its formula as a helper `fn` of this block, or give a scene both laws: `.field(one).field(other)`".into()
    } else if OF_OTHERS.contains(&called.as_str()) {
        "a field that a law reads is an `f64`, an array of them, or has such fields; put the number there beforehand"
            .into()
    } else {
        format!("read the fields themselves (`{field}.k`), or write its formula as a helper `fn` of this block")
    };
    at!(name, "`{called}` is a method of `{field}`, which the macro cannot see; {instead}")
}
