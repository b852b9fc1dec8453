//! A law between two bodies as one that each has of its own, and a force by the velocity under leap-frog.

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

#[derive(Clone, Copy, Debug)]
struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn force(&self, v: [f64; 2]) -> [f64; 2] {
        [-self.c * v[0], -self.c * v[1]]
    }
}

fn main() {
    let bodies = || Scene::new().body_with(1.0, [0.0, 0.0], [0.0, 0.0], 0.3).body_with(2.0, [1.0, 0.0], [0.0, 0.2], 0.7);
    let _ = bodies().field_of(|_, &k| Spring { k });
    let _ = Simulation::scene(bodies().field_of(|_, &c| Drag { c })).scheme(Leapfrog).dt(0.1).run(1);
}
