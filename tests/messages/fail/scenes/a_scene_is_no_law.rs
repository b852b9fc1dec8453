use dmech::models::pairs::Gravity;
use dmech::prelude::*;

fn main() {
    let scene = Scene::<2>::new().body(1.0, [0.0, 0.0], [0.0, 0.0]).body(0.1, [1.0, 0.0], [0.0, 1.0]);
    let start = State::new([1.0, 0.0], [0.0, 1.0]);
    let _ = Simulation::new(scene.pairs(Gravity { g: 1.0 }), start);
    let _ = Simulation::new(Gravity { g: 1.0 }, start);
}
