use dmech::models::pairs::Spring;
use dmech::prelude::*;

fn main() {
    let bodies = Scene::new().body(1.0, [0.0; 2], [0.0; 2]).body(1.0, [1.0; 2], [0.0; 2]);
    let _ = bodies.chain(Some(Spring { k: 1.0, length: 1.0 })).as_law::<2, 4>();
}
