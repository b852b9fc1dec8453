//! The type of the position says how many coordinates there are.
use dmech::prelude::*;

#[derive(dmech::Law)]
#[potential(|q| 0.5 * self.k * q * q)]
struct Spring {
    k: f64,
}

fn main() {
    let _: Option<State<2>> = None;
    let _ = Spring { k: 4.0 }.k;
}
