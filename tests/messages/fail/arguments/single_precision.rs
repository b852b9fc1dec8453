//! The law is written in f64 and run in any scalar.
use dmech::prelude::*;

struct Kepler {
    gm: f32,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f32; 2]) -> f32 {
        -self.gm / q[0].hypot(q[1])
    }
}

fn main() {
    let _: Option<State<2>> = None;
    Kepler { gm: 1.0 }.energy([0.5, 0.0]);
}
