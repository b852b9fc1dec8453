//! Ensembles in a database and over processes, without the features for them.
use dmech::{models::Kepler, prelude::*};

struct World;

fn main() {
    let start = || State::new([0.5, 0.0], [0.0, 1.63]);
    let planet = move || Simulation::new(Kepler { gm: 1.0 }, start()).scheme(Leapfrog).dt(0.02);
    let many = || Ensemble::of(10).law(|_| Kepler { gm: 1.0 }).start(move |_| start()).scheme(Leapfrog).dt(0.02);
    many().store("sweep.sqlite").run(100).unwrap();
    many().ranks(&World).run(100).unwrap();
    Ensemble::each(10, move |_| planet()).store("each.sqlite").run_until(3.0).unwrap();
    Ensemble::each(10, move |_| planet()).ranks(&World).run(100).unwrap();
}
