//! Boris's scheme solves for a velocity in which the force is linear.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn drag(&self, v: [f64; 2]) -> [f64; 2] {
        let speed = (v[0] * v[0] + v[1] * v[1]).sqrt();
        [-self.c * speed * v[0], -self.c * speed * v[1]]
    }
}

fn main() {
    let start = State::new([0.5, 0.0], [0.0, 1.63]);
    let _ = Simulation::new(Drag { c: 1.0 }, start).scheme(Boris).dt(0.01).run(10);
}
