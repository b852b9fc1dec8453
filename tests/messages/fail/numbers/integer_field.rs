//! Integers, and a reference, where numbers are needed.
use dmech::prelude::*;

struct Well<'a> {
    k: &'a f64,
    n: [i32; 2],
}

#[dmech::law]
impl Well<'_> {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        self.k * q.powf(self.n[1])
    }
}

fn main() {
    Well { k: &1.0, n: [2; 2] }.gradient([0.5]);
}
