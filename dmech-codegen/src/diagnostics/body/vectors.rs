//! nalgebra's vectors.

use quote::ToTokens;
use syn::{Error, Ident};

use crate::diagnostics::{at, counted, nearest, text};

pub(crate) fn unknown_vector_function(name: &Ident) -> Error {
    let known = [
        "norm",
        "norm_squared",
        "dot",
        "cross",
        "normalize",
        "metric_distance",
        "component_mul",
        "component_div",
        "sum",
        "map",
        "iter",
    ];
    if let Some(near) = nearest(&name.to_string(), known) {
        return at!(name, "`{name}` cannot be read; did you mean `{near}`?");
    }
    at!(
        name,
        "`{name}` cannot be read; of a vector a law can use `+ - * /`, `norm`, `norm_squared`, `dot`, `cross`, \
         `normalize`, `metric_distance`, `component_mul`, `component_div`, `sum`, `map`, `iter`, an index and `x`, `y`, `z`"
    )
}

pub(crate) fn no_component(name: &Ident, dimension: usize) -> Error {
    at!(name, "a vector with {} has no component `{name}`", counted(dimension, "component"))
}

pub(crate) fn expected_vector(e: &impl ToTokens, found: &str) -> Error {
    at!(e, "a vector is expected here, this is {found}")
}

pub(crate) fn expected_array(e: &impl ToTokens, found: &str) -> Error {
    at!(e, "an array of as many numbers as the vector has components is expected here, this is {found}")
}

pub(crate) fn dimensions_differ(e: &impl ToTokens, left: usize, right: usize) -> Error {
    at!(e, "this vector has {}, the other {left}", counted(right, "component"))
}

pub(crate) fn cross_product(name: &Ident, dimension: usize) -> Error {
    at!(name, "the cross product needs three components, not {dimension}")
}

pub(crate) fn field_of_unknown_dimension(e: &impl ToTokens) -> Error {
    let field = text(e);
    at!(
        e,
        "how many components `{field}` has cannot be seen from the impl block; bind it with its type: `let c: \
         Vector2<f64> = {field};`"
    )
}

pub(crate) fn unstated_dimension(e: &impl ToTokens) -> Error {
    at(e, "how many components this vector has must be stated: `Vector3::zeros()`, `SVector::<f64, 3>::zeros()`")
}

pub(crate) fn unknown_constructor(name: &Ident, owner: &str) -> Error {
    at!(name, "`{owner}::{name}` cannot be read; make vectors with `new`, `zeros`, `repeat` or `from([…])`")
}
