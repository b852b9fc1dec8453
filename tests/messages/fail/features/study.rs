//! A picture of a study, without the feature for it.
use dmech::{models::Pendulum, prelude::*};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let report = Study::new(Pendulum { k: 1.0 }, State::new([1.2], [0.0]), 30.0).scheme(Leapfrog).ladder([0.1]).run()?;
    report.plot("study.svg")?;
    report.plot_titled("study.svg", "A pendulum")?;
    Ok(())
}
