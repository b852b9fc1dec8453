//! Nor is what a free function computes.
use dmech::prelude::*;

fn radius(q: [f64; 2]) -> f64 {
    q[0].hypot(q[1])
}

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / radius(q)
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
