//! A remainder with Rust's sign is no periodic function.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.gm * (q[0] % 1.0)
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
