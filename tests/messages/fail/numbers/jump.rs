//! Halves that are rounded to even numbers.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.gm * (q[0] - q[0].round_ties_even())
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
