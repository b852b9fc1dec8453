use dmech::models::Kepler;
use dmech::prelude::*;

fn main() {
    let planets = Ensemble::of(10).law(|_| Kepler { gm: 1.0 }).scheme(Leapfrog).dt(0.01);
    let _ = planets.run(10);
    let orbit = |_| State::new([1.0, 0.0], [0.0, 1.0]);
    let _ = Ensemble::of(10).start(orbit).scheme(Leapfrog).dt(0.01).run::<Kepler, 2>(10);
}
