//! Nor that of a vector on the heap.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: Vec<f64>) -> f64 {
        -self.gm / q[0].hypot(q[1])
    }
}

fn main() {
    let _: Option<State<2>> = None;
    Kepler { gm: 1.0 }.energy(vec![0.5, 0.0]);
}
