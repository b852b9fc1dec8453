//! The traits of mechanics are implemented by the macro.
use dmech::prelude::*;

struct Planet {
    gm: f64,
}

trait Energy {
    fn energy(&self, q: [f64; 2]) -> f64;
}

#[dmech::law]
impl Energy for Planet {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / q[0].hypot(q[1])
    }
}

fn main() {
    Planet { gm: 1.0 }.gradient([0.5, 0.0]);
}
