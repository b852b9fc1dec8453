//! The traits of mechanics are implemented by the macro.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

trait Energy {
    fn energy(&self, q: [f64; 2]) -> f64;
}

#[dmech::law]
impl Energy for Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / q[0].hypot(q[1])
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
