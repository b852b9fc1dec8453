//! A block that does not say what its method is may be meant for one body or for two.
use dmech::prelude::*;

#[derive(Clone, Copy)]
struct Spring {
    k: f64,
}

#[dmech::law]
impl Spring {
    fn energy(&self, r: f64) -> f64 {
        0.5 * self.k * r * r
    }
}

fn main() {
    let law = Spring { k: 1.0 };
    let _ = Simulation::new(law, State::new([0.5], [0.0])).scheme(DiscreteGradient).dt(0.01).run(10);
    let scene = Scene::new().body(1.0, [0.5, 0.0], [0.0, 1.63]).body(1.0, [0.0, 0.0], [0.0, 0.0]);
    let _ = Simulation::scene(scene.pairs(law).chain(law)).scheme(Kanatani).dt(0.01).run(10);
}
