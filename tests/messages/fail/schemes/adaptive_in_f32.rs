use dmech::{models::Kepler, prelude::*};

fn main() {
    let start = State::of([0.5_f32, 0.0], [0.0, 1.63]);
    let _ = Simulation::new(Kepler { gm: 1.0 }, start).scheme(DiscreteGradient).adaptive(1e-3).run_until(10.0);
}
