//! The attribute stands on the struct in place of the block.
use dmech::prelude::*;

#[dmech::law]
#[derive(Clone, Copy)]
struct Kepler {
    gm: f64,
}

fn main() {
    let law = Kepler { gm: 1.0 };
    let _ = Simulation::new(law, State::new([0.5, 0.0], [0.0, 1.63])).scheme(Leapfrog).dt(0.01).run(10);
    println!("{} {}", law.gm, law.derivation());
}
