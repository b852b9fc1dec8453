//! How far the loop goes is read from the law.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
    n: usize,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let mut sum = 0.0;
        for i in 0..self.n {
            sum += q[i];
        }
        self.gm * sum
    }
}

fn main() {
    Kepler { gm: 1.0, n: 2 }.gradient([0.5, 0.0]);
}
