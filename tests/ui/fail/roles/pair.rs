//! So do potentials of two bodies.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[pair]
    fn energy(&self, r: f64, ma: f64, mb: f64) -> f64 {
        -self.gm * ma * mb / r
    }
}

fn main() {
    let _: Option<State<2>> = None;
    Kepler { gm: 1.0 }.energy(1.0, 2.0, 3.0);
}
