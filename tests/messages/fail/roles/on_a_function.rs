//! A law is a block, not a function.
use dmech::prelude::*;

#[dmech::law]
fn energy(q: [f64; 2]) -> f64 {
    -1.0 / q[0].hypot(q[1])
}

fn main() {
    let _: Option<State<2>> = None;
    energy([0.5, 0.0]);
}
