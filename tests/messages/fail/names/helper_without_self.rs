//! Helpers are called as methods.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    fn radius(q: [f64; 2]) -> f64 {
        q[0].hypot(q[1])
    }

    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / radius(q)
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
