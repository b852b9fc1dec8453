//! A law between two bodies where each is alone.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Spring {
    k: f64,
}

#[dmech::law]
impl Spring {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        0.5 * self.k * (r - 1.0).powi(2)
    }
}

fn main() {
    let scene = Scene::new().body(1.0, [0.0, 0.0], [0.0, 0.0]).body(2.0, [1.0, 0.0], [0.0, 0.2]);
    let _ = scene.field(Spring { k: 0.7 });
}
