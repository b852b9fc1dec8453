//! A potential needs the position.
use dmech::prelude::*;

struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, t: f64) -> f64 {
        self.gm * t.cos()
    }
}

fn main() {
    let _: Option<State<2>> = None;
    Kepler { gm: 1.0 }.energy(0.0);
}
