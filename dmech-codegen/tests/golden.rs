//! What the macro writes, printed as a person would read it: one law of each structure, in `tests/golden`.
//!
//! `INSTA_UPDATE=always cargo test -p dmech-codegen --test golden` writes the files anew; read what it wrote.

use proc_macro2::TokenStream;

/// −gm/|q| in the plane: central, one scalar unknown.
const KEPLER: &str = "impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        -self.gm / (x * x + y * y).sqrt()
    }
}";

/// k|q|²/2 in the plane: linear, no iteration.
const OSCILLATOR: &str = "impl Oscillator {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        0.5 * self.k * (q[0] * q[0] + q[1] * q[1])
    }
}";

/// Hénon–Heiles: a full 2 × 2 Jacobian, Newton.
const HENON_HEILES: &str = "impl HenonHeiles {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        0.5 * (x * x + y * y) + self.lambda * (x * x * y - y.powi(3) / 3.0)
    }
}";

/// A magnetic field that grows with x beside a well: a force that does no work, in the middle of the step.
const BOTTLE: &str = "impl Bottle {
    #[potential]
    fn well(&self, q: [f64; 2]) -> f64 {
        0.25 * self.k * (q[0] * q[0] + 1.5 * q[1] * q[1]).powi(2)
    }
    #[force]
    fn lorentz(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        let b = self.b * (1.0 + q[0] / self.length);
        [b * v[1], -b * v[0]]
    }
}";

fn expansion(law: &str) -> TokenStream {
    dmech_codegen::law(TokenStream::new(), law.parse().unwrap())
}

fn assert_golden(name: &str, law: &str) {
    let written = prettyplease::unparse(&syn::parse2(expansion(law)).unwrap());
    insta::with_settings!({ snapshot_path => "golden", prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!(name, written);
    });
}

#[test]
fn kepler() {
    assert_golden("kepler", KEPLER);
}

#[test]
fn oscillator() {
    assert_golden("oscillator", OSCILLATOR);
}

#[test]
fn henon_heiles() {
    assert_golden("henon_heiles", HENON_HEILES);
}

#[test]
fn bottle() {
    assert_golden("bottle", BOTTLE);
}

#[test]
fn the_same_law_expands_to_the_same_tokens() {
    for law in [KEPLER, OSCILLATOR, HENON_HEILES, BOTTLE] {
        let once = expansion(law).to_string();
        for _ in 0..5 {
            assert_eq!(expansion(law).to_string(), once);
        }
    }
}
