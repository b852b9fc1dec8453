//! The derive states a potential alone.
use dmech::prelude::*;

#[derive(Clone, Copy, dmech::Law)]
#[potential(|q: [f64; 1]| 0.5 * self.k * q[0] * q[0])]
#[force(|v: [f64; 1]| [-self.c * v[0]])]
struct Damped {
    k: f64,
    c: f64,
}

fn main() {
    let law = Damped { k: 1.0, c: 0.1 };
    let _ = Simulation::new(law, State::new([0.5], [0.0])).scheme(Implicit).dt(0.01).run(10);
    println!("{} {}", law.k, law.c);
}
