//! A bar, without the feature for it.
use dmech::{models::Kepler, prelude::*};

fn main() {
    let start = || State::new([0.5, 0.0], [0.0, 1.63]);
    let planet = || Simulation::new(Kepler { gm: 1.0 }, start()).scheme(Leapfrog).dt(0.02);
    planet().with_progress("a planet").run(100).unwrap();
    let many = Ensemble::of(10).law(|_| Kepler { gm: 1.0 }).start(move |_| start()).scheme(Leapfrog).dt(0.02);
    many.with_progress("planets").run(100).unwrap();
    Ensemble::each(10, |_| planet()).with_progress(String::from("planets")).run(100).unwrap();
}
