//! How many coordinates a slice has is not known.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: &[f64]) -> f64 {
        -self.gm / q[0].hypot(q[1])
    }
}

fn main() {
    let _: Option<State<2>> = None;
    Kepler { gm: 1.0 }.energy(&[0.5, 0.0]);
}
