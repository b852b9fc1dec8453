//! A law is the block of a type, not the type.
use dmech::prelude::*;

#[dmech::law]
struct Kepler {
    gm: f64,
}

fn main() {
    let _: Option<State<2>> = None;
    let _ = Kepler { gm: 1.0 }.gm;
}
