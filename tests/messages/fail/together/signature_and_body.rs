//! What is wrong with the arguments does not hide what is wrong with the formula.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&mut self, q: [f64; 2], v: f64) -> f32 {
        -self.gm / q[0].hypot(q[2])
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
