use dmech::{models::Kepler, prelude::*};

fn main() {
    let planet = Simulation::new(Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 1.63]));
    let _ = planet.scheme(Gauss::order16()).adaptive(1e-6).adaptive(1e-9).run_until(10.0);
}
