//! nalgebra's vectors.

use quote::ToTokens;
use syn::{Error, Ident};

use crate::diagnostics::{at, text};

pub(crate) fn unknown_vector_function(name: &Ident) -> Error {
    at(
        name,
        format!(
            "`{name}` cannot be read; of a vector a law can use `+ - * /`, `norm`, `norm_squared`, `dot`, `cross`, \
             `normalize`, `metric_distance`, `component_mul`, `component_div`, `sum`, `map`, `iter`, an index and `x`, `y`, `z`"
        ),
    )
}

pub(crate) fn no_component(name: &Ident, dimension: usize) -> Error {
    at(name, format!("a vector with {dimension} components has no component `{name}`"))
}

pub(crate) fn expected_vector(e: &impl ToTokens, found: &str) -> Error {
    at(e, format!("a vector is expected here, this is {found}"))
}

pub(crate) fn expected_array(e: &impl ToTokens, found: &str) -> Error {
    at(e, format!("an array of as many numbers as the vector has components is expected here, this is {found}"))
}

pub(crate) fn dimensions_differ(e: &impl ToTokens, left: usize, right: usize) -> Error {
    at(e, format!("this vector has {right} components, the other {left}"))
}

pub(crate) fn cross_product(name: &Ident, dimension: usize) -> Error {
    at(name, format!("the cross product needs three components, not {dimension}"))
}

pub(crate) fn field_of_unknown_dimension(e: &impl ToTokens) -> Error {
    let field = text(e);
    at(
        e,
        format!(
            "how many components `{field}` has cannot be seen from the impl block; bind it with its type: `let c: Vector2<f64> \
             = {field};`"
        ),
    )
}

pub(crate) fn unstated_dimension(e: &impl ToTokens) -> Error {
    at(e, "how many components this vector has must be stated: `Vector3::zeros()`, `SVector::<f64, 3>::zeros()`")
}

pub(crate) fn unknown_constructor(name: &Ident, owner: &str) -> Error {
    at(name, format!("`{owner}::{name}` cannot be read; make vectors with `new`, `zeros`, `repeat` or `from([…])`"))
}
