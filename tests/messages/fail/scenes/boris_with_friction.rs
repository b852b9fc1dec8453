//! A friction between two bodies couples their velocities, where Boris's scheme has each by itself.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Friction {
    c: f64,
}

#[dmech::law]
impl Friction {
    #[pair_force]
    fn drag(&self, va: [f64; 2], vb: [f64; 2]) -> [f64; 2] {
        [-self.c * (va[0] - vb[0]), -self.c * (va[1] - vb[1])]
    }
}

fn main() {
    let scene = Scene::new().body(1.0, [0.0, 0.0], [0.1, 0.0]).body(2.0, [1.0, 0.0], [0.0, 0.2]);
    let _ = Simulation::scene(scene.pairs(Friction { c: 0.7 })).scheme(Boris).dt(0.1).run(10);
}
