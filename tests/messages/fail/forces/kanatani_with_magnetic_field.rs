//! Kanatani's scheme has none either, also where the force does no work.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Gyration {
    b: f64,
}

#[dmech::law]
impl Gyration {
    #[force]
    fn lorentz(&self, v: [f64; 2]) -> [f64; 2] {
        [self.b * v[1], -self.b * v[0]]
    }
}

fn main() {
    let particle = State::new([0.0, 0.0], [1.0, 0.0]);
    let _ = Simulation::new(Gyration { b: 2.0 }, particle).scheme(Kanatani).dt(0.1).run(10);
}
