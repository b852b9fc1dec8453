//! The mistake is shown in the helper, once for all its calls.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    fn wall(&self, x: f64) -> f64 {
        0.5 * self.gm * x.gamma() * x
    }

    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.wall(q[0]) + self.wall(q[1])
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
