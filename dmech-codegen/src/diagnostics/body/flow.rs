//! Branches, loops, statements, and code that is no formula.

use quote::ToTokens;
use syn::{Error, Ident, Macro, Token};

use crate::diagnostics::{at, counted, text};

/// The value is missing, or thrown away by a `;` behind it.
pub(crate) fn no_result(name: &Ident, semicolon: Option<&Token![;]>) -> Error {
    match semicolon {
        Some(semicolon) => {
            at!(semicolon, "this `;` throws the value of `{name}` away; remove it, so that the value comes last")
        }
        None => at!(name, "`{name}` has no value; write it as the last expression, without `;` behind it"),
    }
}

/// A force with more or fewer components than the position.
pub(crate) fn wrong_components(e: &impl ToTokens, name: &Ident, found: usize, expected: usize) -> Error {
    at!(e, "this has {}, and `{name}` returns {expected}, one for each coordinate", counted(found, "component"))
}

/// A force whose value is one number, or anything else without components.
pub(crate) fn expected_components(e: &impl ToTokens, name: &Ident, n: usize, is_vector: bool, found: &str) -> Error {
    let form =
        if is_vector { format!("a vector with {}", counted(n, "component")) } else { format!("an array of {n}") };
    at!(e, "`{name}` returns {form}, one component for each coordinate; this is {found}")
}

/// What is said where nothing better is known.
pub(crate) fn not_understood(name: &Ident) -> Error {
    at!(name, "`{name}` cannot be read; write its value as one formula")
}

pub(crate) fn early_return(e: &impl ToTokens) -> Error {
    at(e, "`return` can only be the last statement; for a choice write `if … { a } else { b }`")
}

pub(crate) fn open_loop(token: &impl ToTokens) -> Error {
    at(
        token,
        "how often this loop turns must be known when the macro runs; write `for i in 0..n` with a literal or a constant of \
         this block",
    )
}

pub(crate) fn jump(token: &impl ToTokens, keyword: &str) -> Error {
    at!(token, "a loop always runs to its end, without `{keyword}`; put an `if` around what only some turns do")
}

pub(crate) fn label(label: &impl ToTokens) -> Error {
    at(label, "labels have no use here, since nothing can jump to them; leave it away")
}

pub(crate) fn match_expression(token: &impl ToTokens) -> Error {
    at(token, "`match` cannot be differentiated; write `if … { … } else if … { … } else { … }`")
}

pub(crate) fn if_let(token: &impl ToTokens) -> Error {
    at(
        token,
        "`if let` cannot be differentiated; choose by a comparison, `if x < 0.0 { … } else { … }`, and take arrays to pieces with \
         `let [x, y] = q;`",
    )
}

pub(crate) fn let_else(token: &impl ToTokens) -> Error {
    at(token, "`let … else` has no use in a formula; bind names, arrays and tuples of names")
}

pub(crate) fn no_else(token: &impl ToTokens) -> Error {
    at(token, "an `if` that has a value needs an `else` with the value elsewhere: `else { 0.0 }`")
}

pub(crate) fn branches_differ(e: &impl ToTokens, yes: &str, no: &str) -> Error {
    if yes == no {
        return at!(
            e,
            "which of the branches holds depends on the coordinates, and each is {yes}; only numbers can be chosen by a \
             comparison, `if … {{ 0.0 }} else {{ 1.0 }}`"
        );
    }
    at!(e, "the branches of this `if` must go together; one is {yes}, the other {no}")
}

pub(crate) fn branches_differ_in(token: &impl ToTokens, name: &str) -> Error {
    at!(
        token,
        "after this `if`, `{name}` would be something that depends on the coordinates and is no number; only numbers \
         can be chosen by a comparison"
    )
}

pub(crate) fn conditional_code(cfg: &impl ToTokens) -> Error {
    at(cfg, "whether this holds is not known when the macro runs; write one `impl` block for each case")
}

pub(crate) fn inner_function(name: &Ident) -> Error {
    at!(name, "move `{name}` out of the body, into this `impl` block, and call it as `Self::{name}(…)`")
}

pub(crate) fn inner_item(item: &impl ToTokens) -> Error {
    at(item, "the body of a law is a formula; move this item out of it")
}

pub(crate) fn macro_call(call: &Macro) -> Error {
    let name = text(&call.path);
    let message = match name.as_str() {
        "println" | "print" | "eprintln" | "eprint" | "dbg" => {
            format!("a law prints nothing; `{name}!` belongs in the program that runs it")
        }
        "assert" | "debug_assert" | "assert_eq" | "panic" | "todo" | "unimplemented" | "unreachable" => {
            format!("a law cannot fail; check parameters where the law is made, without `{name}!`")
        }
        "vec" => {
            let elements = text(&call.tokens);
            let is_list = !elements.ends_with('…') && !elements.contains(';');
            let array = if is_list { format!("[{elements}]") } else { "[a, b]".into() };
            format!("how long a `Vec` is, is not known when the macro runs; write an array, `{array}`")
        }
        _ => format!("what `{name}!` expands to cannot be seen here; write the formula out"),
    };
    at(call, message)
}

pub(crate) fn struct_literal(path: &impl ToTokens) -> Error {
    at(path, "structs cannot be built in a formula; use arrays, tuples or nalgebra's vectors")
}

pub(crate) fn mutable_reference(token: &impl ToTokens) -> Error {
    at(token, "a formula hands values on, not places; return the new value instead of taking `&mut`")
}

pub(crate) fn not_a_formula(e: &impl ToTokens, what: &str) -> Error {
    at!(
        e,
        "{what} cannot be differentiated; a law is made of numbers, `let`, arithmetic, `if` on comparisons, constant \
         loops and the functions of `f64`"
    )
}

pub(crate) fn too_deep(e: &impl ToTokens) -> Error {
    at(e, "this is nested too deeply to be read; bind an inner part to a name with `let`")
}

/// Which bound was passed.
#[derive(Clone, Copy)]
pub(crate) enum Excess {
    Turns,
    Expressions,
    Steps,
    Terms,
    /// Of the finished potential.
    Size,
    Height,
    Tower,
    Choices,
}

pub(crate) fn excess(e: &impl ToTokens, excess: Excess) -> Error {
    let message = match excess {
        Excess::Turns => {
            "the loops of this law take more than 10000 turns; a law is unrolled into one formula, keep it small"
        }
        Excess::Expressions => "this law unrolls into more than 100000 expressions; shorten its loops",
        Excess::Steps => {
            "this law calls its helpers and loops too often to be unrolled; bind what is used twice with `let`"
        }
        Excess::Terms => "the sums of this law unroll into too many terms; shorten its loops",
        Excess::Size => {
            "this law unrolls into more than 4000 expressions, too many to be differentiated; shorten its loops"
        }
        Excess::Height | Excess::Tower => {
            "this law applies function to function too many times to be differentiated, probably in a loop"
        }
        Excess::Choices => {
            "too many choices of this law (`if`, `min`, `max`, `abs`) depend on each other to be differentiated; let \
             each `if` add its own term to a sum"
        }
    };
    at(e, message)
}
