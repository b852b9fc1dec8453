//! Loops run to their ends.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let mut sum = 0.0;
        for i in 0..2 {
            if q[i] < 0.0 {
                break;
            }
            sum += q[i];
        }
        self.gm * sum
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
