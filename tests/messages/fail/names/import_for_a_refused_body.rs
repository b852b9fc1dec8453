//! An import that only a refused method uses is not unused.
#![deny(unused_imports)]
use dmech::prelude::*;
use std::f64::consts;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        consts::PI * q[0] / 2
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
