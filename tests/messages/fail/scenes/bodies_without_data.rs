//! The law reads a charge and the bodies carry none.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Charge {
    e: f64,
}

#[derive(Clone, Copy, Debug)]
struct Coulomb {
    k: f64,
}

#[dmech::law]
impl Coulomb {
    #[pair]
    fn energy(&self, r: f64, a: &Charge, b: &Charge) -> f64 {
        self.k * a.e * b.e / r
    }
}

fn main() {
    let scene = Scene::new().body(1.0, [0.0, 0.0], [0.0, 0.0]).body(2.0, [1.0, 0.0], [0.0, 0.2]);
    let _ = scene.pairs(Coulomb { k: 0.7 });
}
