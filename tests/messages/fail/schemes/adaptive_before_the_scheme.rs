//! What follows the motion is a scheme, which comes first.
use dmech::prelude::*;

#[derive(dmech::Law)]
#[potential(|q: f64| -q.cos())]
struct Pendulum;

fn main() {
    let pendulum = Simulation::new(Pendulum, State::new([0.8], [0.0]));
    let _ = pendulum.adaptive(1e-6).run_until(10.0);
}
