//! Writes random laws for the suite `laws`: they go through the real macro, and the generated code is held against the methods as
//! they stand there.

use std::fmt::Write;
use std::path::Path;

use dmech_laws::{COORDINATES, Law, PARAMETERS, Place, Random, Scale, pairs};

const LAWS: u64 = 60;
const SEED: u64 = 80_486;

/// One law: its type, its method, and the pairs of points with the scale of the secant identity.
fn written(k: u64, text: &mut String) -> std::fmt::Result {
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
            write!(points, "({a:?}, {b:?}, {:e}, {:e}), ", scale.error, scale.value_error[0])?;
        }
    }
    write!(
        text,
        "struct L{k} {{ k: f64, l: f64, n: f64 }}
#[dmech::law]
impl L{k} {{
    #[potential]
    fn energy(&self, q: [f64; {d}]) -> f64 {{
        let [{names}] = q;
        {}
    }}
}}
fn l{k}() -> usize {{
    let law = L{k} {{ k: {a:?}, l: {b:?}, n: {c:?} }};
    super::check({k}, &law, |q| law.energy(q), &[{points}])
}}
",
        law.tree
    )
}

fn main() -> std::io::Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
    let mut text = String::new();
    for k in 0..LAWS {
        written(k, &mut text).expect("a string takes all that is written");
    }
    let names: Vec<_> = (0..LAWS).map(|k| format!("l{k}")).collect();
    text.push_str(&format!("pub(super) const ALL: [fn() -> usize; {LAWS}] = [{}];\n", names.join(", ")));
    let folder = std::env::var_os("OUT_DIR").expect("cargo names a folder for what is written");
    std::fs::write(Path::new(&folder).join("random_laws.rs"), text)
}
