//! Laws between two bodies: what they read of each, and what their bodies are refused for.

use super::super::{Read, Source};
use super::{assert_refused, lower_text};

fn pair(arguments: &str, body: &str) -> String {
    format!(
        "impl Law {{ #[pair] fn energy(&self, {arguments}) -> f64 {{ {body} }} #[allow(x)] fn twice(x: &Charge) -> f64 {{ 2.0 * x.q }} }}"
    )
}

fn refused(arguments: &str, body: &str, message: &str) {
    assert_refused(&pair(arguments, body), &[message], lower_text);
}

/// The layout of the numbers of a body, and which parameters read them.
fn layout(arguments: &str, body: &str) -> (Vec<String>, Vec<String>) {
    let lowered = lower_text(&pair(arguments, body)).unwrap_or_else(|errors| panic!("{body}: {errors:?}"));
    let code = |read: &Read| match read {
        Read::Mass => "mass".to_owned(),
        Read::Data(tokens) => tokens.to_string().replace(' ', ""),
    };
    let own = |p: &super::super::Parameter| {
        matches!(p.source, Source::Body(..)).then(|| lowered.graph.name(p.symbol).to_owned())
    };
    let pair = lowered.pair.as_ref().expect("a law between two bodies");
    (pair.layout.iter().map(code).collect(), lowered.parameters.iter().filter_map(own).collect())
}

#[test]
fn both_bodies_have_the_layout_of_all_that_is_read() {
    let is = |(arguments, body): (&str, &str), reads: &[&str], names: &[&str]| {
        assert_eq!(layout(arguments, body), (to_owned(reads), to_owned(names)), "{body}");
    };
    fn to_owned(list: &[&str]) -> Vec<String> {
        list.iter().map(|&text| text.to_owned()).collect()
    }
    is(("r: f64", "self.k / r"), &[], &[]);
    is(("r: f64, ma: f64, mb: f64", "self.k * ma * mb / r"), &["mass"], &["ma", "mb"]);
    is(("r: f64, mb: f64", "self.k * mb / r"), &["mass"], &["mb"]);
    is(("r: f64, a: &Charge, b: &Charge", "a.q * b.q / r"), &["data.q"], &["a_q", "b_q"]);
    // The union of what is read of a and of b.
    is(
        ("r: f64, a: &Charge, b: &Charge", "a.q * b.shell.radii[1] / r"),
        &["data.q", "data.shell.radii[1]"],
        &["a_q", "b_shell_radii_1"],
    );
    // A field of the law of the same name keeps out of the way.
    is(("r: f64, a: &Charge, b: &Charge", "self.a_q * a.q * b.q / r"), &["data.q"], &["law_a_q", "b_q"]);
    // Only what the formula uses once it is simplified.
    is(
        ("r: f64, ma: f64, a: &Charge, b: &Charge", "let x = 0.0 * ma + a.p - a.p; x + a.q * b.q / r"),
        &["data.q"],
        &["a_q", "b_q"],
    );
    is(("r: f64, a: &Charge, b: &Charge", "Self::twice(a) * Self::twice(b) / r"), &["data.q"], &["a_q", "b_q"]);
    is(("r: f64, a: &f64, b: &f64", "*a * b / r"), &["*data"], &["a", "b"]);
    is(("r: f64, a: &[f64; 2], b: &[f64; 2]", "a[0] * b[1] / r"), &["data[0]", "data[1]"], &["a_0", "b_1"]);
    is(("r: f64, a: &Ion, b: &Ion", "(a.charge as f64) * r"), &["(data.chargeasf64)"], &["a_charge"]);
}

#[test]
fn bodies() {
    refused(
        "r: f64, a: &Charge",
        "«a» / r",
        "`a` is all the data of a body, and here a number is needed: name one of its fields of type `f64`, `a.q`",
    );
    refused(
        "r: f64, a: &Charge",
        "a.«strength»() / r",
        "`strength` is a method of the data, which the macro cannot see; read the fields themselves (`a.q`), or write a helper in this block that takes the numbers",
    );
    refused(
        "r: f64",
        "«ma» / r",
        "`ma` is not declared; for the mass of a, add `ma: f64` to the arguments of `energy`, for a parameter of the law write `self.ma`",
    );
    refused(
        "d: f64",
        "1.0 / «r» + d",
        "the distance `r` is the length of the separation `d`; name one of the two and compute the other from it",
    );
    refused(
        "d: f64",
        "d * «va»",
        "a pair potential does not depend on the velocity `va`; what depends on it is a `#[pair_force]`",
    );
    refused("r: f64", "r * «m»", "`m` belongs to a law of one body, and here there are two: write `ma` and `mb`");
    refused(
        "r: f64",
        "r * «q»",
        "`q` belongs to a law of one body, and here there are two: write the distance `r: f64`, or the separation `d: [f64; D]`, which is q_a − q_b",
    );
    refused(
        "r: f64, b: &Charge",
        "r * «a».q * b.q",
        "`a` is not declared; for the data of a, add `a: &Charge` to the arguments of `energy`, for a parameter of the law write `self.a`",
    );
}
