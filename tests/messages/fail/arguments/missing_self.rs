//! Parameters are reached through `self`.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(q: [f64; 2]) -> f64 {
        -1.0 / q[0].hypot(q[1])
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
