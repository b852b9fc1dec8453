//! Numbers have a decimal point.
use dmech::prelude::*;

#[derive(dmech::Law)]
#[potential(|q: f64| self.k * q * q / 2)]
struct Spring {
    k: f64,
}

fn main() {
    Spring { k: 4.0 }.gradient([0.5]);
}
