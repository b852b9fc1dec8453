//! Random laws through the real macro: a program with many of them is written, compiled and run, and the generated code held
//! against the methods as they stand in it.

use std::fmt::Write;
use std::path::Path;

use dmech_laws::{COORDINATES, Law, PARAMETERS, Place, Random, Scale, pairs};

const LAWS: u64 = 60;
const SEED: u64 = 80_486;

/// One law: its type, its method, and the pairs of points with the scale of the secant identity.
fn written(k: u64, text: &mut String) {
    let mut random = Random::member(SEED, k);
    let law = Law::random(&mut random);
    let d = law.dimension;
    let names = COORDINATES[..d].join(", ");
    let [a, b, c] = PARAMETERS;
    let mut points = String::new();
    for (place, a, b) in pairs(&law, &mut random) {
        let step: Vec<f64> = a.iter().zip(&b).map(|(a, b)| b - a).collect();
        let scale = Scale::of(&law.tree, &a, &b, &step);
        // Differences in binary64 tell nothing far out, nor beside what is not finite.
        if scale.is_finite() && place != Place::Far {
            write!(points, "({a:?}, {b:?}, {:e}, {:e}), ", scale.error, scale.value_error[0]).unwrap();
        }
    }
    write!(
        text,
        "pub struct L{k} {{ k: f64, l: f64, n: f64 }}
#[dmech::law]
impl L{k} {{
    #[potential]
    fn energy(&self, q: [f64; {d}]) -> f64 {{
        let [{names}] = q;
        {}
    }}
}}
pub fn l{k}() {{
    let law = L{k} {{ k: {a:?}, l: {b:?}, n: {c:?} }};
    super::check({k}, &law, |q| law.energy(q), &[{points}]);
}}
",
        law.tree
    )
    .unwrap();
}

#[test]
fn generated_code_agrees_with_the_users_methods() {
    let mut text = String::from(include_str!("random_laws/check.rs"));
    text.push_str("#[allow(warnings)]\n#[rustfmt::skip]\nmod laws {\nuse dmech::prelude::*;\n");
    (0..LAWS).for_each(|k| written(k, &mut text));
    text.push_str("}\n\nfn main() {\n");
    (0..LAWS).for_each(|k| writeln!(text, "    laws::l{k}();").unwrap());
    text.push_str("    finish();\n}\n");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("random_laws");
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("program.rs");
    std::fs::write(&path, text).unwrap();
    trybuild::TestCases::new().pass(path);
}
