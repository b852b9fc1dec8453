//! A variable needs a value on every way.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let well;
        if q[0] > 0.0 {
            well = q[0];
        }
        self.gm * well
    }
}

fn main() {
    Kepler { gm: 1.0 }.gradient([0.5, 0.0]);
}
