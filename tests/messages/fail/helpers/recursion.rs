//! A formula has no recursion.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    fn power(x: f64, n: u32) -> f64 {
        if n == 0 { 1.0 } else { x * Self::power(x, n - 1) }
    }

    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / Self::power(q[0].hypot(q[1]), 3)
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
