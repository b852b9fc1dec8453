//! What becomes a parameter, under which name, read by which code.

use quote::ToTokens;

use super::{Read, Source, assert_same, body, laws, lower_derive, lower_text, points, value};

/// (name in formulas, code that reads it) of every parameter.
fn parameters(lowered: &super::Lowered) -> Vec<(String, String)> {
    let code = |source: &Source| match source {
        Source::Law(tokens) => tokens.to_token_stream().to_string().replace(' ', ""),
        Source::Mass => "mass".into(),
        Source::Time => "time".into(),
        Source::Body(body, Read::Mass) => format!("{body:?}: mass"),
        Source::Body(body, Read::Data(tokens)) => format!("{body:?}: {tokens}").replace(' ', ""),
    };
    lowered.parameters.iter().map(|p| (lowered.graph.name(p.symbol).to_owned(), code(&p.source))).collect()
}

fn assert_parameters(text: &str, expected: &[(&str, &str)]) {
    let lowered = lower_text(text).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
    let expected: Vec<_> = expected.iter().map(|&(name, code)| (name.to_owned(), code.to_owned())).collect();
    assert_eq!(parameters(&lowered), expected, "{text}");
}

#[test]
fn one_parameter_for_each_field_in_order_of_use() {
    let text = body("f64", "self.b * q + self.k[2] * q.sin() + self.b + self.spring.rate * q + self.0 + self.k[0]");
    assert_parameters(
        &text,
        &[
            ("law_b", "self.b"),
            ("k_2", "self.k[2]"),
            ("spring_rate", "self.spring.rate"),
            ("p0", "self.0"),
            ("k_0", "self.k[0]"),
        ]
        .map(|(name, code)| if name == "law_b" { ("b", code) } else { (name, code) }),
    );
}

#[test]
fn names_of_coordinates_are_not_taken_twice() {
    let text = body("[f64; 2]", "(q[0] - self.x) * self.m + q[1] * self.k_2 * self.k[2] * self.r#type");
    assert_parameters(
        &text,
        &[
            ("law_x", "self.x"),
            ("law_m", "self.m"),
            ("k_2", "self.k_2"),
            ("law_k_2", "self.k[2]"),
            ("type", "self.r#type"),
        ],
    );
    // Outside of the formulas each has the name that its author gave it.
    let lowered = lower_text(&text).unwrap();
    let names: Vec<_> = lowered.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
    assert_eq!(names, ["x", "m", "k_2", "k_2", "type"]);
}

#[test]
fn mass_and_time_only_where_they_count() {
    let text = "impl Law { #[potential] fn energy(&self, t: f64, q: f64, m: f64) -> f64 { m * q + t - t } }";
    assert_parameters(text, &[("m", "mass")]);
}

#[test]
fn constants_are_read_through_the_type() {
    let text = "impl Law<3> { const G: f64 = crate::G; const K: [f64; 2] = [1.0, 2.0];
        #[potential] fn energy(&self, q: f64) -> f64 { Self::G * q + Self::K.iter().sum::<f64>() * q * q } }";
    assert_parameters(text, &[("G", "<Law<3>>::G"), ("K_0", "<Law<3>>::K[0]"), ("K_1", "<Law<3>>::K[1]")]);
}

#[test]
fn integer_fields_are_cast() {
    assert_parameters(&body("f64", "self.n as f64 * q"), &[("n", "(self.nasf64)")]);
}

/// The derive sees the fields, so that it knows what each of them is.
#[test]
fn the_derive_knows_its_fields() {
    let lowered = lower_derive(
        "#[potential(|q: [f64; 2], t: f64| self.w.iter().zip(q).map(|(w, x)| w * x * x).sum::<f64>() * self.k + t)]
         struct Law { k: f64, w: [f64; 2] }",
    )
    .unwrap();
    let pairs: Vec<_> = points(2, true)
        .into_iter()
        .map(|q| {
            let source = |path: &str| match path {
                "self.k" => Some(1.3),
                "self.w[0]" => Some(0.7),
                "self.w[1]" => Some(-2.1),
                _ => None,
            };
            (value(&lowered, &q, 1.0, 0.6, &source), (0.7 * q[0] * q[0] - 2.1 * q[1] * q[1]) * 1.3 + 0.6)
        })
        .collect();
    assert_same("derive", &pairs);
}

laws! {
    fields_of_any_shape [k: f64 = 0.7, w: [f64; 2] = [0.3, 1.9], table: [[f64; 2]; 2] = [[0.1, 0.2], [0.3, 0.4]],
        pair: (f64, f64) = (1.1, 2.2), n: i32 = 3] ([f64; 2]; signed)
    {
        fn energy(&self, q: [f64; 2]) -> f64 {
            let Self { k, w, .. } = *self;
            let [a, b] = self.w;
            let (one, two) = self.pair;
            let table: [[f64; 2]; 2] = self.table;
            let mut scaled: [f64; 2] = w;
            scaled[1] *= 2.0;
            let mut sum = 0.0;
            for i in 0..2 {
                for j in 0..2 { sum += self.table[i][j] * q[i] * q[j]; }
                sum += w[i] * q[i] + scaled[i];
            }
            sum += if k > 0.5 { self.k } else { self.n as f64 };
            sum + a * q[0] * b + one * q[1] - two + table[1][0] + self.pair.1 * q[0] * k
        }
    }
}
