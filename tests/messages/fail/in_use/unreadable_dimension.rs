//! A law whose number of coordinates cannot be read is still a law to all who use it.
use dmech::prelude::*;
use dmech::verify;

#[derive(Clone, Copy)]
struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: Vec<f64>) -> f64 {
        -self.gm / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

fn main() {
    let (law, start) = (Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 1.63]));
    let run = Simulation::new(law, start).masses([1.0, 2.0]).scheme(Leapfrog).dt(0.01).run(10).unwrap();
    println!("{:?} {:?} {}", run.last().q, law.gradient([1.0, 0.0]), law.derivation());
    verify(law, start).assert();
    let scene = Scene::new().body(1.0, [0.5, 0.0], [0.0, 1.63]).field(law);
    let _ = Simulation::scene(scene).scheme(Nystrom::order4()).dt(0.01).run(10);
}
