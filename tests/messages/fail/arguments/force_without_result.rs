//! A force has components.
use dmech::prelude::*;

struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn drag(&self, v: [f64; 2]) {
        let _ = -self.c * v[0];
    }
}

fn main() {
    let _: Option<State<2>> = None;
    let _ = Drag { c: 0.1 }.c;
}
