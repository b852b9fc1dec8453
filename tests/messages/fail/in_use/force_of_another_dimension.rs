//! Which of the two numbers of coordinates is meant is not known.
use dmech::prelude::*;
use dmech::verify;

#[derive(Clone, Copy)]
struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64, t: f64) -> f64 {
        m * t * q[1]
    }
    #[force]
    fn drag(&self, v: [f64; 3]) -> [f64; 3] {
        [-self.c * v[0], -self.c * v[1], 0.0]
    }
}

fn main() {
    let (law, start) = (Drag { c: 1.0 }, State::new([0.5, 0.0], [0.0, 1.63]));
    let _ = Simulation::new(law, start).scheme(Implicit).dt(0.01).run(10);
    println!("{:?}", law.force(start.q, start.v, 0.0));
    verify(law, start).assert();
}
