//! The helper attribute has one option.
use dmech::prelude::*;

#[derive(dmech::Law)]
#[dmech(krate = facade)]
#[potential(|q: f64| 0.5 * self.k * q * q)]
struct Spring {
    k: f64,
}

fn main() {
    Spring { k: 4.0 }.gradient([0.5]);
}
