//! Arrays, ranges, iterators, indices.

use quote::ToTokens;
use syn::{Error, Ident};

use crate::diagnostics::{at, nearest, text};

pub(crate) fn index_not_known(e: &impl ToTokens, found: &str) -> Error {
    at!(e, "an index is a literal, a constant of this block or a loop index; this is {found}")
}

pub(crate) fn index_out_of_range(e: &impl ToTokens, index: i128, length: usize) -> Error {
    let message = match length {
        0 => format!("{index} is out of range"),
        1 => format!("{index} is out of range: there is 1 component, 0"),
        n => format!("{index} is out of range: there are {n} components, 0 to {}", n - 1),
    };
    at(e, message)
}

pub(crate) fn indexed_number(e: &impl ToTokens, base: &impl ToTokens) -> Error {
    let base = text(base);
    at!(e, "`{base}` is one number; write `{base}` without an index, or declare it as an array")
}

pub(crate) fn not_indexable(e: &impl ToTokens, found: &str) -> Error {
    at!(e, "{found} has no components to choose from by an index")
}

pub(crate) fn open_range(e: &impl ToTokens) -> Error {
    at(e, "both ends of a range must be stated: `0..3`")
}

pub(crate) fn range_bound(e: &impl ToTokens, found: &str) -> Error {
    at!(
        e,
        "how far this range goes must be known when the macro runs; write a literal or a constant of this block instead \
         of {found}"
    )
}

/// `(..).contains(&x)`
pub(crate) fn contains_everything(call: &impl ToTokens) -> Error {
    at(call, "a range without ends contains everything; leave the condition away")
}

pub(crate) fn not_iterable(e: &impl ToTokens, found: &str) -> Error {
    at!(e, "a loop runs over a constant range, `0..3`, or over an array; this is {found}")
}

pub(crate) fn field_of_unknown_length(e: &impl ToTokens) -> Error {
    let field = text(e);
    let last = field.rsplit('.').next().filter(|last| last.starts_with(char::is_alphabetic) && !last.contains('['));
    let name = last.unwrap_or("k");
    // No length is invented: one that is too small would leave elements out without a word.
    at!(
        e,
        "how long `{field}` is cannot be seen from the impl block; write `for i in 0..n` with `{field}[i]` and the \
         number of its elements for `n`, or bind it with its type: `let {name}: [f64; n] = {field};`"
    )
}

pub(crate) fn array_is_no_iterator(name: &Ident) -> Error {
    at!(name, "an array is no iterator; write `iter().{name}(…)`")
}

pub(crate) fn iter_mut(name: &Ident, length: usize) -> Error {
    at!(name, "change elements by their index: `for i in 0..{length} {{ a[i] += … }}`")
}

pub(crate) fn integer_terms(e: &impl ToTokens) -> Error {
    at(e, "these terms are integers and numbers are expected here; write them with `as f64`")
}

pub(crate) fn filter(name: &Ident) -> Error {
    at!(
        name,
        "`{name}` would change the number of terms; write the condition into the term: `.map(|i| if … {{ … }} else {{ 0.0 }})`"
    )
}

pub(crate) fn unknown_array_function(name: &Ident) -> Error {
    let known = ["iter", "map", "len", "windows"];
    if let Some(near) = nearest(&name.to_string(), known) {
        return at!(name, "`{name}` cannot be read; did you mean `{near}`?");
    }
    at!(name, "`{name}` cannot be read; of an array a law can use an index, `iter`, `map`, `len` and `windows`")
}

pub(crate) fn vector_function_of_array(name: &Ident, length: usize) -> Error {
    at!(
        name,
        "arrays have no `{name}`; write it out, or take nalgebra's vector as the position: `q: SVector<f64, {length}>`"
    )
}

pub(crate) fn unknown_iterator_function(name: &Ident) -> Error {
    let known =
        ["map", "sum", "product", "fold", "zip", "enumerate", "rev", "chain", "flat_map", "skip", "take", "step_by"];
    if let Some(near) = nearest(&name.to_string(), known) {
        return at!(name, "`{name}` cannot be read; did you mean `{near}`?");
    }
    at!(
        name,
        "`{name}` cannot be read; of an iterator a law can use `map`, `sum`, `product`, `fold`, `zip`, `enumerate`, \
         `rev`, `chain`, `flat_map`, `skip`, `take`, `step_by`, or write a `for` loop"
    )
}

pub(crate) fn from_fn(e: &impl ToTokens) -> Error {
    at(e, "write the array out, `[a, b]`, or map one: `[0, 1, 2].map(|i| …)`")
}
