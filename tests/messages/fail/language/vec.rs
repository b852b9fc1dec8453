//! A formula does not allocate.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let terms = vec![q[0] * q[0], q[1] * q[1]];
        -self.gm / terms.iter().sum::<f64>().sqrt()
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
