//! A vector is not a number.
use dmech::prelude::*;
use nalgebra::Vector2;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: Vector2<f64>) -> f64 {
        -self.gm / q
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
