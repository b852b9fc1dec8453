//! A law that names the mass has one, and not one for each coordinate.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Fall {
    g: f64,
}

#[dmech::law]
impl Fall {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64) -> f64 {
        m * self.g * q[1]
    }
}

fn main() {
    let _ = Simulation::new(Fall { g: 9.81 }, State::new([0.0, 1.0], [0.3, 0.0])).masses([1.0, 2.0]);
}
