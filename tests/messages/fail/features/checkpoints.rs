//! Checkpoints, without the feature for them.
use dmech::{Checkpoint, models::Kepler, prelude::*};

fn main() -> Result<(), dmech::Error> {
    let planet = || {
        let start = State::new([0.5, 0.0], [0.0, 1.63]);
        Simulation::new(Kepler { gm: 1.0 }, start).scheme(Leapfrog).dt(0.02)
    };
    let mut first = planet().stepper()?;
    first.advance(400)?;
    let saved: Checkpoint = first.checkpoint();
    let mut second = planet().resume(&saved)?;
    second.advance(600)?;
    let unnamed = first.checkpoint();
    planet().resume(&unnamed)?.advance(1)
}
