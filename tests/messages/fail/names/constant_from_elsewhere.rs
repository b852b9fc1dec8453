//! The value of a constant from another module is not seen.
use dmech::prelude::*;

mod constants {
    pub const G: f64 = 6.674e-11;
}

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -constants::G * self.gm / q[0].hypot(q[1])
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
