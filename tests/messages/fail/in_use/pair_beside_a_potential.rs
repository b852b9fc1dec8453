//! What stands second is refused, and the law is used as that.
use dmech::prelude::*;

struct Spring<T> {
    k: f64,
    label: T,
}

#[dmech::law]
impl<T> Spring<T> {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.k * q[0] * q[0]
    }
    #[pair]
    fn between(&self, r: f64) -> f64 {
        self.k * r * r
    }
}

fn main() {
    let law = || Spring { k: 1.0, label: "spring" };
    println!("{}", law().label);
    let scene = Scene::new().body(1.0, [0.5, 0.0], [0.0, 1.63]).body(1.0, [0.0, 0.0], [0.0, 0.0]);
    let _ = Simulation::scene(scene.pairs(law()).field(law())).scheme(DiscreteGradient).dt(0.01).run(10);
}
