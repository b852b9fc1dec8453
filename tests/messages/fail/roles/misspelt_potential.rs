//! The attribute of the role is misspelt: rustc names the attribute, the macro what is missing.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potental]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / q[0].hypot(q[1])
    }
}

fn main() {
    let _: Option<State<2>> = None;
    Kepler { gm: 1.0 }.energy([0.5, 0.0]);
}
