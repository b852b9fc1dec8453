//! The stages of a composition have no velocity where leap-frog has none.
use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn drag(&self, v: [f64; 2]) -> [f64; 2] {
        [-self.c * v[0], -self.c * v[1]]
    }
}

fn main() {
    let start = State::new([0.5, 0.0], [0.0, 1.63]);
    let _ = Simulation::new(Drag { c: 1.0 }, start).scheme(Composed::order4(Leapfrog)).dt(0.01).run(10);
}
