//! A force between two bodies that names neither where they are nor how they move.
use dmech::prelude::*;

struct Charge {
    q: f64,
}

#[derive(Clone, Copy)]
struct Coulomb {
    k: f64,
}

#[dmech::law]
impl Coulomb {
    #[pair_force]
    fn force(&self, a: &Charge, b: &Charge) -> [f64; 2] {
        [self.k * a.q * b.q, 0.0]
    }
}

fn main() {
    let (law, at_rest) = (Coulomb { k: 1.0 }, [0.0, 0.0]);
    let scene = Scene::new().body_with(1.0, [0.5, 0.0], at_rest, Charge { q: 1.0 });
    let scene = scene.body_with(1.0, [0.0, 0.0], at_rest, Charge { q: -1.0 });
    let _ = Simulation::scene(scene.pairs(law).bonds(law, [(0, 1)])).scheme(Leapfrog).dt(0.01).run(10);
    println!("{}", law.derivation());
}
