//! A law of one body between two.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Well {
    k: f64,
}

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.k * (q[0] * q[0] + q[1] * q[1]).powi(2)
    }
}

fn main() {
    let scene = Scene::new().body(1.0, [0.0, 0.0], [0.0, 0.0]).body(2.0, [1.0, 0.0], [0.0, 0.2]);
    let _ = scene.pairs(Well { k: 0.7 });
}
