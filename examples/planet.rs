//! The shortest program: declare a potential, run it, read the report.

use dmech::prelude::*;

/// A planet about a fixed sun, Φ(q) = −gm/|q|.
#[derive(Clone, Copy, Debug)]
struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        -self.gm / (x * x + y * y).sqrt()
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let start = State::new([0.5, 0.0], [0.0, 1.63]);
    let run = Simulation::new(Kepler { gm: 1.0 }, start).scheme(DiscreteGradient).dt(0.01).run_until(350.0)?;
    println!("{run}");
    Ok(())
}
