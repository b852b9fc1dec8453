//! One mistake is one message, in the one method that it is in, with the name that was probably meant.

use proc_macro2::TokenStream;

use super::{assert_refused, body, lower_text, said};
use crate::model::from_impl;

/// A law of two coordinates whose body is refused at the marks.
fn refused(text: &str, messages: &[&str]) {
    assert_refused(&body("[f64; 2]", text), messages, lower_text);
}

/// A whole block that is refused at the marks.
fn refused_block(text: &str, messages: &[&str]) {
    assert_refused(text, messages, lower_text);
}

#[test]
fn a_mistake_says_nothing_of_its_consequences() {
    let open = "how often this loop turns must be known when the macro runs; write `for i in 0..n` with a literal or a constant of \
                this block";
    refused("let (mut s, mut i) = (0.0, 0); «while» i < 2 { s += q[i]; i += 1; } 1.0 / s.sqrt() + q[i]", &[open]);
    refused("let mut a = [0.0, 0.0]; «loop» { a[0] = q[0]; } 1.0 / a[0]", &[open]);
    refused(
        "let mut s = 0.0; «match» 1 { _ => { s += 1.0 } } 1.0 / s",
        &["`match` cannot be differentiated; write `if … { … } else if … { … } else { … }`"],
    );
    refused(
        "if «let» [x, 0.0] = q { x } else { 0.0 }",
        &[
            "`if let` cannot be differentiated; choose by a comparison, `if x < 0.0 { … } else { … }`, and take arrays to pieces with `let [x, y] = q;`",
        ],
    );
    refused(
        "let Some(x) = q[0] «else» { return 0.0 }; x * x",
        &["`let … else` has no use in a formula; bind names, arrays and tuples of names"],
    );
    refused_block(
        "impl Law { #[potential] fn energy(&self, q: f64) -> f64 { «q[0]» * q[0] + q[1] } }",
        &["`q` is one number; write `q` without an index, or declare it as an array"],
    );
    refused_block(
        "impl<const D: usize> Law<D> { #[potential] fn energy(&self, q: «[f64; D]») -> f64 { (0..D).map(|i| q[i]).sum() } }",
        &[
            "the number of coordinates must be known when the macro runs; write it as a literal, `[f64; 3]`, or as a constant of this block whose value is a literal, `[f64; Self::D]`",
        ],
    );
}

/// A call that does not fit is the caller's mistake, and only the caller's body is kept from the compiler.
#[test]
fn a_mistake_is_in_one_method() {
    let methods = |law: &str| {
        let model = from_impl(TokenStream::new(), law.parse().unwrap()).model.unwrap_or_else(|_| panic!("{law}"));
        let Err(mistakes) = crate::lower::lower(&model) else { panic!("accepted: {law}") };
        mistakes.methods.into_iter().collect::<Vec<_>>()
    };
    let with = |call: &str, helper: &str| {
        format!(
            "impl Law {{ #[potential] fn energy(&self, q: f64) -> f64 {{ {call} }} fn help(&self, x: f64) -> f64 {{ {helper} }} }}"
        )
    };
    assert_eq!(methods(&with("self.help(q)", "x / 2")), ["help"]);
    assert_eq!(methods(&with("self.help(1)", "x")), ["energy"]);
    assert_eq!(methods(&with("self.help(q) + q / 2", "x.erf()")), ["energy", "help"]);
    assert_eq!(methods(&with("self.help(q)", "x;")), ["help"]);
}

/// A name that is nearly a known one.
#[test]
fn the_nearest_name_is_suggested() {
    for (body, suggestion) in [
        ("let radius = q[0]; raduis", "radius"),
        ("self.radus()", "radius"),
        ("q[0].tahn()", "tanh"),
        ("Self::MAS * q[0]", ""),
        ("Self::MASSS * q[0]", "Self::MASS"),
        ("q.iter().enumarate().map(|(_, x)| x).sum()", "enumerate"),
    ] {
        let law = format!(
            "impl Law {{ const MASS: f64 = 2.0; #[potential] fn energy(&self, q: [f64; 2]) -> f64 {{ {body} }} \
             fn radius(&self) -> f64 {{ 1.0 }} }}"
        );
        let said = said(lower_text(&law));
        assert_eq!(said.len(), 1, "{said:?}");
        let suggested = said[0].1.split_once("did you mean `").map_or("", |(_, rest)| rest.trim_end_matches("`?"));
        assert_eq!(suggested, suggestion, "{body}: {}", said[0].1);
    }
}
