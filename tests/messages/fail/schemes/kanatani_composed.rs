//! A two-step scheme has no composition.
use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / q[0].hypot(q[1])
    }
}

fn main() {
    let start = State::new([0.5, 0.0], [0.0, 1.63]);
    let _ = Simulation::new(Kepler { gm: 1.0 }, start).scheme(Composed::order4(Kanatani)).dt(0.01).run(10);
}
