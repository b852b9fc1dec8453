//! What follows from a refused value is not reported.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let r = q[0].div_euclid(2.0);
        let s = r * r + q[1];
        let u = s.sqrt() / r;
        -self.gm * u
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
