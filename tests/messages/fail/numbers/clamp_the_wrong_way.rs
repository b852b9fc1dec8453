//! Rust's `clamp` panics where the upper bound comes first.
use dmech::prelude::*;

struct Spring {
    k: f64,
}

#[dmech::law]
impl Spring {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        self.k * q * q.clamp(1.0, -1.0)
    }
}

fn main() {
    Spring { k: 4.0 }.gradient([0.5]);
}
