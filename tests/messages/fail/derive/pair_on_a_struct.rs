//! A law between two bodies has no short form.
use dmech::prelude::*;

#[derive(Clone, Copy, dmech::Law)]
#[pair(|r: f64| 0.5 * self.k * r * r)]
struct Spring {
    k: f64,
}

fn main() {
    let law = Spring { k: 1.0 };
    let scene = Scene::new().body(1.0, [0.5, 0.0], [0.0, 1.63]).body(1.0, [0.0, 0.0], [0.0, 0.0]);
    let _ = Simulation::scene(scene.pairs(law)).scheme(Leapfrog).dt(0.01).run(10);
    println!("{}", law.k);
}
