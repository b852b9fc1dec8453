use dmech::prelude::*;

#[derive(Clone, Copy, dmech::Law)]
#[potential(|q: [f64; 1]| -self.k * q[0].cos())]
struct Pendulum {
    k: f64,
}

fn main() {
    let pendulum = Simulation::new(Pendulum { k: 1.7 }, State::new([1.0], [0.0]));
    let _ = pendulum.scheme(Kanatani).adaptive(1e-6).run_until(10.0);
}
