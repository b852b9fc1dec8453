//! Pictures, without the feature for them.
use dmech::{models::Kepler, prelude::*};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let run = Simulation::new(Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 1.63])).scheme(Leapfrog).dt(0.01).run(100)?;
    run.plot("orbit.svg")?;
    run.plot_energy("energy.svg")?;
    run.plot_drift(Invariant::AngularMomentum, "momentum.svg")?;
    run.plot_drift_of("area", std::path::Path::new("area.svg"))?;
    Ok(())
}
