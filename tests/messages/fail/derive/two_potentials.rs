//! A law has one potential.
use dmech::prelude::*;

#[derive(dmech::Law)]
#[potential(|q: f64| 0.5 * self.k * q * q)]
#[potential(|q: f64| self.k * q)]
struct Spring {
    k: f64,
}

fn main() {
    Spring { k: 4.0 }.gradient([0.5]);
}
