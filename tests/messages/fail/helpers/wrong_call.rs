//! A helper with `&self` called without it.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    fn attraction(&self, r: f64) -> f64 {
        -self.gm / r
    }

    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        Self::attraction(q[0].hypot(q[1]))
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
