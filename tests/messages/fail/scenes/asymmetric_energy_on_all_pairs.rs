//! On all pairs there is no first body.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Fput {
    alpha: f64,
}

#[dmech::law]
impl Fput {
    #[pair]
    fn energy(&self, d: f64) -> f64 {
        0.5 * d * d + self.alpha * d.powi(3) / 3.0
    }
}

fn main() {
    let _ = Scene::new().body(1.0, [0.0], [0.1]).body(2.0, [1.0], [0.0]).pairs(Fput { alpha: 0.3 });
}
