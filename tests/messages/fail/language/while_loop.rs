//! How often it turns is not known.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let mut sum = 0.0;
        let mut i = 0;
        while i < 2 {
            sum += q[i] * q[i];
            i += 1;
        }
        -self.gm / sum.sqrt()
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
