//! The short form states the potential.
use dmech::prelude::*;

#[derive(dmech::Law)]
struct Spring {
    k: f64,
}

fn main() {
    let _: Option<State<2>> = None;
    let _ = Spring { k: 4.0 }.k;
}
