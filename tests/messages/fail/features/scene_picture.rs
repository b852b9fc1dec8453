//! A picture of bodies, without the feature for it.
use dmech::{models::pairs::Gravity, prelude::*};

fn main() {
    let scene = Scene::new().body(1.0, [0.0, 0.0], [0.0, 0.0]).body(0.1, [1.0, 0.0], [0.0, 1.0]);
    let scene = scene.pairs(Gravity { g: 1.0 });
    let run = Simulation::scene(scene).scheme(Leapfrog).dt(0.01).run(100).unwrap();
    run.plot("bodies.svg").unwrap();
}
