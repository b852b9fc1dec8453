//! Numbers, integers, conditions, functions.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Error, Expr};

use crate::diagnostics::{at, counted, nearest, text};

/// `2` where `2.0` is meant, or a variable that holds an integer.
pub(crate) fn integer(e: &dyn ToTokens) -> Error {
    let e = e.to_token_stream();
    let written = text(&e);
    let digits = written.replace(' ', "");
    let bare = digits.trim_start_matches('-');
    if !bare.is_empty() && bare.chars().all(|c| c.is_ascii_digit() || c == '_') {
        at!(&e, "`{digits}` is an integer and a number is expected here; write `{digits}.0`")
    } else if bare.starts_with(|c: char| c.is_ascii_digit()) && !bare.contains(|c: char| !c.is_ascii_alphanumeric()) {
        at!(&e, "`{digits}` is an integer and a number is expected here; write it with a decimal point")
    } else if written.chars().all(|c| c.is_alphanumeric() || c == '_') {
        at!(
            &e,
            "`{written}` is an integer and a number is expected here; write `{written} as f64`, or give it a value with \
             a decimal point"
        )
    } else if written.contains(" / ") {
        at!(
            &e,
            "`{written}` divides integers, which drops what is left over, and a number is expected here; write its \
             numbers with decimal points"
        )
    } else if written.contains(' ') {
        at!(&e, "`{written}` is an integer and a number is expected here; write `({written}) as f64`")
    } else {
        at!(&e, "`{written}` is an integer and a number is expected here; write `{written} as f64`")
    }
}

pub(crate) fn expected_number(e: &dyn ToTokens, found: &str) -> Error {
    let e = e.to_token_stream();
    let hint = reduction(&e, found).map(|hint| format!("; write {hint}")).unwrap_or_default();
    at!(&e, "a number is expected here, this is {found}{hint}")
}

/// How one number is made of several.
fn reduction(e: &impl ToTokens, found: &str) -> Option<String> {
    let whole = text(e);
    let whole = if whole.contains([' ', '…']) { "x".into() } else { whole };
    if found.starts_with("a vector") {
        Some(format!("a component, `{whole}.x`, or the length, `{whole}.norm()`"))
    } else {
        found.starts_with("an array").then(|| format!("a component, `{whole}[0]`"))
    }
}

pub(crate) fn expected_integer(e: &dyn ToTokens, found: &str) -> Error {
    at!(
        &e.to_token_stream(),
        "an integer that is known when the macro runs is expected here (a literal, a constant of this block, a loop index); this is {found}"
    )
}

pub(crate) fn expected_condition(e: &impl ToTokens, found: &str) -> Error {
    at!(e, "a condition is expected here, this is {found}; compare it with something: `x < 0.0`")
}

pub(crate) fn assignment_as_condition(e: &impl ToTokens) -> Error {
    at(e, "`=` gives a value to a variable; compare with `==`")
}

pub(crate) fn field_as_condition(e: &impl ToTokens) -> Error {
    at!(
        e,
        "`{}` is used as a condition, and the parameters of a law are numbers; keep it as an `f64` and compare it: `if \
         {} > 0.0`",
        text(e),
        text(e)
    )
}

pub(crate) fn field_and_variant(e: &impl ToTokens, field: &impl ToTokens, variant: &impl ToTokens) -> Error {
    let (field, variant) = (text(field), text(variant));
    at!(
        e,
        "`{field}` is compared with `{variant}`, and the parameters of a law are numbers; keep it as an `f64` and \
         compare that: `if {field} > 0.0`"
    )
}

pub(crate) fn compared_conditions(e: &impl ToTokens) -> Error {
    at(e, "conditions on the coordinates cannot be compared with each other; join them with `&&`, `||` and `!`")
}

pub(crate) fn condition_too_large(e: &impl ToTokens) -> Error {
    at(e, "this condition joins too many comparisons to be differentiated; split the law")
}

pub(crate) fn number_too_large(e: &impl ToTokens) -> Error {
    at(e, "this number is out of range")
}

pub(crate) fn not_a_number(e: &impl ToTokens, what: &str) -> Error {
    at!(e, "a law is made of numbers, and this is {what}; leave it away")
}

pub(crate) fn single_precision_literal(e: &impl ToTokens) -> Error {
    at(e, "write the number without a suffix; the generated code runs in `f32` and other scalars as well")
}

pub(crate) fn single_precision(ty: &impl ToTokens) -> Error {
    at(ty, "write `f64`; the generated code runs in `f32` and other scalars as well")
}

pub(crate) fn integer_overflow(e: &impl ToTokens) -> Error {
    at(e, "this integer has no value: it is out of range, or divides by zero")
}

pub(crate) fn division_by_zero(e: &impl ToTokens) -> Error {
    at(e, "this divides by zero")
}

pub(crate) fn remainder(e: &impl ToTokens) -> Error {
    at(
        e,
        "the sign of a remainder is that of what is divided; write `x.rem_euclid(l)`, or `x - l * (x / l).round()` for the nearest image",
    )
}

pub(crate) fn bit_operator(op: &impl ToTokens) -> Error {
    let instead = match text(op).as_str() {
        "^" => "a power is `x.powi(2)` or `x.powf(1.5)`",
        _ => "conditions are joined with `&&`, `||` and `!`",
    };
    at!(op, "`{}` works on bits, not on numbers; {instead}", text(op))
}

/// `x ** 2`, which Rust reads as `x * (*2)`.
pub(crate) fn stars(e: &impl ToTokens) -> Error {
    at(e, "`**` is not an operator of Rust; a power is `x.powi(2)` or `x.powf(1.5)`")
}

/// `left ∘ right` where there is no such operation.
pub(crate) fn no_such_operation(
    e: &syn::Expr,
    sign: &str,
    left: (&syn::Expr, &str),
    right: (&syn::Expr, &str),
) -> Error {
    let ((left_at, left), (right_at, right)) = (left, right);
    let is_vector = |found: &str| found.starts_with("a vector");
    let with_array = [left, right].iter().any(|side| side.starts_with("an array"));
    let several = if is_vector(left) { (left_at, left) } else { (right_at, right) };
    let hint = match (with_array, is_vector(left) && is_vector(right)) {
        (true, _) => "; arrays have no arithmetic, write it for each component or use nalgebra's vectors".into(),
        (_, true) if left == right => "; write `dot`, `cross` or `component_mul`".into(),
        (_, true) => String::new(),
        _ => reduction(several.0, several.1).map(|hint| format!("; write {hint}")).unwrap_or_default(),
    };
    at!(e, "`{sign}` is not defined between {left} and {right}{hint}")
}

pub(crate) fn cast_to_integer(e: &impl ToTokens) -> Error {
    at(e, "an integer has no derivative; keep the number as `f64`: `floor`, `round` and `trunc` are functions of it")
}

/// `self.n as i32`, which is no number that the macro could unroll by.
pub(crate) fn field_as_integer(e: &impl ToTokens, field: &impl ToTokens, found: &str) -> Error {
    let field = text(field);
    at!(
        e,
        "an integer is known when the macro runs, and `{field}` is {found}; keep it a number: a power by it is `powf({field})`"
    )
}

pub(crate) fn cast(e: &impl ToTokens, found: &str) -> Error {
    at!(e, "only integers and numbers can be cast, to `f64` or to an integer type; this is {found}")
}

/// The functions of numbers that a law can use.
const FUNCTIONS: &str = "sqrt cbrt powi powf exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan sin_cos asin acos atan atan2 \
                         sinh cosh tanh asinh acosh atanh hypot abs recip mul_add min max clamp signum round floor ceil trunc fract rem_euclid";

/// A method that numbers do not have, or that has no derivative; the field of the law that it is called on, if it is one.
pub(crate) fn unknown_function(name: &Ident, field: Option<&Expr>) -> Error {
    let text = name.to_string();
    let message = match text.as_str() {
        "round_ties_even" => "write `round`: the two differ at halves alone, where a law must be continuous".into(),
        "div_euclid" => "write `(x / l).floor()` instead of `div_euclid`".into(),
        "pow" => "numbers have `powi` for integer exponents and `powf` for others: `x.powi(2)`, `x.powf(1.5)`".into(),
        "square" | "squared" | "sq" => format!("`{text}` is not a function of `f64`; write `powi(2)` or `x * x`"),
        "copysign" => "a law has no `copysign`: for `x.copysign(y)` write `x.abs() * y.signum()`".into(),
        "to_bits" | "from_bits" | "is_nan" | "is_finite" | "is_infinite" | "is_sign_negative" | "is_sign_positive"
        | "total_cmp" | "partial_cmp" => {
            format!("`{text}` looks at how a number is stored; a law compares numbers: `x < 0.0`")
        }
        "norm" | "dot" | "cross" => {
            format!(
                "numbers have no `{text}`; write `abs`, or take nalgebra's vector as the position: `q: SVector<f64, 2>`"
            )
        }
        _ => match (nearest(&text, FUNCTIONS.split(' ')), field) {
            (Some(near), _) => format!("`{text}` is not a function of numbers; did you mean `{near}`?"),
            (None, Some(field)) => return super::method_of_field(name, field),
            (None, None) => format!("`{text}` is not among the functions that can be differentiated: {FUNCTIONS}"),
        },
    };
    at(name, message)
}

pub(crate) fn wrong_arguments(name: &Ident, expected: usize, given: usize) -> Error {
    at!(name, "`{name}` takes {} here, not {given}", counted(expected, "argument"))
}

pub(crate) fn power_exponent(e: &impl ToTokens, found: &str) -> Error {
    at!(
        e,
        "the exponent of `powi` is an integer that is known when the macro runs, this is {found}; for any other \
         exponent write `powf`"
    )
}

/// An exponent with a field in it, which may stand in a cast alone.
pub(crate) fn power_by_field(e: &impl ToTokens, field: &impl ToTokens, found: &str, is_cast: bool) -> Error {
    let field = text(field);
    let instead =
        if is_cast { format!("`powf({field})`") } else { format!("`powf`, and `{field} as f64` for `{field}`") };
    at!(
        e,
        "the exponent of `powi` is an integer that is known when the macro runs, and `{field}` is {found}; write {instead}"
    )
}

pub(crate) fn integer_exponent(e: &impl ToTokens) -> Error {
    let e_text = text(e);
    at!(e, "`powf` takes a number; write `powi({e_text})`, or the exponent with a decimal point")
}

pub(crate) fn exponent_too_large(e: &impl ToTokens, most: i32) -> Error {
    at!(e, "this power is larger than {most}, beyond any use in a law")
}

pub(crate) fn not_finite(e: &impl ToTokens, name: &str) -> Error {
    at!(e, "a law is finite; `{name}` has no place in it")
}

pub(crate) fn clamped_the_wrong_way(e: &impl ToTokens, low: f64, high: f64) -> Error {
    at!(
        e,
        "nothing lies between {low} and {high}, and Rust's `clamp` panics there; the lower bound comes first: \
         `x.clamp({:?}, {:?})`",
        low.min(high),
        low.max(high)
    )
}
