//! What the macro writes, printed as a person would read it: one law of each structure, in `tests/golden`.
//!
//! `INSTA_UPDATE=always cargo test -p dmech-codegen --test golden` writes the files anew; read what it wrote.

use proc_macro2::{TokenStream, TokenTree};

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

/// Two charges: any number of dimensions, one root and one division.
const COULOMB: &str = "impl Coulomb {
    #[pair]
    fn energy(&self, r: f64, a: &Charge, b: &Charge) -> f64 {
        self.k * a.q * b.q / r
    }
}";

/// Even powers of the distance only: no root.
const LENNARD_JONES: &str = "impl LennardJones {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        let x = (self.sigma / r).powi(6);
        4.0 * self.epsilon * (x * x - x)
    }
}";

/// A force that is not reciprocal: all that is known of a law that has no potential.
const MOLECULAR: &str = "impl Molecular {
    #[pair_force]
    fn force(&self, d: [f64; 2], va: [f64; 2], ma: f64, mb: f64) -> [f64; 2] {
        let r = (d[0] * d[0] + d[1] * d[1]).sqrt();
        let speed = (va[0] * va[0] + va[1] * va[1]).sqrt();
        let f = ma * mb * (-self.g / r.powi(2) + self.h / r.powi(3) - self.alpha * speed) / r;
        [f * d[0], f * d[1]]
    }
}";

/// A wall, a force that saturates, a rope: choices of every kind.
const CONTACT: &str = "impl Contact {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        let wall = if x > 0.0 && y <= self.height { 0.5 * self.k * x * x } else { 0.0 };
        wall + self.friction * y.abs() + (self.pull * y).min(self.top)
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
fn coulomb() {
    assert_golden("coulomb", COULOMB);
}

#[test]
fn lennard_jones() {
    assert_golden("lennard_jones", LENNARD_JONES);
}

#[test]
fn molecular() {
    assert_golden("molecular", MOLECULAR);
}

#[test]
fn contact() {
    assert_golden("contact", CONTACT);
}

#[test]
fn the_same_law_expands_to_the_same_tokens() {
    for law in [KEPLER, OSCILLATOR, HENON_HEILES, BOTTLE, COULOMB, LENNARD_JONES, MOLECULAR, CONTACT] {
        let once = expansion(law).to_string();
        for _ in 0..5 {
            assert_eq!(expansion(law).to_string(), once);
        }
    }
}

/// The incremental compiler goes through a whole function once for every closure in it.
#[test]
fn nested_choices_are_not_closures() {
    let law = "impl Nested { #[potential] fn energy(&self, q: [f64; 3]) -> f64 {
        let [x, y, z] = q;
        if x + y < 1.0 { x * x + y * z } else if x * y + z < 2.0 { 0.5 * y * y + x * z * z } else { x * y * z }
    } }";
    let code = expansion(law).to_string();
    let [closures, choices] = ["R :: select (", "R :: either ("].map(|call| code.matches(call).count());
    assert!(choices > 500 && closures < 20, "{closures} choices in closures, {choices} in blocks");
}

/// The longest row of `let`s in one block, and how many there are.
fn lets(tokens: TokenStream) -> [usize; 2] {
    let (mut row, mut longest, mut all) = (0, 0, 0);
    for token in tokens {
        match token {
            TokenTree::Ident(name) if name == "let" => row += 1,
            TokenTree::Group(group) => {
                let [inside, of_them] = lets(group.stream());
                longest = longest.max(inside);
                all += of_them;
            }
            _ => {}
        }
    }
    [longest.max(row), all + row]
}

/// Scopes within scopes: with debug information the compiler goes down all of them, and 18 coordinates used up its stack.
#[test]
fn no_block_has_too_many_statements() {
    let law = "impl Cluster {
        #[potential]
        fn energy(&self, q: [f64; 18]) -> f64 {
            let mut sum = 0.0;
            for i in 0..6 {
                for j in 0..i {
                    let r2 = (0..3).map(|c| (q[3 * i + c] - q[3 * j + c]).powi(2)).sum::<f64>();
                    sum += self.k * (-r2.sqrt()).exp() / r2.sqrt();
                }
            }
            sum
        }
    }";
    let written = dmech_codegen::law(TokenStream::new(), law.parse().unwrap());
    let [longest, all] = lets(written);
    println!("{longest} of {all} in one block");
    assert!(all > 2000 && longest < 200, "{longest} of {all}");
}
