//! Slips that the compiler tells of itself: what uses the law is not told of them.
use dmech::prelude::*;

struct Spring {
    k: f64,
}

#[dmech::law]
impl Spring {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        let x = 0.5 * self.k * q *;
        x * q
    }
}

struct Drag {
    k: f64,
    c: f64,
}

#[dmech::law]
impl Drag {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        0.5 * self.k * q * q
    }

    #[force]
    fn drag(&self, v: f64) -> f64 {
        -self.c v
    }
}

fn main() {
    let _ = Simulation::new(Spring { k: 1.0 }, State::new([1.0], [0.0])).scheme(DiscreteGradient).dt(0.1).run(10);
    let _ = Spring { k: 1.0 }.gradient([0.5]);
    let drag = Drag { k: 1.0, c: 0.1 };
    let _ = Simulation::new(drag, State::new([1.0], [0.0])).scheme(Implicit).dt(0.1).run(10);
}
