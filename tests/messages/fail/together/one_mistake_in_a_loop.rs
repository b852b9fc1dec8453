//! A mistake in a loop shows once, not once for each turn.
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
            sum += q[i].round_ties_even();
        }
        self.gm * sum
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
