//! A law in space between bodies of the plane.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Dipoles {
    k: f64,
}

#[dmech::law]
impl Dipoles {
    #[pair]
    fn energy(&self, d: [f64; 3]) -> f64 {
        let [x, y, z] = d;
        self.k * (x * x + y * y - 2.0 * z * z) / (x * x + y * y + z * z).powf(2.5)
    }
}

fn main() {
    let scene = Scene::new().body(1.0, [0.0, 0.0], [0.0, 0.0]).body(2.0, [1.0, 0.0], [0.0, 0.2]);
    let _ = scene.pairs(Dipoles { k: 0.7 });
}
