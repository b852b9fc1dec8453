//! The short form sees the struct: it knows the parameters.
use dmech::prelude::*;

#[derive(dmech::Law)]
#[potential(|q: f64| 0.5 * self.stiffness * q * q)]
struct Spring {
    k: f64,
}

fn main() {
    Spring { k: 4.0 }.gradient([0.5]);
}
