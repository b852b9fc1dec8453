//! A closure that is bound to a name.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let square = |x: f64| x * x;
        -self.gm / (square(q[0]) + square(q[1])).sqrt()
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
