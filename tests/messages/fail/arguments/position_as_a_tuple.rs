//! Coordinates are an array.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, (x, y): (f64, f64)) -> f64 {
        -self.gm / x.hypot(y)
    }
}

fn main() {
    let _: Option<State<2>> = None;
    Kepler { gm: 1.0 }.energy((0.5, 0.0));
}
