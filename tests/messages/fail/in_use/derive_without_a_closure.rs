//! The derive of a law whose potential is not stated.
use dmech::prelude::*;

#[derive(Clone, Copy, dmech::Law)]
#[potential(0.5 * self.k * q[0] * q[0])]
struct Spring {
    k: f64,
}

fn main() {
    let law = Spring { k: 1.0 };
    let _ = Simulation::new(law, State::new([0.5], [0.0])).scheme(Leapfrog).dt(0.01).run(10);
    println!("{} {:?}", law.k, law.gradient([0.5]));
}
