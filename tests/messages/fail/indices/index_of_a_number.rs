//! One coordinate has no index.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        0.5 * self.gm * q[0] * q[0]
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5]);
}
