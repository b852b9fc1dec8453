//! Compensated leap-frog is not made for scenes.
use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Spring {
    k: f64,
}

#[dmech::law]
impl Spring {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        0.5 * self.k * r * r
    }
}

fn main() {
    let scene = Scene::new().body(1.0, [0.0, 0.0], [0.1, 0.0]).body(2.0, [1.0, 0.0], [0.0, 0.2]);
    let _ = Simulation::scene(scene.pairs(Spring { k: 0.7 })).scheme(CompensatedLeapfrog).dt(0.1).run(10);
}
